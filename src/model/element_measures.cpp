#include "model/element_measures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "physics/gauss_table.hpp"

namespace ashlar {

namespace {

/// The three neighbours of each corner, in right-hand order: their edges span the corner's Jacobian.
constexpr int hex_neighbours[8][3] = {{1, 3, 4}, {2, 0, 5}, {3, 1, 6}, {0, 2, 7},
                                      {7, 5, 0}, {4, 6, 1}, {5, 7, 2}, {6, 4, 3}};
constexpr int wedge_neighbours[6][3] = {{1, 2, 3}, {2, 0, 4}, {0, 1, 5}, {5, 4, 0}, {3, 5, 1}, {4, 3, 2}};
constexpr int tet_neighbours[4][3] = {{1, 2, 3}, {2, 0, 3}, {0, 1, 3}, {0, 2, 1}};

const int* corner_neighbours(Shape shape, int corner) {
  switch (shape) {
    case Shape::hex8: return hex_neighbours[corner];
    case Shape::wedge6: return wedge_neighbours[corner];
    case Shape::tet4: break;
  }
  return tet_neighbours[corner];
}

template <class Element>
void measure_gauss_points(const Mesh& mesh, int e, ElementMeasures& measures) {
  double points[3][Element::corners];
  const auto corners = mesh.element(e);
  for (int k = 0; k < Element::corners; ++k)
    for (int a = 0; a < 3; ++a) points[a][k] = mesh.points[corners[k]][a];
  const ElementGeometry<Element, double> geometry(points);
  measures.smallest_gauss_jacobian = std::numeric_limits<double>::infinity();
  for (int g = 0; g < Element::gauss_points; ++g) {
    const double det = geometry.jacobian_at(g).det;
    measures.smallest_gauss_jacobian = std::min(measures.smallest_gauss_jacobian, det);
    measures.volume += GaussTable<Element>::factor * det;
  }
}

void measure_corners(const Mesh& mesh, int e, ElementMeasures& measures) {
  const auto nodes = mesh.element(e);
  measures.smallest_corner = 1;
  measures.shortest_edge = std::numeric_limits<double>::infinity();
  for (int c = 0; c < static_cast<int>(nodes.size()); ++c) {
    const int* neighbours = corner_neighbours(mesh.shapes[e], c);
    Vec3<double> edges[3];
    double lengths = 1;
    for (int i = 0; i < 3; ++i) {
      edges[i] = mesh.points[nodes[neighbours[i]]] - mesh.points[nodes[c]];
      const double length = norm(edges[i]);
      measures.shortest_edge = std::min(measures.shortest_edge, length);
      measures.longest_edge = std::max(measures.longest_edge, length);
      lengths *= length;
    }
    const double jacobian = dot(edges[0], cross(edges[1], edges[2]));
    measures.smallest_corner = std::min(measures.smallest_corner, lengths > 0 ? jacobian / lengths : 0.0);
  }
}

/// 2 / sum over corners of |mean gradient|, by the corner forces of unit pressure.
template <class Element>
Vec3<double> lengths(const Mesh& mesh, int e) {
  double points[3][Element::corners], u[3][Element::corners] = {}, gradient[3][Element::corners];
  for (int k = 0; k < Element::corners; ++k)
    for (int a = 0; a < 3; ++a) points[a][k] = mesh.points[mesh.element(e)[k]][a];
  const auto unit_pressure = [](int, const Sym3<double>&) { return Sym3<double>{1, 1, 1, 0, 0, 0}; };
  Element::force(points, u, gradient, unit_pressure);
  double volume = 0;
  Vec3<double> sum;
  for (int k = 0; k < Element::corners; ++k)
    for (int a = 0; a < 3; ++a) {
      volume += points[a][k] * gradient[a][k] / 3;
      sum[a] += std::abs(gradient[a][k]);
    }
  return {2 * volume / sum.x, 2 * volume / sum.y, 2 * volume / sum.z};
}

}  // namespace

Vec3<double> lengths_across(const Mesh& mesh, int element) {
  switch (mesh.shapes[element]) {
    case Shape::hex8: return lengths<Hex8<double>>(mesh, element);
    case Shape::wedge6: return lengths<Wedge6<double>>(mesh, element);
    case Shape::tet4: break;
  }
  return lengths<Tet4<double>>(mesh, element);
}

double ElementMeasures::scaled_jacobian(Shape shape) const {
  switch (shape) {
    case Shape::hex8: return smallest_corner;
    case Shape::wedge6: return smallest_corner / (std::sqrt(3.0) / 2);
    case Shape::tet4: break;
  }
  return smallest_corner / std::sqrt(0.5);
}

ElementMeasures measure_element(const Mesh& mesh, int element) {
  ElementMeasures measures;
  switch (mesh.shapes[element]) {
    case Shape::hex8: measure_gauss_points<Hex8<double>>(mesh, element, measures); break;
    case Shape::wedge6: measure_gauss_points<Wedge6<double>>(mesh, element, measures); break;
    case Shape::tet4: measure_gauss_points<Tet4<double>>(mesh, element, measures); break;
  }
  measure_corners(mesh, element, measures);
  return measures;
}

}  // namespace ashlar
