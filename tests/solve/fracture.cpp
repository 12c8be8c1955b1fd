#include "solve/fracture.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "solve/static_case.hpp"
#include "support/brick.hpp"

namespace ashlar {
namespace {

using test::StaticCase;

constexpr double young = 20e9, density = 2400, g = 9.81, expansion = 1e-5;
const Relaxation tight{.tolerance = 1e-9};

/// A bar of unit section and `cells` cubes along z, cracking between them; nu = 0.
Model bar(int cells, const std::string& law, std::map<std::string, double> values) {
  Model model;
  model.mesh = brick({1, 1, cells}, [=](const Vec3<double>& p) { return Vec3<double>{p.x, p.y, cells * p.z}; });
  Material concrete;
  concrete.name = "concrete";
  concrete.regions = {"body"};
  concrete.density = density;
  concrete.values = {{"young", young}, {"poisson", 0.0}, {"expansion", expansion}};
  model.materials = {concrete};
  model.interfaces = {{"cracks", {}, true, {"body"}, law, std::move(values)}};
  return model;
}

TEST(fracture, P33_a_stack_of_blocks_settles_by_its_blocks_and_its_contacts) {
  const int n = 6;
  const double k_n = 1e11, weight = density * g;
  const auto model = bar(n, "elastic", {{"normal_stiffness", k_n}, {"shear_stiffness", k_n}});
  StaticCase column(model, tight);
  column.fix("bottom", 7);
  column.gravity({0, 0, -g});
  Fracture stage(column.problem(), column.links(), 0);
  ASSERT_TRUE(stage.settle(1)) << stage.stop_reason();
  double settlement = 0;  // the lowest block stands on the fixed nodes without contacts
  for (int i = 0; i < n; ++i)
    settlement += (i > 0 ? (n - i) * weight / k_n : 0) + ((n - i - 1) * weight + weight / 2) / young;
  EXPECT_NEAR(-column.displacement_of(model.mesh.node_count() - 1).z, settlement, 1e-6 * settlement);
}

// P39: a bar fixed at both ends cracks when cooled by f_t / (E alpha); springs make the bar softer by 1 / (k_n h).
TEST(fracture, P39_a_cooled_bar_cracks_at_its_tensile_strength) {
  const int n = 5;
  const double strength = 1.5e6, cooling = -20, k_n = 1e13;
  const auto model = bar(n, "brittle",
                         {{"tensile_strength", strength},
                          {"cohesion", 1e7},
                          {"friction", 0.7},
                          {"normal_stiffness", k_n},
                          {"shear_stiffness", k_n}});
  StaticCase fixed_bar(model, tight);
  fixed_bar.fix("bottom", 7);
  fixed_bar.fix("top", 7);
  auto links = fixed_bar.links();
  links.set_load_factor = [&](double factor) { fixed_bar.warm(factor * cooling); };
  std::vector<double> increments;
  links.increment_reached = [&](double factor) { increments.push_back(factor); };
  Fracture stage(fixed_bar.problem(), links, 100);
  ASSERT_TRUE(stage.advance(10)) << stage.stop_reason();

  StageResult result;
  stage.fill(result);
  ASSERT_FALSE(result.events.empty());
  const double softer = 1 + (n - 1) * young / (k_n * n);
  const double expected = strength * softer / (young * expansion * -cooling);
  EXPECT_NEAR(result.events[0].load_factor, expected, 2e-3 * expected);
  EXPECT_GE(result.events[0].load_factor, expected * (1 - 1e-6));
  EXPECT_EQ(result.events[0].mode, "tension");
  EXPECT_EQ(result.events[0].interface, "cracks");
  EXPECT_EQ(increments.size(), 10u);
  // All sections are equally loaded and none breaks alone: one group of all contact points.
  EXPECT_EQ(result.events[0].contact_points, 4 * (n - 1));
  EXPECT_NEAR(result.cracked_area, n - 1, 1e-12);
  EXPECT_NEAR(result.cracked_area_by_direction["horizontal"], n - 1, 1e-12);
}

// P40: gravity in a column fixed at both ends gives +- rho g H / 2 at its ends; cooling then cracks the top first, at
// E alpha |dT| + rho g H / 2 = f_t. Contacts lie one cell below the top: rho g (H/2 - h) there.
TEST(fracture, P40_a_cooled_column_cracks_near_its_top_first) {
  const int n = 20;
  const double strength = 1.5e6, cooling = -20, k_n = 1e13;
  const auto model = bar(n, "brittle",
                         {{"tensile_strength", strength},
                          {"cohesion", 1e7},
                          {"friction", 0.7},
                          {"normal_stiffness", k_n},
                          {"shear_stiffness", k_n}});
  StaticCase column(model, tight);
  column.fix("bottom", 7);
  column.fix("top", 7);
  column.gravity({0, 0, -g});
  auto links = column.links();
  links.set_load_factor = [&](double factor) { column.warm(factor * cooling); };
  Fracture stage(column.problem(), links, 100);
  ASSERT_TRUE(stage.advance(10)) << stage.stop_reason();

  StageResult result;
  stage.fill(result);
  ASSERT_FALSE(result.events.empty());
  const double weight_stress = density * g * (0.5 * n - 1);
  const double expected = (strength - weight_stress) / (young * expansion * -cooling);
  EXPECT_NEAR(result.events[0].load_factor, expected, 5e-3 * expected);
  EXPECT_EQ(result.events[0].place.z, n - 1);
  EXPECT_EQ(result.events[0].contact_points, 4);
  // The crack relieves the bar: the upper part hangs from the top, the lower part stands.
  EXPECT_EQ(result.free_blocks.size(), 0u);
}

}  // namespace
}  // namespace ashlar
