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
  Fracture stage(column.problem(), column.links(), {.max_events = 0});
  ASSERT_TRUE(stage.settle(1)) << stage.stop_reason();
  double settlement = 0;  // the lowest block stands on the fixed nodes without contacts
  for (int i = 0; i < n; ++i)
    settlement += (i > 0 ? (n - i) * weight / k_n : 0) + ((n - i - 1) * weight + weight / 2) / young;
  EXPECT_NEAR(-column.displacement_of(model.mesh.node_count() - 1).z, settlement, 1e-6 * settlement);
}

// Steps are pulled by groups of bonded nodes: after some bonds have gone, those found by taking apart what lost one have
// to be those that a look at everything finds.
TEST(fracture, virtual_mass_follows_cracks_as_if_it_were_set_anew) {
  Model model;
  model.mesh = brick({3, 3, 3}, [](const Vec3<double>& p) { return 3.0 * p; });
  model.materials = bar(1, "brittle", {}).materials;
  model.interfaces = {{"cracks", {}, true, {"body"}, "brittle",
                       {{"tensile_strength", 1e6}, {"cohesion", 2e6}, {"friction", 0.7}}}};
  StaticCase blocks(model, tight);
  blocks.fix("bottom", 7);
  const Problem& p = blocks.problem();
  Backend& b = *p.backend;
  std::vector<double> u(3 * p.blocks.node_count());
  for (std::size_t i = 0; i < u.size(); ++i) u[i] = 1e-6 * std::sin(0.7 * double(i));
  b.write(Field::displacement, u);
  const auto relaxed = [&] {
    b.write(Field::displacement, u);
    b.run(Phase::stop_nodes);
    b.relax({.viscous_damping = 0.1}, 5);
    return b.read(Field::displacement);
  };
  VirtualMass mass(p, b, tight);
  mass.set();
  const auto bonded = b.read(Field::inverse_mass);
  int cracked = 0;
  for (int event = 0; event < 20; ++event) {
    b.write(Field::displacement, u);
    const CrackMeasure broken = b.break_springs(b.largest_utilisation(), 0.9);
    cracked += broken.count;
    ASSERT_GT(broken.count, 0);
    mass.set();
    const auto inverse_mass = b.read(Field::inverse_mass), moved = relaxed();
    set_virtual_mass(p, b, tight);
    EXPECT_EQ(b.read(Field::inverse_mass), inverse_mass);
    EXPECT_EQ(relaxed(), moved);
  }
  EXPECT_NE(b.read(Field::inverse_mass), bonded) << "no group fell apart";
  EXPECT_LT(cracked, p.contacts.count()) << "nothing is left to be grouped";
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
  fixed_bar.fix("bottom", 4);
  fixed_bar.fix("top", 4);
  fixed_bar.fix("left", 1);
  fixed_bar.fix("front", 2);
  auto links = fixed_bar.links();
  links.set_load_factor = [&](double factor) { fixed_bar.warm(factor * cooling); };
  std::vector<double> increments;
  links.increment_reached = [&](double factor, const Dissipation<double>&) { increments.push_back(factor); };
  Fracture stage(fixed_bar.problem(), links, {.max_events = 100});
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
  // The three blocks in the middle float; held in place, they still shrink freely.
  EXPECT_EQ(result.free_blocks, (std::vector<int>{1, 2, 3}));
  fixed_bar.problem().backend->run(Phase::block_stress);
  double left_over = 0;
  for (const double stress : fixed_bar.problem().backend->read(Field::stress))
    left_over = std::max(left_over, std::abs(stress));
  EXPECT_LT(left_over, 1e-6 * strength);
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
  Fracture stage(column.problem(), links, {.max_events = 100});
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

/// Two cubes of 1 m on top of each other with a joint between them; nu = 0.
Model pair(const std::string& law, std::map<std::string, double> values) {
  Model model = bar(2, law, std::move(values));
  model.mesh.region_names = {"lower", "upper"};
  model.mesh.regions = {0, 1};
  model.materials[0].regions = {"lower", "upper"};
  model.interfaces[0].name = "seam";
  model.interfaces[0].crackable = false;
  model.interfaces[0].regions = {"lower", "upper"};
  return model;
}

/// Gravity as a slope of angle theta feels it.
Vec3<double> on_slope(double theta) { return {g * std::sin(theta), 0, -g * std::cos(theta)}; }

constexpr double degree = 3.14159265358979323846 / 180;

// P34: a block on a slope stays below the friction angle and slides above it.
TEST(fracture, P34_a_block_on_a_slope_stays_up_to_its_friction_angle) {
  const auto model = pair("frictional", {{"friction", 30 * degree}});
  for (const double angle : {29.5, 30.5}) {
    StaticCase slope(model, {.tolerance = 1e-7});
    slope.fix("bottom", 7);
    slope.gravity(on_slope(angle * degree));
    Fracture stage(slope.problem(), slope.links(), {.max_events = 0});
    EXPECT_EQ(stage.settle(1), angle < 30) << angle;
    EXPECT_EQ(stage.stop_reason(), angle < 30 ? "converged" : "moves without limit");
  }
}

TEST(fracture, sliding_equilibrium_does_not_depend_on_damping) {
  // The upper block is pushed along the seam by half of what its weight and a load can hold, its foot lifts on one
  // side.
  const auto model = pair("frictional", {{"friction", 30 * degree}, {"stiffness_factor", 10}});
  std::vector<std::vector<double>> answers;
  for (const Damping damping : {Damping::adaptive, Damping::local}) {
    StaticCase block(model, {.tolerance = 1e-9, .damping = damping});
    block.fix("bottom", 7);
    block.gravity({0, 0, -g});
    block.pressure("top", {1.5e4, 0, -2e4});
    Fracture stage(block.problem(), block.links(), {.max_events = 0});
    ASSERT_TRUE(stage.settle(1)) << stage.stop_reason();
    answers.push_back(block.displacement());
    double slid = 0;
    for (const double slip : block.problem().backend->read(Field::slip)) slid = std::max(slid, std::abs(slip));
    EXPECT_GT(slid, 1e-8);
    StageResult result;
    stage.fill(result);
    EXPECT_GT(result.dissipated_energy, 0);
  }
  double size = 0, apart = 0;
  for (std::size_t i = 0; i < answers[0].size(); ++i) {
    size = std::max(size, std::abs(answers[0][i]));
    apart = std::max(apart, std::abs(answers[0][i] - answers[1][i]));
  }
  EXPECT_LT(apart, 1e-6 * size);
}

TEST(fracture, a_block_that_hangs_on_too_weak_a_joint_falls_free_and_is_listed) {
  auto model = pair("brittle", {{"tensile_strength", 1e4}, {"cohesion", 1e6}, {"friction", 0.5}});
  StaticCase hanging(model, {.tolerance = 1e-7, .max_steps = 100000});
  hanging.fix("top", 7);
  hanging.gravity({0, 0, -g});  // 23.5 kPa
  Fracture stage(hanging.problem(), hanging.links(), {.max_events = 100});
  EXPECT_TRUE(stage.settle(1)) << stage.stop_reason();
  StageResult result;
  stage.fill(result);
  ASSERT_EQ(result.events.size(), 1u);
  EXPECT_EQ(result.events[0].mode, "tension");
  EXPECT_EQ(result.free_blocks, std::vector<int>{0});
  EXPECT_NEAR(result.cracked_area, 1, 1e-12);

  // The next stage sets its supports anew: the block stays where it is and is listed again.
  const auto before = hanging.displacement();
  hanging.fix("top", 7);
  Fracture next(hanging.problem(), hanging.links(), {.max_events = 100});
  EXPECT_TRUE(next.settle(1)) << next.stop_reason();
  StageResult later;
  next.fill(later);
  EXPECT_EQ(later.free_blocks, std::vector<int>{0});
  const auto after = hanging.displacement();
  for (std::size_t i = 0; i < after.size(); ++i) EXPECT_NEAR(after[i], before[i], 1e-9);
}

TEST(fracture, a_free_block_that_carries_a_load_stops_the_stage) {
  auto model = pair("brittle", {{"tensile_strength", 1e4}, {"cohesion", 1e6}, {"friction", 0.5}});
  StaticCase pulled(model, {.tolerance = 1e-7, .max_steps = 100000});
  pulled.fix("bottom", 7);
  pulled.pressure("top", {0, 0, 2e4});
  auto links = pulled.links();
  links.surface_load = pulled.problem().to_machine(pulled.load(), 3);
  Fracture stage(pulled.problem(), links, {.max_events = 100});
  EXPECT_FALSE(stage.settle(1));
  EXPECT_EQ(stage.stop_reason(), "block free");
}

TEST(fracture, cracking_in_tension_dissipates_the_energy_of_the_springs) {
  const double strength = 1.5e6, k_n = 1e11;
  const auto model = pair("brittle", {{"tensile_strength", strength},
                                      {"cohesion", 1e7},
                                      {"friction", 0.7},
                                      {"normal_stiffness", k_n},
                                      {"shear_stiffness", k_n}});
  StaticCase cooled(model, tight);
  cooled.fix("bottom", 7);
  cooled.fix("top", 7);
  auto links = cooled.links();
  links.set_load_factor = [&](double factor) { cooled.warm(-20 * factor); };
  Fracture stage(cooled.problem(), links, {.max_events = 100});
  ASSERT_TRUE(stage.advance(5)) << stage.stop_reason();
  StageResult result;
  stage.fill(result);
  ASSERT_EQ(result.events.size(), 1u);
  const double energy = strength * strength / (2 * k_n);  // J/m^2 of 1 m^2, at most 0.5 % over-strength
  EXPECT_GE(result.dissipated_energy, energy);
  EXPECT_LE(result.dissipated_energy, energy * 1.005 * 1.005);
}

TEST(fracture, an_event_limit_stops_the_stage) {
  const auto model = pair("brittle", {{"tensile_strength", 1e4}, {"cohesion", 1e6}, {"friction", 0.5}});
  StaticCase pulled(model, tight);
  pulled.fix("bottom", 7);
  pulled.pressure("top", {0, 0, 2e4});
  Fracture stage(pulled.problem(), pulled.links(), {.max_events = 0});
  EXPECT_FALSE(stage.settle(1));
  EXPECT_EQ(stage.stop_reason(), "event limit");
}

}  // namespace
}  // namespace ashlar
