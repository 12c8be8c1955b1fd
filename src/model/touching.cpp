#include "model/touching.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace ashlar {

namespace {

/// Facets by the cubes of space that their bounding boxes meet.
class FacetCubes {
 public:
  FacetCubes(const Mesh& mesh, const std::vector<Facet>& facets)
      : mesh_(mesh), facets_(facets), tolerance_(1e-6 * mesh.extent()) {
    low_ = mesh.points[0];
    for (const auto& p : mesh.points)
      for (int a = 0; a < 3; ++a) low_[a] = std::min(low_[a], p[a]);
    double diameters = 0;
    for (const auto& f : facets) diameters += std::sqrt(norm(mesh.facet_area(f)));
    edge_ = std::max(2 * diameters / static_cast<double>(facets.size()), 1e-5 * mesh.extent());
    for (int f = 0; f < static_cast<int>(facets.size()); ++f) {
      const auto nodes = mesh.facet_nodes(facets[f]);
      auto from = cell(mesh.points[nodes[0]], -tolerance_), to = cell(mesh.points[nodes[0]], tolerance_);
      for (const int n : nodes)
        for (int a = 0; a < 3; ++a) {
          from[a] = std::min(from[a], cell(mesh.points[n], -tolerance_)[a]);
          to[a] = std::max(to[a], cell(mesh.points[n], tolerance_)[a]);
        }
      for (auto x = from[0]; x <= to[0]; ++x)
        for (auto y = from[1]; y <= to[1]; ++y)
          for (auto z = from[2]; z <= to[2]; ++z) sorted_.push_back({key({x, y, z}), f});
    }
    std::sort(sorted_.begin(), sorted_.end());
  }

  /// The first facet that looks against `facet` and holds its centroid; -1 if none does.
  int facing(int facet) const {
    const auto centre = mesh_.facet_centroid(facets_[facet]);
    const auto area = mesh_.facet_area(facets_[facet]);
    const auto wanted = key(cell(centre, 0));
    for (auto at = std::lower_bound(sorted_.begin(), sorted_.end(), std::pair{wanted, 0});
         at != sorted_.end() && at->first == wanted; ++at) {
      const auto other = mesh_.facet_area(facets_[at->second]);
      if (dot(area, other) < -0.99 * norm(area) * norm(other) && holds(at->second, centre)) return at->second;
    }
    return -1;
  }

 private:
  using Cell = std::array<std::uint64_t, 3>;
  Cell cell(const Vec3<double>& p, double shift) const {
    Cell c;
    for (int a = 0; a < 3; ++a) c[a] = static_cast<std::uint64_t>(std::max(0.0, (p[a] + shift - low_[a]) / edge_));
    return c;
  }
  static std::uint64_t key(const Cell& c) { return c[0] << 42 | c[1] << 21 | c[2]; }

  bool holds(int facet, const Vec3<double>& p) const {
    const auto nodes = mesh_.facet_nodes(facets_[facet]);
    const auto area = mesh_.facet_area(facets_[facet]);
    const auto normal = (1 / norm(area)) * area;
    if (std::abs(dot(p - mesh_.facet_centroid(facets_[facet]), normal)) > tolerance_) return false;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const auto &a = mesh_.points[nodes[i]], &b = mesh_.points[nodes[(i + 1) % nodes.size()]];
      if (dot(cross(b - a, p - a), normal) < tolerance_ * norm(b - a)) return false;
    }
    return true;
  }

  const Mesh& mesh_;
  const std::vector<Facet>& facets_;
  double tolerance_;  ///< m
  Vec3<double> low_;
  double edge_ = 1;  ///< of a cube, m
  std::vector<std::pair<std::uint64_t, int>> sorted_;
};

}  // namespace

std::vector<FacePair> find_touching(const Mesh& mesh, const FaceGraph& faces) {
  std::vector<FacePair> touching;
  if (faces.outer.empty()) return touching;
  const FacetCubes cubes(mesh, faces.outer);
  for (int f = 0; f < static_cast<int>(faces.outer.size()); ++f)
    if (const int other = cubes.facing(f); other >= 0) touching.push_back({faces.outer[f], faces.outer[other]});
  return touching;
}

}  // namespace ashlar
