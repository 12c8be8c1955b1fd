#include <gtest/gtest.h>

#include <numeric>

#include "model/loads.hpp"
#include "support/brick.hpp"

namespace ashlar {
namespace {

/// A skewed body of 2 x 3 x 4 m.
Mesh skewed(Shape shape) {
  return brick(
      {2, 2, 2},
      [](const Vec3<double>& p) {
        return Vec3<double>{2 * p.x + 0.5 * p.z, 3 * p.y, 4 * p.z};
      },
      shape);
}

Resultant sum_of(const Mesh& mesh, const std::vector<double>& force) {
  std::vector<int> all(mesh.points.size());
  std::iota(all.begin(), all.end(), 0);
  return resultant(mesh.points, force, all);
}

class InsideOnShape : public testing::TestWithParam<Shape> {};
INSTANTIATE_TEST_SUITE_P(Shapes, InsideOnShape, testing::Values(Shape::hex8, Shape::wedge6, Shape::tet4),
                         [](const auto& info) { return shape_name(info.param); });

TEST_P(InsideOnShape, a_point_load_keeps_its_force_and_its_moment) {
  const Mesh mesh = skewed(GetParam());
  const Vec3<double> f{3e3, -7e3, 11e3};
  // inside, on a face, on a corner
  for (const Vec3<double>& at : {Vec3<double>{0.9, 1.1, 1.3}, {1.2, 0.7, 4}, {2.5, 3, 4}}) {
    std::vector<double> force(3 * mesh.points.size(), 0);
    add_point_load(mesh, mesh.corners, {at, f}, {}, force);
    const Resultant found = sum_of(mesh, force);
    EXPECT_NEAR(norm(found.force - f), 0, 1e-9);
    EXPECT_NEAR(norm(found.moment - cross(at, f)), 0, 1e-7);
  }
}

TEST(PointLoad, on_a_node_goes_to_that_node_alone_and_to_one_copy_of_it) {
  const Mesh mesh = brick({2, 1, 1}, {2, 1, 1});
  std::vector<int> own(16);  // every element has its own eight nodes
  std::iota(own.begin(), own.end(), 0);
  std::vector<double> force(48, 0);
  add_point_load(mesh, own, {{1, 1, 1}, {0, 0, -5}}, {}, force);
  for (int n = 0; n < 16; ++n) EXPECT_NEAR(force[3 * n + 2], n == 6 ? -5 : 0, 1e-12) << n;
}

TEST(PointLoad, outside_the_body_is_an_error_with_the_line_of_the_deck) {
  const Mesh mesh = brick({1, 1, 1}, {1, 1, 1});
  std::vector<double> force(24, 0);
  try {
    add_point_load(mesh, mesh.corners, {{0.5, 0.5, 1.1}, {0, 0, -5}}, {"dam.lua", 7}, force);
    FAIL();
  } catch (const DeckError& error) {
    EXPECT_EQ(std::string(error.what()).rfind("dam.lua:7: point_load: (0.5, 0.5, 1.1)", 0), 0u) << error.what();
  }
}

TEST_P(InsideOnShape, heat_made_evenly_is_the_volume_times_the_source_at_the_centroid) {
  const Mesh mesh = skewed(GetParam());
  std::vector<double> heat(mesh.points.size(), 0);
  add_heat_source(mesh, mesh.corners, std::vector<int>{0}, {300, {}}, heat);
  double sum = 0;
  Vec3<double> moment;
  for (std::size_t n = 0; n < heat.size(); ++n) sum += heat[n], moment = moment + heat[n] * mesh.points[n];
  EXPECT_NEAR(sum, 300 * 24, 1e-9);
  EXPECT_NEAR(norm((1 / sum) * moment - Vec3<double>{1.25, 1.5, 2}), 0, 1e-13);
}

TEST_P(InsideOnShape, heat_that_grows_with_height_has_the_sum_and_the_centre_of_its_integral) {
  const Mesh mesh = brick({2, 3, 2}, {2, 3, 4}, GetParam());
  Value value;
  value.at = [](const Vec3<double>& p) { return 100 * p.z; };
  std::vector<double> heat(mesh.points.size(), 0);
  add_heat_source(mesh, mesh.corners, std::vector<int>{0}, value, heat);
  double sum = 0, moment = 0;
  for (std::size_t n = 0; n < heat.size(); ++n) sum += heat[n], moment += heat[n] * mesh.points[n].z;
  EXPECT_NEAR(sum, 100 * 6 * 8, 1e-9);            // 2 x 3 x 4^2/2
  EXPECT_NEAR(moment / sum, 2 * 4.0 / 3, 1e-12);  // 4^3/3 over 4^2/2
}

/// A column of two regions, one cell each, 1 m high.
Mesh two_regions() {
  Mesh mesh = brick({1, 1, 2}, {1, 1, 2});
  mesh.region_names = {"old", "lift"};
  mesh.regions = {0, 1};
  return mesh;
}

Condition heat_source(const char* name, std::vector<std::string> regions, double value) {
  return {"heat_source", name, {}, {}, HeatSource{{value, {}}, std::move(regions)}, {}, true};
}

double heat_of(const Model& model, int stage) {
  const ThermalBoundary b =
      thermal_boundary(model.mesh, model.mesh.corners, model.mesh.node_count(), acting_conditions(model, stage));
  return std::accumulate(b.heat.begin(), b.heat.end(), 0.0);
}

TEST(HeatSource, acts_in_its_regions_and_a_later_stage_replaces_it_region_by_region) {
  Model model;
  model.mesh = two_regions();
  model.conditions = {heat_source("all", {}, 10), heat_source("fresh", {"lift"}, 300)};
  model.conditions[1].everywhere = false;
  model.stages.resize(2);
  model.stages[1].apply = {1};
  EXPECT_NEAR(heat_of(model, 0), 10 + 10, 1e-12);
  EXPECT_NEAR(heat_of(model, 1), 10 + 300, 1e-12);
}

TEST(PointLoad, a_later_stage_replaces_the_load_at_the_same_place_only) {
  Model model;
  model.mesh = two_regions();
  const auto load = [](const char* name, double z, double force) {
    return Condition{"point_load", name, {}, {}, PointLoad{{0.5, 0.5, z}, {force, 0, 0}}, {}, true};
  };
  model.conditions = {load("low", 1, 5), load("high", 2, 7), load("more", 2, 70)};
  model.conditions[2].everywhere = false;
  model.stages.resize(2);
  model.stages[1].apply = {2};
  const auto total = [&](int stage) {
    std::vector<double> force(3 * model.mesh.points.size(), 0);
    add_loads(model, model.mesh.corners, acting_conditions(model, stage), force);
    return sum_of(model.mesh, force).force.x;
  };
  EXPECT_NEAR(total(0), 12, 1e-12);
  EXPECT_NEAR(total(1), 75, 1e-12);
}

}  // namespace
}  // namespace ashlar
