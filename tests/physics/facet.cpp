#include "physics/facet.hpp"

#include <gtest/gtest.h>

namespace ashlar {
namespace {

struct Hydrostatic {
  Vec3<double> force, moment;
};
/// Resultant of the pressure (level - z) and its moment about the origin, over the quadrature points below the level.
Hydrostatic hydrostatic(const FacetCorners& x, double level) {
  Hydrostatic sum;
  for (const FacetPoint& p : facet_points_below(x, level)) {
    const Vec3<double> f = (level - p.position.z) * p.area;
    sum.force = sum.force + f;
    sum.moment = sum.moment + cross(p.position, f);
  }
  return sum;
}

/// The same with the shape functions: what the nodes carry.
Hydrostatic hydrostatic_at_nodes(const FacetCorners& x, double level) {
  Hydrostatic sum;
  for (const FacetPoint& p : facet_points_below(x, level))
    for (int i = 0; i < 4; ++i) {
      const Vec3<double> f = (p.shape[i] * (level - p.position.z)) * p.area;
      sum.force = sum.force + f;
      sum.moment = sum.moment + cross(x[i], f);
    }
  return sum;
}

// A plane trapezoid in the plane x = 0 between z = 0 and z = 4, width along y from 3 (at z = 0) to 1, normal +x.
const FacetCorners trapezoid{{{0, 0, 0}, {0, 3, 0}, {0, 2, 4}, {0, 1, 4}}};

TEST(Facet, thrust_and_point_of_action_on_a_cut_trapezoid_follow_the_closed_form) {
  for (double level : {0.3, 1.0, 2.5, 3.999, 4.0, 6.0}) {
    // width 3 - z/2: force = integral of (level - z)(3 - z/2) dz, moment about y likewise with z
    const double d = std::min(level, 4.0);
    const auto moment_of = [&](int n) {  // integral of z^n (level - z)(3 - z/2), z from 0 to d
      const double a = 3 * level, b = -(3 + level / 2), c = 0.5;
      return a * std::pow(d, n + 1) / (n + 1) + b * std::pow(d, n + 2) / (n + 2) + c * std::pow(d, n + 3) / (n + 3);
    };
    const Hydrostatic h = hydrostatic_at_nodes(trapezoid, level);
    EXPECT_NEAR(h.force.x, moment_of(0), 1e-12 * moment_of(0)) << level;
    EXPECT_NEAR(h.moment.y, moment_of(1), 1e-12 * moment_of(1)) << level;
    EXPECT_NEAR(h.moment.z, -1.5 * moment_of(0), 1e-12 * moment_of(0)) << level;  // the axis of symmetry is y = 1.5
  }
}

TEST(Facet, nodes_carry_the_same_thrust_and_moment_as_the_water_on_any_plane_quadrangle) {
  const FacetCorners leaning{{{0.3, -1, 0.2}, {0.7, 2.5, 0.6}, {1.9, 1.7, 2.8}, {1.1, 0.1, 1.9}}};
  // put the fourth corner into the plane of the first three
  FacetCorners plane = leaning;
  const Vec3<double> n = cross(plane[1] - plane[0], plane[2] - plane[0]);
  plane[3].x -= dot(plane[3] - plane[0], n) / n.x;
  for (double level : {0.25, 0.7, 1.3, 2.2, 2.79}) {
    const Hydrostatic water = hydrostatic(plane, level), nodes = hydrostatic_at_nodes(plane, level);
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(nodes.force[i], water.force[i], 1e-12 * norm(water.force)) << level;
      EXPECT_NEAR(nodes.moment[i], water.moment[i], 1e-11 * norm(water.moment)) << level;
    }
  }
}

TEST(Facet, cut_triangle_follows_the_closed_form) {
  const FacetCorners triangle{{{0, 0, 0}, {0, 2, 0}, {0, 1, 4}, {0, 1, 4}}};
  const double level = 1.5;  // width 2 - z/2
  const double force = 2 * level * level / 2 - 0.5 * level * level * level / 6;
  const double moment = 2 * std::pow(level, 3) / 6 - 0.5 * std::pow(level, 4) / 12;
  const Hydrostatic h = hydrostatic_at_nodes(triangle, level);
  EXPECT_NEAR(h.force.x, force, 1e-13 * force);
  EXPECT_NEAR(h.moment.y, moment, 1e-13 * moment);
}

TEST(Facet, nodal_parts_of_a_cut_rectangle_follow_the_closed_form) {
  const FacetCorners rectangle{{{0, 0, 0}, {0, 3, 0}, {0, 3, 2}, {0, 0, 2}}};
  const double level = 0.9;
  std::array<double, 4> part{};
  for (const FacetPoint& p : facet_points_below(rectangle, level))
    for (int i = 0; i < 4; ++i) part[i] += p.shape[i] * (level - p.position.z) * p.area.x;
  const double high = 1.5 * level * level * level / 12, all = 1.5 * level * level / 2;  // N_top = z/2
  EXPECT_NEAR(part[2], high, 1e-13);
  EXPECT_NEAR(part[3], high, 1e-13);
  EXPECT_NEAR(part[0], all - high, 1e-13);
  EXPECT_NEAR(part[1], all - high, 1e-13);
}

TEST(Facet, a_facet_above_the_level_is_dry) { EXPECT_TRUE(facet_points_below(trapezoid, 0).empty()); }

TEST(Facet, a_triangle_integrates_products_of_shape_functions_exactly) {
  const FacetCorners triangle{{{0, 0, 0}, {2, 0, 1}, {0, 3, -1}, {0, 3, -1}}};
  const double area = 0.5 * norm(cross(triangle[1] - triangle[0], triangle[2] - triangle[0]));
  double product[3][3] = {};
  for (const FacetPoint& p : facet_points(triangle)) {
    const double n[3] = {p.shape[0], p.shape[1], p.shape[2] + p.shape[3]};
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) product[i][j] += n[i] * n[j] * norm(p.area);
  }
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) EXPECT_NEAR(product[i][j], area / (i == j ? 6 : 12), 1e-15 * area * 4);
}

}  // namespace
}  // namespace ashlar
