#pragma once
#include <array>
#include <functional>
#include <vector>

namespace ashlar {

/// A polygon with holes, cut into triangles.
struct Triangulated {
  std::vector<std::array<double, 2>> points;  ///< those of the loops first, in their order
  std::vector<std::array<int, 3>> triangles;  ///< counter-clockwise
};

/// Constrained Delaunay refinement (CGAL) of the region inside the first loop and outside the others. The edges of the
/// loops stay whole, so that neighbours that were divided alike fit. Elsewhere triangles are refined until no edge is
/// longer than about `size` there and no angle is below 20.7 degrees, unless the loops force it.
/// @param loops closed polygons that neither cross nor touch themselves or each other, in any orientation
Triangulated triangulate(const std::vector<std::vector<std::array<double, 2>>>& loops,
                         const std::function<double(const std::array<double, 2>&)>& size);

}  // namespace ashlar
