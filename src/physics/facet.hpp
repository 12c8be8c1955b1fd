#pragma once
#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "base/tensor.hpp"

/// Integrals over one face of an element: shape functions, quadrature and the part under a water line. Host only.
namespace ashlar {

/// Corners of a facet, right-hand order. A triangle repeats its last corner: the bilinear map then collapses to the
/// linear triangle (shape 2 + shape 3 is its third area coordinate), and the 2x2 Gauss rule integrates N_i N_j dA
/// exactly.
using FacetCorners = std::array<Vec3<double>, 4>;

/// One quadrature point.
struct FacetPoint {
  std::array<double, 4> shape{};  ///< N_i
  Vec3<double> position;          ///< m
  Vec3<double> area;              ///< normal of the facet times the part of its area that this point stands for, m^2
};

inline std::array<double, 4> facet_shape(double a, double b) {
  return {0.25 * (1 - a) * (1 - b), 0.25 * (1 + a) * (1 - b), 0.25 * (1 + a) * (1 + b), 0.25 * (1 - a) * (1 + b)};
}

/// Position and the two tangents of the bilinear map at (a, b) in [-1, 1]^2.
struct FacetMap {
  Vec3<double> position, along_a, along_b;
};
inline FacetMap facet_map(const FacetCorners& x, double a, double b) {
  const std::array<double, 4> n = facet_shape(a, b);
  FacetMap m;
  for (int i = 0; i < 4; ++i) m.position = m.position + n[i] * x[i];
  m.along_a = (0.25 * (1 - b)) * (x[1] - x[0]) + (0.25 * (1 + b)) * (x[2] - x[3]);
  m.along_b = (0.25 * (1 - a)) * (x[3] - x[0]) + (0.25 * (1 + a)) * (x[2] - x[1]);
  return m;
}

/// 2x2 Gauss points.
inline std::array<FacetPoint, 4> facet_points(const FacetCorners& x) {
  constexpr double g = 0.57735026918962576451;
  std::array<FacetPoint, 4> points;
  int k = 0;
  for (double b : {-g, g})
    for (double a : {-g, g}) {
      const FacetMap m = facet_map(x, a, b);
      points[k++] = {facet_shape(a, b), m.position, cross(m.along_a, m.along_b)};
    }
  return points;
}

/// Shape functions at the point of the facet that is nearest to p (Newton on the bilinear map).
inline std::array<double, 4> facet_shape_at(const FacetCorners& x, const Vec3<double>& p) {
  double a = 0, b = 0;
  for (int iteration = 0; iteration < 30; ++iteration) {
    const FacetMap m = facet_map(x, a, b);
    const Vec3<double> miss = p - m.position;
    const double aa = dot(m.along_a, m.along_a), bb = dot(m.along_b, m.along_b), ab = dot(m.along_a, m.along_b);
    const double ra = dot(m.along_a, miss), rb = dot(m.along_b, miss), det = aa * bb - ab * ab;
    if (!(det > 0)) break;
    const double da = (ra * bb - rb * ab) / det, db = (rb * aa - ra * ab) / det;
    a += da;
    b += db;
    if (da * da + db * db < 1e-28) break;
  }
  return facet_shape(a, b);
}

/// The same on a plane triangle, from its areas; the fourth is not there.
inline std::array<double, 4> triangle_shape_at(const FacetCorners& x, const Vec3<double>& p) {
  const Vec3<double> normal = cross(x[1] - x[0], x[2] - x[0]);
  const double whole = dot(normal, normal);
  const double second = dot(cross(p - x[0], x[2] - x[0]), normal) / whole;
  const double third = dot(cross(x[1] - x[0], p - x[0]), normal) / whole;
  return {1 - second - third, second, third, 0};
}

/// The points p with dot(normal, p) < offset.
struct HalfSpace {
  Vec3<double> normal;
  double offset = 0;
};

/// Quadrature of the part of the facet inside all half-spaces: all of it (2x2 Gauss), nothing, or the polygon that is
/// left, split into triangles with a rule of degree 4. Resultant and point of action of a pressure that is linear in
/// space are exact on plane facets of any shape; nodal parts are exact on parallelograms and triangles.
inline std::vector<FacetPoint> facet_points_inside(const FacetCorners& x, std::span<const HalfSpace> halves) {
  std::vector<Vec3<double>> wet(x.begin(), x.end());
  bool whole = true;
  for (const HalfSpace& half : halves) {
    const auto beyond = [&](const Vec3<double>& p) { return dot(half.normal, p) - half.offset; };
    if (std::all_of(wet.begin(), wet.end(), [&](const Vec3<double>& p) { return beyond(p) <= 0; })) continue;
    whole = false;
    std::vector<Vec3<double>> kept;
    for (std::size_t i = 0; i < wet.size(); ++i) {
      const Vec3<double>&p = wet[i], &q = wet[(i + 1) % wet.size()];
      const double at_p = beyond(p), at_q = beyond(q);
      if (at_p < 0) kept.push_back(p);
      if ((at_p < 0) != (at_q < 0)) kept.push_back(p + (at_p / (at_p - at_q)) * (q - p));
    }
    wet = std::move(kept);
  }
  if (whole) {
    const auto all = facet_points(x);
    return {all.begin(), all.end()};
  }
  struct Rule {
    double corner, weight;  // area coordinate of the corner that the point leans to; the other two share the rest
  };
  constexpr Rule degree4[2] = {{0.816847572980459, 0.109951743655322}, {0.108103018168070, 0.223381589678011}};
  std::vector<FacetPoint> points;
  for (std::size_t t = 1; t + 1 < wet.size(); ++t) {
    const std::array<Vec3<double>, 3> corner{wet[0], wet[t], wet[t + 1]};
    const Vec3<double> area = 0.5 * cross(corner[1] - corner[0], corner[2] - corner[0]);
    for (const Rule& rule : degree4)
      for (int i = 0; i < 3; ++i) {
        const Vec3<double> p =
            rule.corner * corner[i] + (0.5 * (1 - rule.corner)) * (corner[(i + 1) % 3] + corner[(i + 2) % 3]);
        points.push_back({facet_shape_at(x, p), p, rule.weight * area});
      }
  }
  return points;
}

/// The part of the facet with z < level.
inline std::vector<FacetPoint> facet_points_below(const FacetCorners& x, double level) {
  const HalfSpace below{{0, 0, 1}, level};
  return facet_points_inside(x, {&below, 1});
}

}  // namespace ashlar
