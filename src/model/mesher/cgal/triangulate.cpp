#include "model/mesher/triangulate.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_vertex_base_2.h>
#include <CGAL/Delaunay_mesher_no_edge_refinement_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>

namespace ashlar {

namespace {

struct Number {
  int value = -1;
};

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex = CGAL::Delaunay_mesh_vertex_base_2<Kernel, CGAL::Triangulation_vertex_base_with_info_2<Number, Kernel>>;
using Face = CGAL::Delaunay_mesh_face_base_2<Kernel>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertex, Face>>;
using Point = Kernel::Point_2;
using SizeFunction = std::function<double(const std::array<double, 2>&)>;

/// When a triangle is refined: first by size, then by angle. Edges of the loops are as long as they are.
class SizeFieldCriteria {
 public:
  using Face_handle = Triangulation::Face_handle;
  /// The worst comes first: oversized ones by excess, then the flattest.
  struct Quality {
    double oversize = 0;      ///< longest free edge over the longest allowed
    double squared_sine = 1;  ///< of the smallest angle
    bool operator<(const Quality& other) const {
      if (oversize > 1 || other.oversize > 1) return oversize > other.oversize;
      return squared_sine < other.squared_sine;
    }
  };

  explicit SizeFieldCriteria(const SizeFunction& size) : size_(&size) {}

  class Is_bad {
   public:
    explicit Is_bad(const SizeFunction& size) : size_(&size) {}
    CGAL::Mesh_2::Face_badness operator()(const Quality& quality) const {
      if (quality.oversize > 1) return CGAL::Mesh_2::IMPERATIVELY_BAD;
      return quality.squared_sine < smallest_squared_sine ? CGAL::Mesh_2::BAD : CGAL::Mesh_2::NOT_BAD;
    }
    CGAL::Mesh_2::Face_badness operator()(const Face_handle& face, Quality& quality) const {
      std::array<Point, 3> p;
      for (int i = 0; i < 3; ++i) p[i] = face->vertex(i)->point();
      std::array<double, 3> squares;
      double longest_free = 0;
      for (int i = 0; i < 3; ++i) {
        squares[i] = CGAL::squared_distance(p[(i + 1) % 3], p[(i + 2) % 3]);
        if (!face->is_constrained(i)) longest_free = std::max(longest_free, squares[i]);
      }
      const auto middle = CGAL::centroid(p[0], p[1], p[2]);
      const double allowed = longest_over_size * (*size_)({middle.x(), middle.y()});
      quality.oversize = longest_free / (allowed * allowed);
      const double twice_area = 2 * CGAL::area(p[0], p[1], p[2]);
      std::sort(squares.begin(), squares.end());
      quality.squared_sine = twice_area * twice_area / (squares[1] * squares[2]);
      return (*this)(quality);
    }

   private:
    static constexpr double smallest_squared_sine = 0.125;  // Shewchuk's bound of termination, 20.7 degrees
    // Delaunay refinement leaves edges of about two thirds of the longest allowed: this makes their mean the size.
    static constexpr double longest_over_size = 1.4;
    const SizeFunction* size_;
  };
  Is_bad is_bad_object() const { return Is_bad(*size_); }

 private:
  const SizeFunction* size_;
};

/// A point of the region: left of the first edge of the first loop, or right of it if the loop runs clockwise.
Point inner_point(const Triangulation& triangulation, const std::vector<Triangulation::Vertex_handle>& loop) {
  double twice_area = 0;
  for (std::size_t i = 1; i + 1 < loop.size(); ++i)
    twice_area += 2 * CGAL::area(loop[0]->point(), loop[i]->point(), loop[i + 1]->point());
  Triangulation::Face_handle face;
  int opposite = 0;
  // The face that is given lies left of the edge from its vertex ccw(i) to its vertex cw(i).
  triangulation.is_edge(loop[0], loop[1], face, opposite);
  const bool along = face->vertex(Triangulation::ccw(opposite)) == loop[0];
  if (along != (twice_area > 0)) face = face->neighbor(opposite);
  return CGAL::centroid(face->vertex(0)->point(), face->vertex(1)->point(), face->vertex(2)->point());
}

}  // namespace

Triangulated triangulate(const std::vector<std::vector<std::array<double, 2>>>& loops, const SizeFunction& size) {
  Triangulation triangulation;
  Triangulated result;
  std::vector<Triangulation::Vertex_handle> outline;
  for (const auto& loop : loops) {
    std::vector<Triangulation::Vertex_handle> vertices;
    Triangulation::Face_handle near;
    for (const auto& p : loop) {
      vertices.push_back(triangulation.insert(Point(p[0], p[1]), near));
      near = vertices.back()->face();
      vertices.back()->info().value = static_cast<int>(result.points.size());
      result.points.push_back(p);
    }
    for (std::size_t i = 0; i < vertices.size(); ++i)
      triangulation.insert_constraint(vertices[i], vertices[(i + 1) % vertices.size()]);
    if (outline.empty()) outline = vertices;
  }

  CGAL::Delaunay_mesher_no_edge_refinement_2<Triangulation, SizeFieldCriteria> mesher(triangulation,
                                                                                      SizeFieldCriteria(size));
  const std::array seeds{inner_point(triangulation, outline)};
  mesher.set_seeds(seeds.begin(), seeds.end(), true);
  mesher.refine_mesh();

  for (auto v = triangulation.finite_vertices_begin(); v != triangulation.finite_vertices_end(); ++v)
    if (v->info().value < 0) {
      v->info().value = static_cast<int>(result.points.size());
      result.points.push_back({v->point().x(), v->point().y()});
    }
  for (auto f = triangulation.finite_faces_begin(); f != triangulation.finite_faces_end(); ++f)
    if (f->is_in_domain())
      result.triangles.push_back({f->vertex(0)->info().value, f->vertex(1)->info().value, f->vertex(2)->info().value});
  return result;
}

}  // namespace ashlar
