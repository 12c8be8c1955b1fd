#include "solve/support.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <numeric>

namespace ashlar {

namespace {

/// Whether held components keep a body from every rigid movement: their rows (direction, moment arm) have rank six.
bool holds_a_rigid_body(const std::vector<Vec3<double>>& points, const std::vector<unsigned>& held) {
  Vec3<double> low = points[0], high = points[0];
  for (const auto& p : points)
    for (int i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], p[i]);
      high[i] = std::max(high[i], p[i]);
    }
  const Vec3<double> centre = 0.5 * (low + high);
  const double size = norm(high - low);
  Eigen::Matrix<double, 6, 6> gram = Eigen::Matrix<double, 6, 6>::Zero();
  for (std::size_t n = 0; n < points.size(); ++n)
    for (int i = 0; i < 3; ++i) {
      if (!((held[n] >> i) & 1u)) continue;
      Vec3<double> direction;
      direction[i] = 1;
      const Vec3<double> arm = cross((1 / size) * (points[n] - centre), direction);
      Eigen::Matrix<double, 6, 1> row;
      row << direction.x, direction.y, direction.z, arm.x, arm.y, arm.z;
      gram += row * row.transpose();
    }
  const auto values =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>>(gram, Eigen::EigenvaluesOnly).eigenvalues();
  return values[0] > 1e-9 * values[5];
}

}  // namespace

std::vector<FreeBody> free_bodies(const Problem& problem, const std::vector<ContactPoint>& contacts) {
  const Mesh& mesh = problem.model.mesh;
  const Blocks& blocks = problem.blocks;
  const auto fixed = problem.backend->read(Field::fixed);
  std::vector<int> block_of_node(blocks.node_count(), -1);
  for (int e = 0; e < mesh.element_count(); ++e)
    for (int c = mesh.first_corner[e]; c < mesh.first_corner[e + 1]; ++c)
      block_of_node[blocks.corners[c]] = blocks.block_of_element[e];

  std::vector<int> body(blocks.block_count);
  std::iota(body.begin(), body.end(), 0);
  const auto find = [&](int b) {
    while (body[b] != b) b = body[b] = body[body[b]];
    return b;
  };
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    if (!contacts[c].joined()) continue;
    const int a = find(block_of_node[problem.contacts.node_a[c]]), b = find(block_of_node[problem.contacts.node_b[c]]);
    body[std::max(a, b)] = std::min(a, b);
  }

  std::vector<std::vector<int>> nodes_of(blocks.block_count);
  for (int n = 0; n < blocks.node_count(); ++n)
    if (block_of_node[n] >= 0) nodes_of[find(block_of_node[n])].push_back(problem.discretisation.blocks.new_node[n]);

  std::vector<FreeBody> free;
  for (int b = 0; b < blocks.block_count; ++b) {
    if (find(b) != b) continue;
    std::vector<int>& nodes = nodes_of[b];
    std::vector<Vec3<double>> points;
    std::vector<unsigned> held;
    for (const int n : nodes) {
      points.push_back(problem.discretisation.block_points[n]);
      held.push_back(static_cast<unsigned>(fixed[n]));
    }
    if (holds_a_rigid_body(points, held)) continue;
    FreeBody floating;
    for (int other = 0; other < blocks.block_count; ++other)
      if (find(other) == b) floating.blocks.push_back(other);
    std::sort(nodes.begin(), nodes.end());
    floating.nodes = std::move(nodes);
    free.push_back(std::move(floating));
  }
  return free;
}

}  // namespace ashlar
