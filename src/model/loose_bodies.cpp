#include "model/loose_bodies.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <numeric>

#include "model/conditions.hpp"

namespace ashlar {
namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

/// Body of every block, numbered by first block: blocks that share an interface face are one body.
std::vector<int> bodies_of_blocks(const Blocks& blocks) {
  std::vector<int> head(blocks.block_count);
  std::iota(head.begin(), head.end(), 0);
  const auto find = [&](int b) {
    while (head[b] != b) b = head[b] = head[head[b]];
    return b;
  };
  for (const auto& face : blocks.faces) {
    const int a = find(blocks.block_of_element[face.a.element]), b = find(blocks.block_of_element[face.b.element]);
    head[std::max(a, b)] = std::min(a, b);
  }
  std::vector<int> body(head.size());
  int count = 0;
  for (int b = 0; b < blocks.block_count; ++b) body[b] = find(b) == b ? count++ : body[find(b)];
  return body;
}

struct Body {
  std::vector<char> has_region;
  Vec3<double> centre;  ///< mean of corners, m
  double size = 0;      ///< largest distance of a corner from the centre, m
  long corners = 0;
  Matrix6 held = Matrix6::Zero();  ///< sum over held components of the outer product of its six rigid movements
};

/// Displacement along `direction` at p of a unit shift along each axis and a turn about each axis through the centre,
/// turns scaled to a unit movement at the body's edge.
Vector6 rigid_movements(const Body& body, const Vec3<double>& p, const Vec3<double>& direction) {
  const Vec3<double> arm = (1 / body.size) * (p - body.centre);
  const Vec3<double> turn = cross(arm, direction);
  Vector6 row;
  row << direction.x, direction.y, direction.z, turn.x, turn.y, turn.z;
  return row;
}

std::string describe(const Vector6& free) {
  const char* names[] = {"along x", "along y", "along z", "about the x axis", "about the y axis", "about the z axis"};
  int largest = 0;
  for (int i = 1; i < 6; ++i)
    if (std::abs(free[i]) > std::abs(free[largest]) + 1e-9) largest = i;
  return names[largest];
}

}  // namespace

std::vector<LooseBody> loose_bodies(const Model& model, const Blocks& blocks, int stage) {
  const Mesh& mesh = model.mesh;
  const auto body_of_block = bodies_of_blocks(blocks);
  const auto body_of = [&](int element) { return body_of_block[blocks.block_of_element[element]]; };
  std::vector<Body> bodies(blocks.block_count ? *std::max_element(body_of_block.begin(), body_of_block.end()) + 1 : 0);
  const auto each_corner = [&](auto&& visit) {
    for (int e = 0; e < mesh.element_count(); ++e)
      for (int n : mesh.element(e)) visit(bodies[body_of(e)], mesh.points[n]);
  };
  each_corner([](Body& b, const Vec3<double>& p) { b.centre = b.centre + p, ++b.corners; });
  for (auto& b : bodies) b.centre = (1.0 / static_cast<double>(b.corners)) * b.centre;
  each_corner([](Body& b, const Vec3<double>& p) { b.size = std::max(b.size, norm(p - b.centre)); });
  for (int e = 0; e < mesh.element_count(); ++e) {
    auto& has = bodies[body_of(e)].has_region;
    has.resize(mesh.region_names.size(), 0);
    has[mesh.regions[e]] = 1;
  }

  const Vec3<double> axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (const auto& acting : acting_conditions(model, stage)) {
    bool along[3] = {}, normal = false;
    if (const auto* fix = std::get_if<Fix>(&acting.condition->kind)) {
      along[0] = fix->x, along[1] = fix->y, along[2] = fix->z;
      normal = fix->normal;
    } else if (const auto* moved = std::get_if<Displacement>(&acting.condition->kind)) {
      along[0] = moved->x.has_value(), along[1] = moved->y.has_value(), along[2] = moved->z.has_value();
    } else {
      continue;
    }
    for (const Surface* surface : acting.surfaces)
      for (const Facet& facet : surface->facets) {
        Body& body = bodies[body_of(facet.element)];
        const auto hold = [&](const Vec3<double>& direction) {
          for (int n : mesh.facet_nodes(facet)) {
            if (!holds_at(*acting.condition, mesh.points[n])) continue;
            const Vector6 row = rigid_movements(body, mesh.points[n], direction);
            body.held += row * row.transpose();
          }
        };
        for (int i = 0; i < 3; ++i)
          if (along[i]) hold(axes[i]);
        if (normal) {
          const Vec3<double> area = mesh.facet_area(facet);
          hold((1 / norm(area)) * area);
        }
      }
  }

  std::vector<LooseBody> loose;
  for (const Body& body : bodies) {
    const Eigen::SelfAdjointEigenSolver<Matrix6> modes(body.held);
    // Squared ratio of a support's lever arm to the body's size, below which it counts as none.
    const double least = 1e-10 * modes.eigenvalues()[5];
    if (modes.eigenvalues()[0] > least && modes.eigenvalues()[5] > 0) continue;
    LooseBody found;
    for (std::size_t r = 0; r < body.has_region.size(); ++r)
      if (body.has_region[r]) found.regions.push_back(mesh.region_names[r]);
    found.movement = modes.eigenvalues()[5] > 0 ? describe(modes.eigenvectors().col(0)) : "in any direction";
    loose.push_back(found);
  }
  return loose;
}

}  // namespace ashlar
