#include "solve/thermal.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/brick.hpp"

namespace ashlar {
namespace {

constexpr double day = 86400;

Condition condition(const char* noun, std::vector<std::string> surfaces, Condition::Kind kind) {
  Condition c;
  c.noun = noun;
  c.surfaces = std::move(surfaces);
  c.kind = std::move(kind);
  return c;
}
Condition fixed(const char* surface, double value) {
  return condition("fixed_temperature", {surface}, FixedTemperature{{value, {}}, {}, {}});
}
Condition film(std::vector<std::string> surfaces, double coefficient, double ambient) {
  return condition("convection", std::move(surfaces), Convection{{ambient, {}}, coefficient, {}, {}});
}
Condition flux(const char* surface, double value) { return condition("flux", {surface}, Flux{{value, {}}}); }

/// Concrete of the reference cases: k 2.7, rho 2400, c 960.
Model concrete(Mesh mesh, std::vector<Condition> conditions) {
  Model model;
  model.mesh = std::move(mesh);
  model.materials.resize(1);
  Material& m = model.materials[0];
  m.name = "concrete";
  m.regions = {"body"};
  m.values = {{"young", 30e9}, {"poisson", 0.2}};
  m.density = 2400;
  m.conductivity = 2.7;
  m.heat_capacity = 960;
  model.conditions = std::move(conditions);
  return model;
}

/// A bar along x with one cell across; cells follow the given places.
Mesh bar(const std::vector<double>& x, Shape shape = Shape::hex8) {
  const int cells = static_cast<int>(x.size()) - 1;
  return brick(
      {cells, 1, 1},
      [&](const Vec3<double>& p) {
        return Vec3<double>{x[std::lround(p.x * cells)], 0.05 * p.y, 0.05 * p.z};
      },
      shape);
}
std::vector<double> even(double length, int cells) {
  std::vector<double> x;
  for (int i = 0; i <= cells; ++i) x.push_back(length * i / cells);
  return x;
}
/// 60 cells of 0.05 m, then growing by a tenth each to 25 m: a half space for 100 days of heat.
std::vector<double> half_space() {
  std::vector<double> x = even(3, 60);
  for (double h = 0.05; x.back() < 25; h *= 1.1) x.push_back(x.back() + h);
  return x;
}

double near(const Model& model, const std::vector<double>& temperature, const Vec3<double>& place) {
  int best = 0;
  for (int n = 1; n < model.mesh.node_count(); ++n)
    if (norm(model.mesh.points[n] - place) < norm(model.mesh.points[best] - place)) best = n;
  EXPECT_NEAR(norm(model.mesh.points[best] - place), 0, 1e-9);
  return temperature[best];
}

/// Thermal stages of the given ends, s, run one after the other from a uniform start.
class HeatRun {
 public:
  HeatRun(Model m, double start, const std::vector<double>& ends, RunOptions options = {Precision::double_precision, 1})
      : model(std::move(m)) {
    double before = 0;
    for (const double end : ends) {
      Stage stage;
      stage.name = "heat";
      stage.solve = ThermalSolve{false, end - before, 1e-10};
      model.stages.push_back(stage);
      before = end;
    }
    begin(start, options);
  }
  /// One steady stage.
  HeatRun(Model m, double start, Precision precision = Precision::double_precision) : model(std::move(m)) {
    Stage stage;
    stage.name = "steady";
    stage.solve = ThermalSolve{true, 0, 1e-10};
    model.stages.push_back(stage);
    begin(start, {precision, 1});
  }
  ThermalResult next() { return solve_thermal(*problem, stage++); }
  double at(const Vec3<double>& place) const { return near(model, read_temperature(*problem), place); }

  Model model;
  std::unique_ptr<Problem> problem;
  int stage = 0;

 private:
  void begin(double start, const RunOptions& options) {
    problem = std::make_unique<Problem>(model, options);
    write_temperature(*problem, *problem->backend, std::vector<double>(model.mesh.node_count(), start));
  }
};

class SlabOf : public testing::TestWithParam<Shape> {};
INSTANTIATE_TEST_SUITE_P(Shapes, SlabOf, testing::Values(Shape::hex8, Shape::wedge6, Shape::tet4),
                         [](const auto& info) { return shape_name(info.param); });

TEST_P(SlabOf, p19_slab_between_two_given_temperatures_follows_the_series) {
  HeatRun run(concrete(bar(even(1, 20), GetParam()), {fixed("left", 28.2), fixed("right", 19.5)}), 15,
              {1 * day, 5 * day, 20 * day});
  for (const double expected : {19.7022, 23.7738, 23.8500}) {
    ASSERT_TRUE(run.next().converged);
    EXPECT_NEAR(run.at({0.5, 0, 0}), expected, 0.05);
  }
}

TEST_P(SlabOf, p20_slab_in_air_follows_heisler) {
  // half the slab: x = 0 is its middle
  HeatRun run(concrete(bar(even(1, 20), GetParam()), {film({"right"}, 15, -1.6)}), 28.2, {1 * day, 5 * day, 20 * day});
  const double expected[3][3] = {{27.4530, 23.5733, 6.8232}, {13.4467, 10.2202, 1.9175}, {-.5953, -.8109, -1.3653}};
  for (const auto& t : expected) {
    ASSERT_TRUE(run.next().converged);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(run.at({0.5 * i, 0, 0}), t[i], 0.1);
  }
}

TEST(HalfSpace, p21_given_surface_temperature) {
  HeatRun run(concrete(bar(half_space()), {fixed("left", 28.2)}), 15, {1 * day, 10 * day, 100 * day});
  const double expected[3][2] = {{18.5181, 15.0001}, {24.5742, 17.1105}, {27.0322, 23.6687}};
  for (const auto& t : expected) {
    run.next();
    EXPECT_NEAR(run.at({0.5, 0, 0}), t[0], 0.1);
    EXPECT_NEAR(run.at({2, 0, 0}), t[1], 0.1);
  }
}

TEST(HalfSpace, p22_given_heat_flux) {
  HeatRun run(concrete(bar(half_space()), {flux("left", 20)}), 15, {1 * day, 10 * day, 100 * day});
  const double expected[3][3] = {{17.6596, 15.4475, 15.0000}, {23.4104, 20.2206, 15.7638}, {41.5962, 38.0565, 29.3657}};
  for (const auto& t : expected) {
    run.next();
    EXPECT_NEAR(run.at({0, 0, 0}), t[0], 0.1);
    EXPECT_NEAR(run.at({0.5, 0, 0}), t[1], 0.1);
    EXPECT_NEAR(run.at({2, 0, 0}), t[2], 0.1);
  }
}

TEST(HalfSpace, p23_film_to_air) {
  HeatRun run(concrete(bar(half_space()), {film({"left"}, 15, 28.2)}), 15, {1 * day, 10 * day, 100 * day});
  const double expected[3][3] = {{24.4689, 17.0449, 15.0000}, {26.8882, 23.3919, 16.6939}, {27.7794, 26.6160, 23.2943}};
  for (const auto& t : expected) {
    run.next();
    EXPECT_NEAR(run.at({0, 0, 0}), t[0], 0.1);
    EXPECT_NEAR(run.at({0.5, 0, 0}), t[1], 0.1);
    EXPECT_NEAR(run.at({2, 0, 0}), t[2], 0.1);
  }
}

TEST_P(SlabOf, p24_steady_wall_between_two_films_is_exact) {
  // q = (28.2 - 19.5) / (1/15 + 3/2.7 + 1/500) = 7.3743 W/m2
  HeatRun run(concrete(bar(even(3, 7), GetParam()), {film({"left"}, 15, 28.2), film({"right"}, 500, 19.5)}), 15);
  const ThermalResult result = run.next();
  EXPECT_TRUE(result.converged) << result.stop_reason;
  const double q = (28.2 - 19.5) / (1 / 15.0 + 3 / 2.7 + 1 / 500.0);
  EXPECT_NEAR(q, 7.3743, 5e-5);
  EXPECT_NEAR(run.at({0, 0, 0}), 28.2 - q / 15, 1e-8);
  EXPECT_NEAR(run.at({3, 0.05, 0.05}), 19.5 + q / 500, 1e-8);
}

TEST(Steady, p26_nafems_t4_agrees_with_the_same_mesh_of_calculix) {
  // 0.6 x 1.0, k 52, bottom 100, left insulated, right and top h 750 to 0; T(0.6, 0.2): 18.25 in the limit
  const auto at_target = [](int nx, int nz) {
    Model model = concrete(brick({nx, 1, nz}, Vec3<double>{0.6, 0.05, 1.0}),
                           {film({"right", "top"}, 750, 0), fixed("bottom", 100)});
    model.materials[0].conductivity = 52;
    HeatRun run(std::move(model), 0);
    EXPECT_TRUE(run.next().converged);
    return run.at({0.6, 0, 0.2});
  };
  EXPECT_NEAR(at_target(6, 10), 17.954, 1e-3);
  EXPECT_NEAR(at_target(12, 20), 18.093, 1e-3);
}

TEST(Steady, answer_does_not_depend_on_the_start_and_a_second_solve_finds_nothing_to_do) {
  const Mesh mesh = brick({4, 3, 5}, Vec3<double>{2, 1, 3});
  const std::vector<Condition> conditions{film({"right", "top"}, 15, -1.6), fixed("bottom", 10.3), flux("left", 20)};
  HeatRun cold(concrete(mesh, conditions), -300), hot(concrete(mesh, conditions), 700);
  ASSERT_TRUE(cold.next().converged);
  ASSERT_TRUE(hot.next().converged);
  const auto a = read_temperature(*cold.problem), b = read_temperature(*hot.problem);
  for (std::size_t n = 0; n < a.size(); ++n) EXPECT_NEAR(a[n], b[n], 1e-6);
  hot.stage = 0;
  const ThermalResult again = hot.next();
  EXPECT_TRUE(again.converged);
  EXPECT_LE(again.steps, 60);
}

TEST(Steady, heat_in_equals_heat_out) {
  HeatRun run(concrete(brick({4, 3, 5}, Vec3<double>{2, 1, 3}),
                       {film({"right"}, 15, -1.6), fixed("bottom", 10.3), flux("left", 20)}),
              15);
  ASSERT_TRUE(run.next().converged);
  // at held nodes, flow minus heat is what the bottom supplies; through the film leaves h A (T - ambient)
  Backend& backend = *run.problem->backend;
  const auto flow = backend.read(Field::heat_flow), heat = backend.read(Field::heat), held = backend.read(Field::held);
  double bottom = 0, free = 0;
  for (std::size_t n = 0; n < flow.size(); ++n) (held[n] != 0 ? bottom : free) += flow[n] - heat[n];
  EXPECT_NEAR(free, 0, 1e-7);
  const auto t = read_temperature(*run.problem);
  std::vector<double> area(t.size(), 0);
  add_nodal_areas(run.model.mesh, run.model.mesh.corners, *run.model.mesh.find_surface("right"), area);
  double film_out = 0;
  for (std::size_t n = 0; n < t.size(); ++n) film_out += 15 * area[n] * (t[n] + 1.6);
  EXPECT_NEAR(film_out, 20 * 3 * 1 + bottom, 1e-7);
}

TEST(Steady, without_any_given_temperature_is_an_error) {
  HeatRun run(concrete(bar(even(1, 2)), {flux("left", 20)}), 15);
  EXPECT_THROW(run.next(), DeckError);
}

TEST(Steady, a_material_without_conductivity_is_an_error_that_names_it) {
  Model model = concrete(bar(even(1, 2)), {fixed("left", 20)});
  model.materials[0].conductivity.reset();
  model.materials[0].where = {"dam.lua", 7};
  HeatRun run(std::move(model), 15);
  try {
    run.next();
    FAIL();
  } catch (const DeckError& error) {
    EXPECT_STREQ(error.what(),
                 "dam.lua:7: material 'concrete': missing 'conductivity' [W/(m K)], needed by stage 'steady'");
  }
}

TEST(Steady, single_precision_reaches_its_own_rounding_and_says_so) {
  HeatRun run(
      concrete(brick({6, 1, 10}, Vec3<double>{0.6, 0.05, 1.0}), {film({"right", "top"}, 750, 0), fixed("bottom", 100)}),
      0, Precision::single_precision);
  const ThermalResult result = run.next();
  EXPECT_TRUE(result.converged || result.stop_reason == "precision limit") << result.stop_reason;
  HeatRun exact(
      concrete(brick({6, 1, 10}, Vec3<double>{0.6, 0.05, 1.0}), {film({"right", "top"}, 750, 0), fixed("bottom", 100)}),
      0);
  ASSERT_TRUE(exact.next().converged);
  EXPECT_NEAR(run.at({0.6, 0, 0.2}), exact.at({0.6, 0, 0.2}), 2e-3);
}

// -------------------------------------------------------------- explicit limit

/// A bar hot in the middle, marched with a forced step; returns the largest and smallest temperature met on the way.
std::pair<double, double> forced_march(double step_over_limit, int steps) {
  const double h = 0.05, a = 2.7 / (2400 * 960.0), limit = h * h / (2 * a);  // one-dimensional, lumped
  HeatRun run(concrete(bar(even(1, 20)), {fixed("left", 0), fixed("right", 0)}), 0, {1.0});
  run.next();  // sets the boundary
  std::vector<double> start(run.model.mesh.node_count(), 0);
  for (int n = 0; n < run.model.mesh.node_count(); ++n)
    if (std::abs(run.model.mesh.points[n].x - 0.5) < 1e-9) start[n] = 1;
  write_temperature(*run.problem, *run.problem->backend, start);
  Controls controls;
  controls.time_step = step_over_limit * limit;
  double low = 0, high = 1;
  for (int s = 0; s < steps; ++s) {
    run.problem->backend->run(Phase::heat_flow);
    run.problem->backend->run(Phase::step_heat, controls);
    for (const double t : read_temperature(*run.problem)) {
      low = std::min(low, t);
      high = std::max(high, t);
    }
  }
  return {low, high};
}

TEST(Explicit, p27_blows_up_above_the_limit_and_makes_no_new_extremum_below_half_of_it) {
  const auto wild = forced_march(1.05, 600);
  EXPECT_GT(wild.second, 10);
  EXPECT_LE(forced_march(0.99, 600).second, 1);
  const auto monotone = forced_march(0.5, 600);
  EXPECT_LE(monotone.second, 1 + 1e-12);
  EXPECT_GE(monotone.first, -1e-12);
}

TEST(Explicit, p27_the_engine_keeps_to_half_the_limit_with_and_without_film) {
  const double h = 0.05, a = 2.7 / (2400 * 960.0);
  HeatRun run(concrete(bar(even(1, 20)), {fixed("left", 28.2)}), 15, {20 * day});
  const double step = run.next().time_step;
  EXPECT_LE(step, 0.5 * h * h / (2 * a));
  EXPECT_GE(step, 0.1 * h * h / (2 * a));
  // a film of 5000 W/m2K on every side makes the surface nodes far faster than conduction does
  HeatRun windy(concrete(bar(even(1, 20)), {film({"left", "right", "front", "back", "top", "bottom"}, 5000, -1.6)}),
                28.2, {2 * day});
  EXPECT_TRUE(windy.next().converged);
  for (const double t : read_temperature(*windy.problem)) EXPECT_NEAR(t, -1.6, 1e-6);
}

TEST(Explicit, short_stages_still_take_two_hundred_steps) {
  HeatRun run(concrete(bar(even(1, 20)), {fixed("left", 28.2)}), 15, {10.0});
  EXPECT_EQ(run.next().steps, 200);
}

TEST(Explicit, a_transient_ends_in_the_steady_state) {
  const std::vector<Condition> conditions{fixed("left", 28.2), film({"right"}, 15, -1.6)};
  HeatRun transient(concrete(bar(even(1, 10)), conditions), 15, {100 * day}),
      steady(concrete(bar(even(1, 10)), conditions), 15);
  transient.next();
  steady.next();
  const auto a = read_temperature(*transient.problem), b = read_temperature(*steady.problem);
  for (std::size_t n = 0; n < a.size(); ++n) EXPECT_NEAR(a[n], b[n], 1e-4);
}

TEST(Explicit, watch_sees_time_pass_and_can_stop_the_stage) {
  HeatRun run(concrete(bar(even(1, 4)), {fixed("left", 28.2)}), 15, {1000.0});
  const ThermalResult result = solve_thermal(*run.problem, 0, [](const ThermalProgress& p) {
    EXPECT_NEAR(p.time, 1000 * p.fraction, 1e-9);
    return p.step == 50;
  });
  EXPECT_TRUE(result.interrupted);
  EXPECT_EQ(result.steps, 50);
  EXPECT_EQ(result.stop_reason, "interrupted");
}

TEST(Heat, same_bits_with_one_two_and_three_threads) {
  std::vector<std::vector<double>> answers;
  for (const int threads : {1, 2, 3}) {
    // over 1024 elements, several patches
    HeatRun run(
        concrete(brick({12, 10, 12}, Vec3<double>{3, 2, 3}), {fixed("left", 28.2), film({"right", "top"}, 15, -1.6)}),
        15, {0.5 * day}, {Precision::double_precision, threads});
    Stage steady;
    steady.name = "steady";
    steady.solve = ThermalSolve{true, 0, 1e-6};
    run.model.stages.push_back(steady);
    run.next();
    run.next();
    answers.push_back(read_temperature(*run.problem));
  }
  EXPECT_EQ(answers[0], answers[1]);
  EXPECT_EQ(answers[0], answers[2]);
}

// -------------------------------------------------------------- prescribed temperatures

TEST(Prescribed, initial_temperature_acts_once_and_a_field_whenever_it_is_in_force) {
  Model model = concrete(bar(even(1, 2)), {});
  model.conditions = {
      condition("initial_temperature", {}, InitialTemperature{{12, {}}, {}}),
      condition("temperature_field", {}, TemperatureField{{0, [](const Vec3<double>& p) { return 20 * p.x; }}})};
  model.conditions[1].everywhere = false;
  model.stages.resize(2);
  model.stages[1].apply = {1};
  std::vector<double> temperature(model.mesh.node_count(), 5);
  prescribe_temperature(model, 0, temperature);
  for (const double t : temperature) EXPECT_EQ(t, 12);
  temperature.assign(temperature.size(), 7);
  prescribe_temperature(model, 1, temperature);
  for (int n = 0; n < model.mesh.node_count(); ++n) EXPECT_EQ(temperature[n], 20 * model.mesh.points[n].x);
}

}  // namespace
}  // namespace ashlar
