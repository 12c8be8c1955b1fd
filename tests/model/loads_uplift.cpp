#include <gtest/gtest.h>

#include "model/loads.hpp"
#include "support/brick.hpp"

namespace ashlar {
namespace {

constexpr double length = 48, thickness = 12, water_weight = 9810;  // m, m, N/m^3

/// A base 48 m long and 12 m thick under a block 10 m high; the bottom rises by `slope` along x.
Mesh base_mesh(int along, Shape shape, double slope = 0) {
  return brick(
      {along, 2, 1},
      [&](const Vec3<double>& p) {
        const double x = length * p.x, bottom = slope * x;
        return Vec3<double>{x, thickness * p.y, bottom + (10 - bottom) * p.z};
      },
      shape);
}

/// Force and moment on the bottom.
Resultant on_bottom(const Mesh& mesh, const Uplift& uplift) {
  std::vector<double> force(3 * mesh.points.size(), 0);
  const Surface& bottom = *mesh.find_surface("bottom");
  add_uplift(mesh, mesh.corners, bottom, uplift, {}, force);
  return resultant(mesh.points, force, surface_nodes(mesh, mesh.corners, bottom));
}

/// Area and first moment about the heel of a level line with corners { x, head above the base }.
std::array<double, 2> diagram(const std::vector<std::array<double, 2>>& corners) {
  std::array<double, 2> sum{};
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
    const double x = corners[i][0], h = corners[i][1], dx = corners[i + 1][0] - x, dh = corners[i + 1][1] - h;
    sum[0] += dx * (h + dh / 2);
    sum[1] += dx * (x * (h + dh / 2) + dx * (h / 2 + dh / 3));
  }
  return sum;
}

void expect_diagram(const Resultant& found, const std::vector<std::array<double, 2>>& corners) {
  const auto [area, moment] = diagram(corners);
  EXPECT_NEAR(found.force.z / (water_weight * thickness * area), 1, 1e-12);
  EXPECT_NEAR(-found.moment.y / (water_weight * thickness * moment), 1, 1e-12);
  EXPECT_NEAR(found.moment.x / found.force.z, thickness / 2, 1e-11);
  EXPECT_NEAR(found.force.x / found.force.z, 0, 1e-14);
}

class UpliftOnShape : public testing::TestWithParam<Shape> {};
INSTANTIATE_TEST_SUITE_P(Shapes, UpliftOnShape, testing::Values(Shape::hex8, Shape::wedge6, Shape::tet4),
                         [](const auto& info) { return shape_name(info.param); });

TEST_P(UpliftOnShape, without_drains_is_the_trapezoid_between_headwater_and_tailwater) {
  Uplift uplift{55, 5, {}, {}, {}, 0, {}, 1000, 9.81};
  const Resultant found = on_bottom(base_mesh(5, GetParam()), uplift);
  expect_diagram(found, {{0, 55}, {length, 5}});
  // L/3 (H1 + 2 H2)/(H1 + H2) from the heel
  EXPECT_NEAR(-found.moment.y / found.force.z, length / 3 * (55 + 2 * 5) / (55 + 5), 1e-11);
}

TEST_P(UpliftOnShape, drains_put_a_kink_into_the_level_wherever_they_cut_the_elements) {
  // EM 1110-2-2200: straight line at the drains 55 - 50 x 6/48 = 48.75; half of its height above the tailwater is left
  Uplift uplift{55, 5, {}, {}, 6, 0.5, {}, 1000, 9.81};
  for (const int along : {1, 3, 8}) {
    uplift.gallery.reset();
    expect_diagram(on_bottom(base_mesh(along, GetParam()), uplift), {{0, 55}, {6, 26.875}, {length, 5}});
    uplift.gallery = 10;  // 10 + 0.5 (48.75 - 10)
    expect_diagram(on_bottom(base_mesh(along, GetParam()), uplift), {{0, 55}, {6, 29.375}, {length, 5}});
    uplift.gallery = 2;  // below the tailwater: no say
    expect_diagram(on_bottom(base_mesh(along, GetParam()), uplift), {{0, 55}, {6, 26.875}, {length, 5}});
    uplift.gallery = 54;  // above the straight line: the drains stay dry
    expect_diagram(on_bottom(base_mesh(along, GetParam()), uplift), {{0, 55}, {length, 5}});
  }
}

TEST_P(UpliftOnShape, there_is_no_suction_where_the_base_is_above_the_piezometric_level) {
  const Uplift uplift{55, -5, {}, {}, {}, 0, {}, 1000, 9.81};
  expect_diagram(on_bottom(base_mesh(3, GetParam()), uplift), {{0, 55}, {44, 0}});
}

TEST_P(UpliftOnShape, under_a_rising_base_it_acts_against_the_normal_with_the_head_above_the_base) {
  // base z = x/16: head from 55 at the heel to 5 - 3 at the toe, over the same plan
  const Resultant found = on_bottom(base_mesh(3, GetParam(), 1.0 / 16), {55, 5, {}, {}, {}, 0, {}, 1000, 9.81});
  EXPECT_NEAR(found.force.z, water_weight * thickness * length * (55 + 2) / 2, 1e-4);
  EXPECT_NEAR(found.force.x, -found.force.z / 16, 1e-5);
}

TEST_P(UpliftOnShape, heel_and_toe_given_swap_sides_and_keep_the_level_beyond_them) {
  const Uplift uplift{55, 5, 40, 8, {}, 0, {}, 1000, 9.81};
  expect_diagram(on_bottom(base_mesh(7, GetParam()), uplift), {{0, 5}, {8, 5}, {40, 55}, {length, 55}});
}

TEST(Uplift, a_drain_outside_the_base_is_refused_with_the_line_of_the_deck) {
  const Mesh mesh = base_mesh(2, Shape::hex8);
  std::vector<double> force(3 * mesh.points.size(), 0);
  const auto message = [&](const Uplift& uplift) -> std::string {
    try {
      add_uplift(mesh, mesh.corners, *mesh.find_surface("bottom"), uplift, {"dam.lua", 9}, force);
    } catch (const DeckError& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_EQ(
      message({55, 5, {}, {}, 60, 0.5, {}, 1000, 9.81}),
      "dam.lua:9: uplift on surface 'bottom': the drain at x = 60 m is not between the heel at 0 m and the toe at "
      "48 m");
  EXPECT_EQ(message({55, 5, 7, 7, {}, 0, {}, 1000, 9.81}),
            "dam.lua:9: uplift on surface 'bottom': 'heel' and 'toe' are the same place; on an upright face use "
            "water_pressure");
}

TEST_P(UpliftOnShape, an_even_pressure_on_all_faces_is_in_balance) {
  const Mesh mesh = base_mesh(3, GetParam(), 1.0 / 16);
  std::vector<double> force(3 * mesh.points.size(), 0);
  for (const Surface& surface : mesh.surfaces) add_pressure(mesh, mesh.corners, surface, {{2e6, {}}}, force);
  std::vector<int> all(mesh.points.size());
  for (std::size_t n = 0; n < all.size(); ++n) all[n] = static_cast<int>(n);
  const Resultant sum = resultant(mesh.points, force, all);
  const double size = 2e6 * length * thickness;  // N on the bottom
  EXPECT_NEAR(norm(sum.force) / size, 0, 1e-14);
  EXPECT_NEAR(norm(sum.moment) / (size * length), 0, 1e-14);
}

TEST_P(UpliftOnShape, a_pressure_of_position_has_force_and_moment_of_its_diagram) {
  const Mesh mesh = base_mesh(4, GetParam());
  std::vector<double> force(3 * mesh.points.size(), 0);
  const Surface& bottom = *mesh.find_surface("bottom");
  Pressure pressure;
  pressure.value.at = [](const Vec3<double>& p) { return water_weight * (55 - 50 * p.x / length); };
  add_pressure(mesh, mesh.corners, bottom, pressure, force);
  expect_diagram(resultant(mesh.points, force, surface_nodes(mesh, mesh.corners, bottom)), {{0, 55}, {length, 5}});
}

}  // namespace
}  // namespace ashlar
