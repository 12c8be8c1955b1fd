#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polyhedral_mesh_domain_with_features_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/make_mesh_3.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "model/mesher/closed_surface.hpp"
#include "model/mesher/facet_soup.hpp"

namespace ashlar {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using SurfaceMesh = CGAL::Surface_mesh<Point>;
using Domain = CGAL::Polyhedral_mesh_domain_with_features_3<Kernel, SurfaceMesh>;
using Triangulation = CGAL::Mesh_triangulation_3<Domain>::type;
using Complex = CGAL::Mesh_complex_3_in_triangulation_3<Triangulation, Domain::Corner_index, Domain::Curve_index>;
using Criteria = CGAL::Mesh_criteria_3<Triangulation>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, CGAL::AABB_face_graph_triangle_primitive<SurfaceMesh>>>;

Vec3<double> place_of(const Point& p) { return {p.x(), p.y(), p.z()}; }

SurfaceMesh surface_mesh(const FacetSurface& surface) {
  SurfaceMesh mesh;
  for (const auto& p : surface.points) mesh.add_vertex(Point(p.x, p.y, p.z));
  using Vertex = SurfaceMesh::Vertex_index;
  for (const auto& [a, b, c] : surface.triangles) mesh.add_face(Vertex(a), Vertex(b), Vertex(c));
  return mesh;
}

/// Circumradii of cells that make edges of the size wanted.
class CellSize {
 public:
  using FT = Kernel::FT;
  using Point_3 = Point;
  using Index = Domain::Index;
  CellSize(const Tree& tree, double size, double grow) : tree_(&tree), size_(size), grow_(grow) {}
  FT operator()(const Point& p, int, const Index&) const {
    constexpr double radius_over_edge = 0.75;  // gives a mean edge of the size
    const double depth = grow_ > 1 ? std::sqrt(tree_->squared_distance(p)) : 0;
    return radius_over_edge * (size_ + (grow_ - 1) * depth);
  }

 private:
  const Tree* tree_;
  double size_, grow_;
};

}  // namespace

FacetSoup read_facet_soup(const std::string& path) {
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> polygons;
  if (!CGAL::IO::read_polygon_soup(path, points, polygons)) return {};
  FacetSoup soup;
  for (const auto& p : points) soup.points.push_back(place_of(p));
  for (const auto& polygon : polygons) soup.facets.emplace_back(polygon.begin(), polygon.end());
  return soup;
}

std::vector<std::pair<int, int>> self_intersections(const FacetSurface& surface) {
  const auto mesh = surface_mesh(surface);
  std::vector<std::pair<SurfaceMesh::Face_index, SurfaceMesh::Face_index>> found;
  CGAL::Polygon_mesh_processing::self_intersections(mesh, std::back_inserter(found));
  std::vector<std::pair<int, int>> pairs;
  for (const auto& [a, b] : found) pairs.emplace_back(std::min<int>(a.idx(), b.idx()), std::max<int>(a.idx(), b.idx()));
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

Tetrahedra tetrahedralise(const FacetSurface& surface, double size, double grow, double feature_angle,
                          double deviation) {
  const auto mesh = surface_mesh(surface);
  const Tree tree(faces(mesh).begin(), faces(mesh).end(), mesh);
  CGAL::get_default_random() = CGAL::Random(0);
  CGAL::Random random(0);
  Domain domain(mesh, &random);
  domain.detect_features(feature_angle * 180 / std::numbers::pi);

  namespace parameters = CGAL::parameters;
  constexpr double radius_over_edge = 0.7;  // of facets; gives a mean edge of the size
  constexpr double smallest_angle = 25, radius_over_shortest_edge = 2;
  const Criteria criteria(parameters::edge_size = size, parameters::facet_angle = smallest_angle,
                          parameters::facet_size = radius_over_edge * size, parameters::facet_distance = deviation,
                          parameters::cell_radius_edge_ratio = radius_over_shortest_edge,
                          parameters::cell_size = CellSize(tree, size, grow));
  // Slivers are mended until none is left below this dihedral angle. CGAL would stop after as much time as the rest has
  // taken, so that a busy machine got another mesh.
  constexpr double sliver_angle = 10, no_limit = 0;
  const auto complex = CGAL::make_mesh_3<Complex>(
      domain, criteria, parameters::no_lloyd(), parameters::no_odt(),
      parameters::perturb(parameters::time_limit = no_limit, parameters::sliver_bound = sliver_angle),
      parameters::exude(parameters::time_limit = no_limit, parameters::sliver_bound = sliver_angle));

  Tetrahedra result;
  std::map<Triangulation::Vertex_handle, int> number;
  for (auto cell = complex.cells_in_complex_begin(); cell != complex.cells_in_complex_end(); ++cell) {
    std::array<int, 4> corners;
    for (int i = 0; i < 4; ++i) {
      const auto vertex = cell->vertex(i);
      const auto [at, fresh] = number.try_emplace(vertex, static_cast<int>(result.points.size()));
      if (fresh)
        result.points.push_back(place_of(Point(vertex->point().x(), vertex->point().y(), vertex->point().z())));
      corners[i] = at->second;
    }
    result.cells.push_back(corners);
  }
  return result;
}

}  // namespace ashlar
