#include "model/loads.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "support/brick.hpp"

namespace ashlar {
namespace {

/// Dam of the public case D0: height 60, crest 8, neck above z = 50, base 48, thickness 12; upstream face x = 0.
Mesh dam_mesh(std::array<int, 3> cells, Shape shape) {
  return brick(
      cells,
      [](const Vec3<double>& p) {
        const double z = 60 * p.z, width = z > 50 ? 8 : 8 + 40 * (50 - z) / 50;
        return Vec3<double>{width * p.x, 12 * p.y, z};
      },
      shape);
}

Vec3<double> total(const std::vector<double>& force) {
  Vec3<double> sum;
  for (std::size_t n = 0; n < force.size() / 3; ++n)
    for (int i = 0; i < 3; ++i) sum[i] += force[3 * n + i];
  return sum;
}

Resultant water_on_left(const Mesh& mesh, double level) {
  std::vector<double> force(3 * mesh.points.size(), 0);
  const Surface& left = *mesh.find_surface("left");
  add_water_pressure(mesh, mesh.corners, left, {level, 1000, 9.81}, force);
  const std::vector<int> nodes = surface_nodes(mesh, mesh.corners, left);
  EXPECT_NEAR(norm(total(force) - resultant(mesh.points, force, nodes).force), 0, 1e-6);
  return resultant(mesh.points, force, nodes);
}

class LoadsOnShape : public testing::TestWithParam<Shape> {};
INSTANTIATE_TEST_SUITE_P(Shapes, LoadsOnShape, testing::Values(Shape::hex8, Shape::wedge6, Shape::tet4),
                         [](const auto& info) { return shape_name(info.param); });

TEST_P(LoadsOnShape, water_thrust_on_dam_d0_and_its_height_do_not_depend_on_the_mesh) {
  // rho g h^2/2 x thickness = 1.780515e8 N at h/3, whether the level runs along element edges (12 rows) or cuts facets
  for (std::array<int, 3> cells : {std::array<int, 3>{3, 2, 12}, {3, 2, 8}, {2, 1, 7}}) {
    const Resultant water = water_on_left(dam_mesh(cells, GetParam()), 55);
    EXPECT_NEAR(water.force.x, 1.780515e8, 1e-6 * 1.780515e8);
    EXPECT_NEAR(water.moment.y / water.force.x, 55.0 / 3, 1e-6);
    EXPECT_NEAR(-water.moment.z / water.force.x, 6, 1e-9);
    EXPECT_NEAR(water.force.y, 0, 1e-4);
    EXPECT_NEAR(water.force.z, 0, 1e-4);
  }
}

TEST_P(LoadsOnShape, water_on_the_inclined_face_pushes_down_and_upstream) {
  // 50 m of the slope (48,0)->(8,50): horizontal rho g h^2/2, vertical rho g x the wedge of water above it
  const Mesh mesh = dam_mesh({3, 2, 6}, GetParam());
  std::vector<double> force(3 * mesh.points.size(), 0);
  add_water_pressure(mesh, mesh.corners, *mesh.find_surface("right"), {31, 1000, 9.81}, force);
  const double thrust = 9810.0 * 31 * 31 / 2 * 12;
  EXPECT_NEAR(total(force).x, -thrust, 1e-9 * thrust);
  EXPECT_NEAR(total(force).z, -thrust * 40 / 50, 1e-9 * thrust);
}

TEST_P(LoadsOnShape, gravity_adds_up_to_the_weight_of_the_dam_and_acts_at_its_centroid) {
  Model model;
  model.mesh = dam_mesh({3, 2, 6}, GetParam());
  model.materials.resize(1);
  model.materials[0].name = "concrete";
  model.materials[0].regions = {"body"};
  model.materials[0].density = 2400;
  std::vector<double> force(3 * model.mesh.points.size(), 0);
  add_gravity(model, model.mesh.corners, {0, 0, -9.81}, force);
  const double weight_of_dam = 4.1814144e8;  // rho g x 1480 m2 x 12 m, cases.md 6
  EXPECT_NEAR(total(force).z, -weight_of_dam, 1e-12 * weight_of_dam);
  std::vector<int> all(model.mesh.points.size());
  std::iota(all.begin(), all.end(), 0);
  const Resultant weight = resultant(model.mesh.points, force, all);
  const double area = 8 * 60 + 40 * 50 / 2.0, x = (8 * 60 * 4 + 40 * 50 / 2.0 * (8 + 40 / 3.0)) / area;
  EXPECT_NEAR(-weight.moment.y / weight.force.z, x, 1e-12 * x);
  EXPECT_NEAR(weight.moment.x / weight.force.z, 6, 1e-11);
}

TEST_P(LoadsOnShape, traction_that_varies_linearly_has_the_exact_resultant) {
  const Mesh mesh = brick({2, 3, 2}, {2, 3, 4}, GetParam());
  std::vector<double> force(3 * mesh.points.size(), 0);
  Traction traction;
  traction.x.at = [](const Vec3<double>& p) { return 5 + 2 * p.y - p.x; };
  traction.z.constant = -7;
  add_traction(mesh, mesh.corners, *mesh.find_surface("top"), traction, force);
  EXPECT_NEAR(total(force).x, 6 * (5 + 2 * 1.5 - 1), 1e-12);
  EXPECT_NEAR(total(force).z, -42, 1e-12);
  const Resultant top = resultant(mesh.points, force, surface_nodes(mesh, mesh.corners, *mesh.find_surface("top")));
  // integral of y (5 + 2y - x) over 2 x 3
  EXPECT_NEAR(-top.moment.z, 2 * (4 * 4.5 + 2 * 9), 1e-11);
}

TEST_P(LoadsOnShape, film_takes_h_area_times_the_temperature_difference) {
  const Mesh mesh = brick({2, 3, 2}, {2, 3, 4}, GetParam());
  Condition air;
  air.noun = "convection";
  air.kind = Convection{{20, {}}, 15, {}, {}};
  const ThermalBoundary b = thermal_boundary(mesh, mesh.corners, mesh.node_count(),
                                             std::vector<ActingCondition>{{&air, {mesh.find_surface("top")}}});
  double flow = 0, heat = 0;
  for (const FilmFacet& f : b.films)
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) flow += f.matrix[i][j] * 50;
  for (double q : b.heat) heat += q;
  EXPECT_NEAR(flow - heat, 15 * 6 * (50 - 20), 1e-10);
}

TEST(Loads, nodal_areas_of_a_grid_count_quarter_half_and_whole_cells) {
  const Mesh mesh = brick({2, 2, 1}, {2, 2, 1});
  std::vector<double> area(mesh.points.size(), 0);
  add_nodal_areas(mesh, mesh.corners, *mesh.find_surface("top"), area);
  const double expected[9] = {0.25, 0.5, 0.25, 0.5, 1, 0.5, 0.25, 0.5, 0.25};
  for (int n = 0; n < 9; ++n) {
    EXPECT_EQ(area[n], 0);
    EXPECT_NEAR(area[9 + n], expected[n], 1e-15);
  }
  const SurfaceArea top = surface_area(mesh, *mesh.find_surface("top"));
  EXPECT_NEAR(top.area, 4, 1e-14);
  EXPECT_NEAR(top.moment.x, 4, 1e-14);
  EXPECT_NEAR(top.moment.z, 4, 1e-14);
}

TEST(Loads, a_load_acts_on_the_copies_that_belong_to_the_owner_of_the_facet) {
  const Mesh mesh = brick({2, 1, 1}, {2, 1, 1});
  std::vector<int> own(16);  // every element has its own eight nodes
  std::iota(own.begin(), own.end(), 0);
  std::vector<double> force(48, 0);
  add_water_pressure(mesh, own, *mesh.find_surface("right"), {1, 1000, 10}, force);
  for (int n = 0; n < 16; ++n) EXPECT_EQ(force[3 * n] != 0, n == 9 || n == 10 || n == 13 || n == 14) << n;
  EXPECT_NEAR(total(force).x, -5000, 1e-9);
}

// -------------------------------------------------------------- which conditions act

Condition fixed_temperature(const char* name, std::vector<std::string> surfaces, double value) {
  Condition c;
  c.noun = "fixed_temperature";
  c.name = name;
  c.surfaces = std::move(surfaces);
  c.kind = FixedTemperature{{value, {}}, {}, {}};
  return c;
}

TEST(Conditions, a_later_stage_replaces_the_same_noun_on_the_same_surface_only) {
  Model model;
  model.mesh = brick({1, 1, 1}, {1, 1, 1});
  model.conditions = {fixed_temperature("summer", {"left", "right"}, 20), fixed_temperature("winter", {"right"}, 2)};
  model.conditions[1].everywhere = false;
  model.stages.resize(2);
  model.stages[1].apply = {1};
  EXPECT_EQ(acting_conditions(model, 0).size(), 1u);
  const auto acting = acting_conditions(model, 1);
  ASSERT_EQ(acting.size(), 2u);
  ASSERT_EQ(acting[0].surfaces.size(), 1u);
  EXPECT_EQ(acting[0].surfaces[0]->name, "left");
  const ThermalBoundary b = thermal_boundary(model.mesh, model.mesh.corners, 8, acting);
  for (std::size_t i = 0; i < b.fixed_nodes.size(); ++i)
    EXPECT_EQ(b.fixed_temperature[i], model.mesh.points[b.fixed_nodes[i]].x > 0.5 ? 2 : 20);
}

TEST(Conditions, removed_by_name_and_applied_again_later) {
  Model model;
  model.mesh = brick({1, 1, 1}, {1, 1, 1});
  model.conditions = {fixed_temperature("heater", {"left"}, 50)};
  model.conditions[0].everywhere = false;
  model.stages.resize(3);
  model.stages[0].apply = {0};
  model.stages[1].remove = {"heater"};
  model.stages[2].apply = {0};
  EXPECT_EQ(acting_conditions(model, 0).size(), 1u);
  EXPECT_EQ(acting_conditions(model, 1).size(), 0u);
  EXPECT_EQ(acting_conditions(model, 2).size(), 1u);
}

TEST(Conditions, conditions_given_together_all_act_and_the_later_fixed_temperature_wins_on_shared_nodes) {
  Model model;
  model.mesh = brick({1, 1, 1}, {1, 1, 1});
  model.conditions = {fixed_temperature("air", {"left"}, 20), fixed_temperature("water", {"left"}, 8)};
  std::get<FixedTemperature>(model.conditions[1].kind).below = 0.5;
  model.stages.resize(1);
  const ThermalBoundary b = thermal_boundary(model.mesh, model.mesh.corners, 8, acting_conditions(model, 0));
  ASSERT_EQ(b.fixed_nodes.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_EQ(b.fixed_temperature[i], model.mesh.points[b.fixed_nodes[i]].z > 0.5 ? 20 : 8);
}

TEST(Conditions, an_unknown_surface_is_an_error_that_names_it) {
  Model model;
  model.mesh = brick({1, 1, 1}, {1, 1, 1});
  model.conditions = {fixed_temperature("air", {"lfet"}, 20)};
  model.conditions[0].where = {"dam.lua", 12};
  model.stages.resize(1);
  try {
    acting_conditions(model, 0);
    FAIL();
  } catch (const DeckError& error) {
    EXPECT_STREQ(error.what(), "dam.lua:12: fixed_temperature: there is no surface 'lfet'");
  }
}

}  // namespace
}  // namespace ashlar
