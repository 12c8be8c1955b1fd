#include "solve/support.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <numeric>

namespace ashlar {

namespace {

using Row = Eigen::Matrix<double, 6, 1>;

/// What held components do to the six rigid movements of a body: an orthonormal basis of those that they stop.
class StoppedMovements {
 public:
  explicit StoppedMovements(const std::vector<Vec3<double>>& points) {
    Vec3<double> low = points[0], high = points[0];
    for (const auto& p : points)
      for (int i = 0; i < 3; ++i) {
        low[i] = std::min(low[i], p[i]);
        high[i] = std::max(high[i], p[i]);
      }
    centre_ = 0.5 * (low + high);
    size_ = norm(high - low);
  }
  /// Part of the movement stopped by holding `axis` at `point` that nothing has stopped yet.
  Row still_free(const Vec3<double>& point, int axis) const {
    Vec3<double> direction;
    direction[axis] = 1;
    const Vec3<double> arm = cross((2 / size_) * (point - centre_), direction);
    Row row;
    row << direction.x, direction.y, direction.z, arm.x, arm.y, arm.z;
    for (int k = 0; k < count_; ++k) row -= row.dot(basis_[k]) * basis_[k];
    return row;
  }
  bool all() const { return count_ == 6; }
  /// Held bits 0 1 2: x y z of a point.
  void hold(const Vec3<double>& point, unsigned bits) {
    constexpr double negligible = 1e-4;  // of a unit movement
    for (int axis = 0; axis < 3 && !all(); ++axis) {
      if (!((bits >> axis) & 1u)) continue;
      const Row row = still_free(point, axis);
      if (row.norm() > negligible) stop(row);
    }
  }
  void stop(const Row& row) { basis_[count_++] = row.normalized(); }

 private:
  Vec3<double> centre_;
  double size_ = 0;
  Row basis_[6];
  int count_ = 0;
};

/// Components that have to be held beside the held ones to stop every rigid movement, as few as that takes and each the
/// one that stops most of what is still free. `held` bits 0 1 2: x y z. As pairs of index into points and axis.
std::vector<std::pair<int, int>> missing_supports(const std::vector<Vec3<double>>& points,
                                                  const std::vector<unsigned>& held) {
  StoppedMovements stopped(points);
  for (std::size_t n = 0; n < points.size() && !stopped.all(); ++n) stopped.hold(points[n], held[n]);
  std::vector<std::pair<int, int>> supports;
  while (!stopped.all()) {
    Row most = Row::Zero();
    std::pair<int, int> best;
    for (std::size_t n = 0; n < points.size(); ++n)
      for (int axis = 0; axis < 3; ++axis) {
        const Row row = stopped.still_free(points[n], axis);
        if (row.norm() <= most.norm() * (1 + 1e-9)) continue;
        most = row;
        best = {static_cast<int>(n), axis};
      }
    stopped.stop(most);
    supports.push_back(best);
  }
  return supports;
}

/// Whether everything as one body is held, as the first held nodes mostly tell.
bool all_held(const Problem& problem, const std::vector<double>& fixed) {
  StoppedMovements stopped(problem.discretisation.block_points);
  for (std::size_t n = 0; n < fixed.size() && !stopped.all(); ++n)
    stopped.hold(problem.discretisation.block_points[n], static_cast<unsigned>(fixed[n]));
  return stopped.all();
}

}  // namespace

std::vector<FreeBody> free_bodies(const Problem& problem) {
  const Mesh& mesh = problem.model.mesh;
  const Blocks& blocks = problem.blocks;
  const auto fixed = problem.backend->read(Field::fixed), joined = problem.backend->read(Field::joined);

  std::vector<int> body(blocks.block_count);  // another block of the same body, at last its first
  std::iota(body.begin(), body.end(), 0);
  const auto find = [&](int b) {
    while (body[b] != b) b = body[b] = body[body[b]];
    return b;
  };
  int bodies = blocks.block_count, last_face = -1;  // contact points of a face follow each other
  for (std::size_t c = 0; c < joined.size(); ++c) {
    if (joined[c] == 0 || problem.contacts.face[c] == last_face) continue;
    last_face = problem.contacts.face[c];
    const InterfaceFace& face = blocks.faces[last_face];
    const int a = find(blocks.block_of_element[face.a.element]), b = find(blocks.block_of_element[face.b.element]);
    bodies -= a != b;
    body[std::max(a, b)] = std::min(a, b);
  }
  if (bodies == 1 && all_held(problem, fixed)) return {};
  for (int b = 0; b < blocks.block_count; ++b) body[b] = find(b);

  // Nodes by body, in the machine's numbering.
  std::vector<int> body_of_node(blocks.node_count(), -1), first(blocks.block_count + 1);
  for (int e = 0; e < mesh.element_count(); ++e)
    for (int c = mesh.first_corner[e]; c < mesh.first_corner[e + 1]; ++c)
      body_of_node[problem.discretisation.blocks.new_node[blocks.corners[c]]] = body[blocks.block_of_element[e]];
  for (const int b : body_of_node)
    if (b >= 0) ++first[b + 1];
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<int> node(first.back()), next = first;
  for (int n = 0; n < blocks.node_count(); ++n)
    if (body_of_node[n] >= 0) node[next[body_of_node[n]]++] = n;

  std::vector<FreeBody> free;
  for (int b = 0; b < blocks.block_count; ++b) {
    if (body[b] != b) continue;
    std::vector<Vec3<double>> points;
    std::vector<unsigned> held;
    for (int i = first[b]; i < first[b + 1]; ++i) {
      points.push_back(problem.discretisation.block_points[node[i]]);
      held.push_back(static_cast<unsigned>(fixed[node[i]]));
    }
    const auto missing = missing_supports(points, held);
    if (missing.empty()) continue;
    FreeBody floating;
    floating.nodes.assign(node.begin() + first[b], node.begin() + first[b + 1]);
    for (const auto& [n, axis] : missing) floating.supports.push_back(3 * floating.nodes[n] + axis);
    for (int other = b; other < blocks.block_count; ++other)
      if (body[other] == b) floating.blocks.push_back(other);
    free.push_back(std::move(floating));
  }
  return free;
}

}  // namespace ashlar
