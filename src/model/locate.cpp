#include "model/locate.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace ashlar {

namespace {

constexpr double inside_tolerance = 1e-7;  // of the parametric coordinates

/// Shape functions and their derivatives [corner][axis] at parametric coordinates; hex8 in (-1,1), others in (0,1),
/// (0,1), (-1,1) or (0,1).
void shape_functions(Shape shape, const Eigen::Vector3d& r, Eigen::VectorXd& n, Eigen::MatrixXd& d) {
  const int corners = corner_count(shape);
  n.resize(corners);
  d.resize(corners, 3);
  if (shape == Shape::hex8) {
    static const int sign[8][3] = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                                   {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};
    for (int k = 0; k < 8; ++k) {
      const double a = 1 + sign[k][0] * r[0], b = 1 + sign[k][1] * r[1], c = 1 + sign[k][2] * r[2];
      n[k] = a * b * c / 8;
      d.row(k) << sign[k][0] * b * c / 8, sign[k][1] * a * c / 8, sign[k][2] * a * b / 8;
    }
  } else if (shape == Shape::wedge6) {
    const double l[3] = {1 - r[0] - r[1], r[0], r[1]};
    const double dl[3][2] = {{-1, -1}, {1, 0}, {0, 1}};
    for (int k = 0; k < 6; ++k) {
      const double z = (1 + (k < 3 ? -1 : 1) * r[2]) / 2;
      n[k] = l[k % 3] * z;
      d.row(k) << dl[k % 3][0] * z, dl[k % 3][1] * z, (k < 3 ? -0.5 : 0.5) * l[k % 3];
    }
  } else {
    n << 1 - r[0] - r[1] - r[2], r[0], r[1], r[2];
    d << -1, -1, -1, 1, 0, 0, 0, 1, 0, 0, 0, 1;
  }
}

std::optional<std::vector<double>> weights_at(const Mesh& mesh, int element, const Vec3<double>& point) {
  const Shape shape = mesh.shapes[element];
  const auto nodes = mesh.element(element);
  Eigen::Vector3d r(shape == Shape::hex8 ? 0 : 0.25, shape == Shape::hex8 ? 0 : 0.25, shape == Shape::tet4 ? 0.25 : 0);
  Eigen::VectorXd n;
  Eigen::MatrixXd d;
  for (int iteration = 0; iteration < 30; ++iteration) {
    shape_functions(shape, r, n, d);
    Eigen::Vector3d gap(point.x, point.y, point.z);
    Eigen::Matrix3d jacobian = Eigen::Matrix3d::Zero();
    for (int k = 0; k < static_cast<int>(nodes.size()); ++k) {
      const Eigen::Vector3d x(mesh.points[nodes[k]].x, mesh.points[nodes[k]].y, mesh.points[nodes[k]].z);
      gap -= n[k] * x;
      jacobian += x * d.row(k);
    }
    const Eigen::Vector3d step = jacobian.fullPivLu().solve(gap);
    r += step;
    if (!r.allFinite() || r.norm() > 10) return {};
    if (step.norm() < 1e-12) break;
  }
  shape_functions(shape, r, n, d);
  if (n.minCoeff() < -inside_tolerance) return {};
  return std::vector<double>(n.data(), n.data() + n.size());
}

}  // namespace

std::optional<Location> locate(const Mesh& mesh, const Vec3<double>& point) {
  for (int e = 0; e < mesh.element_count(); ++e) {
    Vec3<double> low = mesh.points[mesh.element(e)[0]], high = low;
    for (const int n : mesh.element(e))
      for (int i = 0; i < 3; ++i) {
        low[i] = std::min(low[i], mesh.points[n][i]);
        high[i] = std::max(high[i], mesh.points[n][i]);
      }
    const double slack = inside_tolerance * norm(high - low);
    bool near = true;
    for (int i = 0; i < 3; ++i) near = near && point[i] >= low[i] - slack && point[i] <= high[i] + slack;
    if (!near) continue;
    const auto weights = weights_at(mesh, e, point);
    if (!weights) continue;
    Location found{e, *weights, -1};
    for (std::size_t k = 0; k < weights->size(); ++k)
      if ((*weights)[k] > 1 - inside_tolerance) found.node = mesh.element(e)[k];
    return found;
  }
  return {};
}

int nearest_node(const Mesh& mesh, const Vec3<double>& point) {
  int best = 0;
  for (int n = 1; n < mesh.node_count(); ++n)
    if (norm(mesh.points[n] - point) < norm(mesh.points[best] - point)) best = n;
  return best;
}

std::optional<NodeInside> node_inside(const Mesh& mesh, const std::vector<int>& touching) {
  constexpr double depth = 1e-3;  // of shape functions
  std::vector<int> region(mesh.points.size());
  for (int e = 0; e < mesh.element_count(); ++e)
    for (const int n : mesh.element(e)) region[n] = mesh.regions[e];
  std::vector<int> by_x(mesh.points.size());
  std::iota(by_x.begin(), by_x.end(), 0);
  std::sort(by_x.begin(), by_x.end(), [&](int a, int b) { return mesh.points[a].x < mesh.points[b].x; });
  for (int e = 0; e < mesh.element_count(); ++e) {
    const auto corners = mesh.element(e);
    Vec3<double> low = mesh.points[corners[0]], high = low;
    for (const int n : corners)
      for (int i = 0; i < 3; ++i) {
        low[i] = std::min(low[i], mesh.points[n][i]);
        high[i] = std::max(high[i], mesh.points[n][i]);
      }
    auto at = std::upper_bound(by_x.begin(), by_x.end(), low.x, [&](double x, int n) { return x < mesh.points[n].x; });
    for (; at != by_x.end() && mesh.points[*at].x < high.x; ++at) {
      const Vec3<double>& p = mesh.points[*at];
      if (p.y <= low.y || p.y >= high.y || p.z <= low.z || p.z >= high.z) continue;
      if (touching[region[*at] * mesh.region_names.size() + mesh.regions[e]] < 0) continue;
      if (std::find(corners.begin(), corners.end(), *at) != corners.end()) continue;
      const auto weights = weights_at(mesh, e, p);
      if (weights && *std::min_element(weights->begin(), weights->end()) > depth) return NodeInside{*at, e};
    }
  }
  return {};
}

}  // namespace ashlar
