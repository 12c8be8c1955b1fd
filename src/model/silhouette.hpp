#pragma once
#include <array>
#include <vector>

#include "model/mesh.hpp"

namespace ashlar {

/// Faces turned towards one side of the model (0 left -x, 1 right +x, 2 front -y, 3 back +y, 4 bottom -z, 5 top +z),
/// found by where they stand across its direction: does one of them hide a point from a viewer far away on that side?
class Silhouette {
 public:
  Silhouette(const Mesh& mesh, const std::vector<Facet>& facets, int side);
  bool hides(const Vec3<double>& p) const;

 private:
  using Across = std::array<double, 2>;
  Across across(const Vec3<double>& p) const { return {p[(axis_ + 1) % 3], p[(axis_ + 2) % 3]}; }
  int cell(const Across& at, int a) const;
  bool triangle_hides(int a, int b, int c, const Vec3<double>& p) const;

  const Mesh& mesh_;
  int axis_;
  double sign_;
  double tolerance_;  ///< m
  std::vector<Facet> facets_;
  Across low_{}, step_{};               ///< grid of cells across the direction, about one facet to a cell
  int cells_ = 1;                       ///< along each direction of the grid
  std::vector<std::vector<int>> bins_;  ///< [cells x cells] facets over each cell
};

}  // namespace ashlar
