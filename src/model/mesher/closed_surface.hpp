#pragma once
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/tensor.hpp"

namespace ashlar {

/// The surface of a body as triangles. Corners at the same coordinates are one point.
struct FacetSurface {
  std::vector<Vec3<double>> points;           ///< m
  std::vector<std::array<int, 3>> triangles;  ///< seen from outside counter-clockwise, once checked
  std::vector<int> facets;                    ///< [triangles] number of the facet in its file, from 1
};

/// Twice the vector area of a triangle, m^2.
Vec3<double> twice_area(const FacetSurface& surface, int triangle);
/// m^3; negative where facets look inwards.
double enclosed_volume(const FacetSurface& surface);
double total_area(const FacetSurface& surface);

/// Reads .stl, .off, .obj or .ply (CGAL). Facets with more corners are cut into triangles. `where` names the file in
/// the deck. Throws DeckError: cannot be read, coordinates that are not finite, facets that cannot be cut.
FacetSurface read_facets(const std::string& path, const Where& where);

/// Pairs of triangles that share more than their common corners and edges, ascending (CGAL, exact).
std::vector<std::pair<int, int>> self_intersections(const FacetSurface& surface);

/// Whether the surface bounds one body: no facet without area, none given twice, every edge between two facets that
/// look to the same side of it, one shell that neither touches nor crosses itself. Throws DeckError with the facets'
/// numbers and places; `title` starts its messages. A whole shell that looks inwards is turned: returns true then.
bool check_closed(FacetSurface& surface, const Where& where, const std::string& title);

/// A body of tetrahedra.
struct Tetrahedra {
  std::vector<Vec3<double>> points;       ///< m
  std::vector<std::array<int, 4>> cells;  ///< positive volume
};

/// Delaunay refinement of the inside of a checked surface (CGAL), the same for the same input. Edges where facets meet
/// at more than `feature_angle` (rad) stay, with their corners; elsewhere the mesh keeps within `deviation` of the
/// surface. Elements have edges of about `size` at the surface and of `size + (grow - 1) depth` inside.
Tetrahedra tetrahedralise(const FacetSurface& surface, double size, double grow, double feature_angle,
                          double deviation);

}  // namespace ashlar
