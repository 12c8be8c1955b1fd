#include "solve/dynamic.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

#include "model/loads.hpp"
#include "solve/solver.hpp"
#include "support/brick.hpp"

/// Motion in time: cases P13 to P16, sliding, cracking, damping, and what continues from stage to stage.
namespace ashlar {
namespace {

constexpr double pi = std::numbers::pi;

Condition condition(const char* noun, const char* surface, Condition::Kind kind, const char* name = "") {
  Condition c;
  c.noun = noun;
  c.name = name;
  if (surface) c.surfaces = {surface};
  c.kind = std::move(kind);
  return c;
}
Traction traction(double x, double y, double z) {
  Traction t;
  t.x.constant = x, t.y.constant = y, t.z.constant = z;
  return t;
}
Stage stage(const char* name, Solve solve, std::vector<std::string> remove = {}) {
  Stage s;
  s.name = name;
  s.remove = std::move(remove);
  s.solve = solve;
  return s;
}
History history(const char* name, std::optional<Vec3<double>> at, std::vector<std::string> record) {
  History h;
  h.name = name;
  h.at = at;
  h.record = std::move(record);
  return h;
}

Model body(Mesh mesh, double young, double poisson, double density) {
  Model m;
  m.mesh = std::move(mesh);
  m.materials = {
      {"concrete", {}, m.mesh.region_names, "elastic", density, {}, {}, {{"young", young}, {"poisson", poisson}}}};
  return m;
}

RunResult run(const Model& model, RunOptions options = {.threads = 1}) {
  Problem problem(model, options);
  Observer nobody;
  return solve(problem, nobody);
}

/// One column of a history over the rows of a stage.
std::vector<double> column(const RunResult& r, int history, const std::string& name, const std::string& stage) {
  const HistoryTable& table = r.histories.at(history);
  const auto at = std::find(table.columns.begin(), table.columns.end(), name) - table.columns.begin();
  std::vector<double> values;
  for (const auto& row : table.rows)
    if (row.stage == stage) values.push_back(row.values.at(at));
  return values;
}

// ---------------------------------------------------------------- P13

struct CriticalStep {
  Shape shape;
  double assembled;  ///< s, 2 / largest frequency of the unit cube (numpy)
};
class UnitCube : public testing::TestWithParam<CriticalStep> {
 protected:
  Model cube() const {
    Model m = body(brick({1, 1, 1}, Vec3<double>{1, 1, 1}, GetParam().shape), 30e9, 0.2, 2400);
    m.conditions = {condition("traction", "top", traction(1e4, 2e4, 5e4))};
    return m;
  }
  /// Result of 3000 steps of a given share of the assembled critical step.
  StageResult forced(double share) const {
    Model m = cube();
    const double stable = stable_step(Problem(m, {.threads = 1}), 0).together;
    m.stages = {stage("move", DynamicSolve{.duration = 3000 * share * GetParam().assembled,
                                           .time_factor = share * GetParam().assembled / stable})};
    return run(m).stages[0];
  }
};

TEST_P(UnitCube, HasAStableStepBelowTheCriticalOneButNotFarBelow) {
  const Model m = cube();
  const double stable = stable_step(Problem(m, {.threads = 1}), 0).together;
  std::printf("  stable step %.5e s, critical %.5e s: %.3f\n", stable, GetParam().assembled,
              stable / GetParam().assembled);
  EXPECT_LE(stable, GetParam().assembled);
  EXPECT_GE(0.9 * stable, 0.5 * GetParam().assembled);
}

TEST_P(UnitCube, RunsAwayAboveTheCriticalStepAndSaysWhere) {
  const StageResult r = forced(1.02);
  EXPECT_FALSE(r.converged);
  EXPECT_EQ(r.stop_reason.rfind("runaway energy at (", 0), 0u) << r.stop_reason;
  EXPECT_NE(r.stop_reason.find("step " + std::to_string(r.steps)), std::string::npos) << r.stop_reason;
  EXPECT_TRUE(std::isfinite(r.energy.kinetic));
}

TEST_P(UnitCube, StaysBoundedBelowTheCriticalStep) {
  const StageResult r = forced(0.98);
  EXPECT_TRUE(r.converged) << r.stop_reason;
  EXPECT_LT(r.energy.drift, 1e-10);
}

INSTANTIATE_TEST_SUITE_P(P13, UnitCube,
                         testing::Values(CriticalStep{Shape::hex8, 2.1908902e-4},
                                         CriticalStep{Shape::wedge6, 1.7772629e-4},
                                         CriticalStep{Shape::tet4, 1.7346988e-4}));

// ---------------------------------------------------------------- P14, P15, P16

constexpr double length = 10, edge = 0.1, young = 30e9, density = 2400;
const double wave_speed = std::sqrt(young / density);

/// A bar along x, held at x = 0, pulled with 1 MPa at x = length.
Model bar(int elements) {
  Model m = body(brick({elements, 1, 1}, Vec3<double>{length, edge, edge}), young, 0, density);
  m.conditions = {condition("fix", "left", Fix{true, false, false, false}),
                  condition("fix", "front", Fix{false, true, false, false}),
                  condition("fix", "bottom", Fix{false, false, true, false}),
                  condition("traction", "right", traction(1e6, 0, 0), "pull")};
  return m;
}

TEST(dynamic, P14_a_wave_travels_at_the_speed_of_sound_and_doubles_the_static_pull) {
  Model m = bar(100);
  const double step = 0.5 * edge / wave_speed;
  m.stages = {
      stage("pull", DynamicSolve{.duration = 8 * length / wave_speed, .time_step = step, .record_every = step})};
  m.histories = {history("middle", Vec3<double>{5, 0, 0}, {"velocity"}),
                 history("tip", Vec3<double>{10, 0, 0}, {"displacement"}), history("energy", {}, {"energy"})};
  const RunResult r = run(m);
  ASSERT_TRUE(r.stages[0].converged) << r.stages[0].stop_reason;
  EXPECT_NEAR(r.stages[0].time_step, step, 1e-12 * step);

  const auto seconds = column(r, 0, "seconds", "pull"), velocity = column(r, 0, "velocity.x", "pull");
  const double particle_velocity = 1e6 / (density * wave_speed);
  std::size_t arrived = 0;
  while (velocity[arrived] <= 0.5 * particle_velocity) ++arrived;
  const double exact = 5 / wave_speed;
  const auto tip = column(r, 1, "displacement.x", "pull");
  const auto peak = std::max_element(tip.begin(), tip.end());
  std::printf("  arrival %.5e s (exact %.5e), peak %.4f of 2 x static at %.4e s, drift %.1e\n", seconds[arrived], exact,
              *peak / (2 * 1e6 * length / young), seconds[peak - tip.begin()], r.stages[0].energy.drift);
  EXPECT_NEAR(seconds[arrived], exact, 0.03 * exact);
  EXPECT_NEAR(*peak, 2 * 1e6 * length / young, 0.02 * 2 * 1e6 * length / young);

  // P15: eight transits without damping keep the energy.
  EXPECT_LT(r.stages[0].energy.drift, 1e-10);
  EXPECT_GT(r.stages[0].energy.drift, 0);
  const auto work = column(r, 2, "energy.external_work", "pull");
  EXPECT_NEAR(*std::max_element(work.begin(), work.end()), 1e6 * edge * edge * *peak, 1e-3 * 1e6 * edge * edge * *peak);
}

TEST(dynamic, P15_single_precision_keeps_the_energy_to_its_rounding) {
  Model m = bar(100);
  m.stages = {stage("pull", DynamicSolve{.duration = 8 * length / wave_speed})};
  const RunResult r = run(m, {.precision = Precision::single_precision, .threads = 1});
  ASSERT_TRUE(r.stages[0].converged);
  std::printf("  single: drift %.1e\n", r.stages[0].energy.drift);
  EXPECT_LT(r.stages[0].energy.drift, 1e-4);
}

/// How a bar moves in its mode (2 mode - 1) pi x / 2 L after a pull is let go.
struct Swing {
  std::vector<double> seconds, amplitude;
  StageResult result;
};
Swing swing(int elements, DynamicSolve how, int mode) {
  Model m = bar(elements);
  m.stages = {stage("pull", StaticSolve{{.tolerance = 1e-10}}), stage("swing", how, {"pull"})};
  m.outputs.resize(1);
  m.outputs[0].every = 1;
  struct Watch : Observer {
    const Model& model;
    int mode;
    Swing swing;
    Watch(const Model& model, int mode) : model(model), mode(mode) {}
    void output(const Snapshot& s) override {
      double sum = 0;
      for (int n = 0; n < model.mesh.node_count(); ++n) {
        const double x = model.mesh.points[n].x, mass = x == length ? 0.5 : 1;  // the tip has one element, not two
        sum += mass * s.displacement[3 * n] * std::sin((2 * mode - 1) * pi * x / (2 * length));
      }
      swing.amplitude.push_back(sum);
      swing.seconds.push_back((s.time - 1) * std::get<DynamicSolve>(model.stages[1].solve).duration);
    }
  } watch(m, mode);
  Problem problem(m, {.threads = 1});
  const RunResult r = solve(problem, watch);
  EXPECT_TRUE(r.all_converged()) << r.stages.back().stop_reason;
  watch.swing.result = r.stages.back();
  return watch.swing;
}
double frequency_of(int mode) { return (2 * mode - 1) * wave_speed / (4 * length); }

TEST(dynamic, P16_frequencies_of_a_bar) {
  for (const int mode : {1, 2, 3}) {
    const double exact = frequency_of(mode);
    const Swing s = swing(50, {.duration = 10.25 / exact, .record_every = 0.02 / exact}, mode);
    std::vector<double> zeros;
    for (std::size_t i = 1; i < s.amplitude.size(); ++i) {
      const double a = s.amplitude[i - 1], b = s.amplitude[i];
      if ((a > 0) != (b > 0)) zeros.push_back(s.seconds[i - 1] + (s.seconds[i] - s.seconds[i - 1]) * a / (a - b));
    }
    ASSERT_GE(zeros.size(), 19u);
    const double found = 0.5 * static_cast<double>(zeros.size() - 1) / (zeros.back() - zeros.front());
    std::printf("  mode %d: %.3f Hz, exact %.3f\n", mode, found, exact);
    EXPECT_NEAR(found, exact, 0.005 * exact);
  }
}

// ---------------------------------------------------------------- damping

/// Largest amplitude in the last of `periods` over that at the start.
double left_after(const Swing& s, double period, int periods) {
  double largest = 0;
  for (std::size_t i = 0; i < s.seconds.size(); ++i)
    if (s.seconds[i] > (periods - 0.5) * period) largest = std::max(largest, s.amplitude[i]);
  return largest / s.amplitude.front();
}

TEST(dynamic, mass_damping_is_half_its_factor_over_the_frequency) {
  const double ratio = 0.02, period = 1 / frequency_of(1);
  const Swing s = swing(
      20, {.duration = 5.2 * period, .mass_damping = 2 * ratio * 2 * pi / period, .record_every = 0.01 * period}, 1);
  const double left = left_after(s, period, 5), exact = std::exp(-2 * pi * ratio * 5);
  std::printf("  left %.4f, exact %.4f, drift %.1e\n", left, exact, s.result.energy.drift);
  EXPECT_NEAR(left, exact, 0.005 * exact);
  EXPECT_GT(s.result.energy.dissipated, 0);
  EXPECT_LT(s.result.energy.drift, 1e-10);
}

TEST(dynamic, stiffness_damping_is_half_its_factor_times_the_frequency) {
  const double ratio = 0.02, period = 1 / frequency_of(1);
  const Swing s = swing(
      20, {.duration = 5.2 * period, .stiffness_damping = 2 * ratio * period / (2 * pi), .record_every = 0.01 * period},
      1);
  const double left = left_after(s, period, 5), exact = std::exp(-2 * pi * ratio * 5);
  std::printf("  left %.4f, exact %.4f, drift %.1e\n", left, exact, s.result.energy.drift);
  EXPECT_NEAR(left, exact, 0.005 * exact);
  EXPECT_LT(s.result.energy.drift, 1e-10);
}

TEST(dynamic, local_damping_adds_to_what_slows_down_and_takes_from_what_speeds_up) {
  // One element swings with its stiffness times 1 + alpha on the way out, 1 - alpha on the way back: the amplitude of
  // a period is (1 - alpha) / (1 + alpha) of that before.
  const double alpha = 0.1, omega = std::sqrt(young / (density / 2)) / length;
  const double period = pi / omega * (1 / std::sqrt(1 + alpha) + 1 / std::sqrt(1 - alpha));
  const Swing s = swing(1, {.duration = 5.2 * period, .local_damping = alpha, .record_every = 0.01 * period}, 1);
  const double left = left_after(s, period, 5), exact = std::pow((1 - alpha) / (1 + alpha), 5);
  std::printf("  left %.4f, exact %.4f, drift %.1e\n", left, exact, s.result.energy.drift);
  EXPECT_NEAR(left, exact, 0.01 * exact);
  EXPECT_LT(s.result.energy.drift, 1e-10);
}

TEST(dynamic, stiffness_damping_shortens_the_stable_step) {
  const Model m = bar(20);
  const Problem problem(m, {.threads = 1});
  const double free = stable_step(problem, 0).together, damped = stable_step(problem, free).together;
  EXPECT_NEAR(damped / free, std::sqrt(2.0) - 1, 1e-12);  // xi = beta / step = 1
}

// ---------------------------------------------------------------- stages

TEST(dynamic, a_body_in_balance_stays_at_rest) {
  Model m = bar(20);
  m.stages = {stage("pull", StaticSolve{{.tolerance = 1e-12}}), stage("wait", DynamicSolve{.duration = 0.02})};
  m.histories = {history("tip", Vec3<double>{10, 0, 0}, {"displacement", "velocity"})};
  const RunResult r = run(m);
  ASSERT_TRUE(r.all_converged());
  const double pulled = 1e6 * length / young;
  for (const double u : column(r, 0, "displacement.x", "wait")) EXPECT_NEAR(u, pulled, 1e-8 * pulled);
}

TEST(dynamic, two_stages_make_the_same_motion_as_one) {
  Model one = bar(20), two = one;
  one.stages = {stage("all", DynamicSolve{.duration = 0.004})};
  two.stages = {stage("half", DynamicSolve{.duration = 0.002}), stage("rest", DynamicSolve{.duration = 0.002})};
  one.histories = two.histories = {history("tip", Vec3<double>{10, 0, 0}, {"displacement", "velocity"})};
  const RunResult a = run(one), b = run(two);
  ASSERT_EQ(a.stages[0].time_step, b.stages[1].time_step);
  for (const char* name : {"displacement.x", "velocity.x"}) {
    const double whole = a.histories[0].at(name, "all"), parts = b.histories[0].at(name, "rest");
    EXPECT_NEAR(parts, whole, 1e-9 * std::abs(whole)) << name;
  }
}

TEST(dynamic, a_heated_bar_that_is_let_go_swings_about_its_new_length) {
  Model m = bar(20);
  m.materials[0].values["expansion"] = 1e-5;
  m.conditions.pop_back();
  TemperatureField warm;
  warm.value.constant = 20;
  m.conditions.push_back(condition("temperature_field", nullptr, warm));
  m.stages = {stage("swing", DynamicSolve{.duration = 8 * length / wave_speed})};
  m.histories = {history("tip", Vec3<double>{10, 0, 0}, {"displacement"})};
  const RunResult r = run(m);
  ASSERT_TRUE(r.all_converged()) << r.stages[0].stop_reason;
  const auto tip = column(r, 0, "displacement.x", "swing");
  const double longer = 20 * 1e-5 * length;
  EXPECT_NEAR(*std::max_element(tip.begin(), tip.end()), 2 * longer, 0.05 * longer);
  EXPECT_LT(r.stages[0].energy.drift, 1e-10);
}

TEST(dynamic, too_long_a_time_step_is_refused_before_anything_is_solved) {
  Model m = bar(20);
  m.stages = {stage("pull", StaticSolve{}), stage("swing", DynamicSolve{.duration = 1, .time_step = 0.01})};
  m.stages[1].where = {"bar.lua", 7};
  try {
    run(m);
    FAIL() << "accepted";
  } catch (const DeckError& e) {
    const std::string text = e.what();
    EXPECT_NE(text.find("bar.lua:7"), std::string::npos) << text;
    EXPECT_NE(text.find("time_step 0.01 s is above the stable step"), std::string::npos) << text;
  }
}

TEST(dynamic, large_displacement_is_refused_in_single_precision_whose_strains_would_drown) {
  Model m = bar(2);
  m.stages = {stage("fall", DynamicSolve{.duration = 1, .large_displacement = true})};
  const Problem problem(m, {.precision = Precision::single_precision, .threads = 1});
  EXPECT_THROW(motion_steps(problem, m.stages[0]), DeckError);
}

// ---------------------------------------------------------------- contacts

/// Two cubes on each other, joined by a law; regions "lower" and "upper".
Model pair(const char* law, std::map<std::string, double> values) {
  Mesh mesh = brick({2, 2, 4}, Vec3<double>{1, 1, 2});
  mesh.region_names = {"lower", "upper"};
  for (int e = 0; e < mesh.element_count(); ++e) mesh.regions[e] = e >= mesh.element_count() / 2;
  Model m = body(std::move(mesh), 1e9, 0.2, 2400);
  m.interfaces = {{"base", {}, false, {"lower", "upper"}, law, std::move(values)}};
  m.conditions = {condition("fix", "bottom", Fix{true, true, true, false})};
  return m;
}
Gravity tilted(double angle) { return {{9.81 * std::sin(angle), 0, -9.81 * std::cos(angle)}}; }

TEST(dynamic, P34_a_block_slides_down_an_incline_with_what_friction_leaves_of_gravity) {
  const double friction = 30 * pi / 180, slope = 35 * pi / 180;
  Model m = pair("frictional", {{"friction", friction}, {"stiffness_factor", 10}});
  m.conditions.push_back(condition("gravity", nullptr, tilted(20 * pi / 180)));
  m.conditions.push_back(condition("gravity", nullptr, tilted(slope)));
  m.conditions.back().everywhere = false;
  m.stages = {stage("rest", StaticSolve{{.tolerance = 1e-8}}),
              stage("slide", DynamicSolve{.duration = 0.5, .stiffness_damping = 2e-4, .record_every = 0.01})};
  m.stages[1].apply = {2};
  m.histories = {history("top", Vec3<double>{0.5, 0.5, 2}, {"velocity", "displacement"})};
  const RunResult r = run(m);
  ASSERT_TRUE(r.all_converged()) << r.stages.back().stop_reason;
  const auto seconds = column(r, 0, "seconds", "slide"), u = column(r, 0, "displacement.x", "slide");
  ASSERT_EQ(u.size(), 50u);
  // Second difference over 0.2 s: rocking of the block is too small to matter.
  const double a = (u[48] - u[28]) / (seconds[48] - seconds[28]), b = (u[28] - u[8]) / (seconds[28] - seconds[8]);
  const double found = (a - b) / (0.5 * (seconds[48] - seconds[8]));
  const double exact = 9.81 * (std::sin(slope) - std::cos(slope) * std::tan(friction));
  std::printf("  acceleration %.5f m/s2, exact %.5f; energy drift %.1e, dissipated %.4g J\n", found, exact,
              r.stages[1].energy.drift, r.stages[1].energy.dissipated);
  EXPECT_NEAR(found, exact, 0.01 * exact);
  EXPECT_LT(r.stages[1].energy.drift, 1e-3);
  // Friction: weight across the slope times the way.
  const double way = u.back() - column(r, 0, "displacement.x", "rest").back();
  const double work = 2400 * 9.81 * std::cos(slope) * std::tan(friction) * way;
  EXPECT_NEAR(r.stages[1].dissipated_energy, work, 0.02 * work);
}

TEST(dynamic, P34_a_block_stays_on_a_slope_below_its_friction_angle) {
  const double friction = 30 * pi / 180;
  Model m = pair("frictional", {{"friction", friction}, {"stiffness_factor", 10}});
  m.conditions.push_back(condition("gravity", nullptr, tilted(20 * pi / 180)));
  m.conditions.push_back(condition("gravity", nullptr, tilted(29 * pi / 180)));
  m.conditions.back().everywhere = false;
  m.stages = {stage("rest", StaticSolve{{.tolerance = 1e-8}}),
              stage("slope", DynamicSolve{.duration = 1, .stiffness_damping = 2e-3, .record_every = 0.1})};
  m.stages[1].apply = {2};
  m.histories = {history("top", Vec3<double>{0.5, 0.5, 2}, {"velocity", "displacement"})};
  const RunResult r = run(m);
  ASSERT_TRUE(r.all_converged()) << r.stages.back().stop_reason;
  const auto u = column(r, 0, "displacement.x", "slope");
  EXPECT_NEAR(u.back(), u[u.size() / 2], 1e-6);
}

TEST(dynamic, a_joint_breaks_when_the_reflected_wave_doubles_the_pull) {
  // At mid-length the pull arrives after L/2c and, reflected by the support, a second time after 3L/2c.
  Model m = bar(100);
  m.mesh.region_names = {"inner", "outer"};
  for (int e = 0; e < m.mesh.element_count(); ++e) m.mesh.regions[e] = e >= 50;
  m.materials[0].regions = m.mesh.region_names;
  m.interfaces = {{"mid",
                   {},
                   false,
                   {"inner", "outer"},
                   "brittle",
                   {{"tensile_strength", 1.6e6}, {"cohesion", 1e7}, {"friction", 0.5}}}};
  m.stages = {stage("pull", DynamicSolve{.duration = 2.5 * length / wave_speed})};
  const RunResult r = run(m);
  ASSERT_TRUE(r.all_converged()) << r.stages[0].stop_reason;
  ASSERT_EQ(r.stages[0].events.size(), 1u);
  const CrackEvent& event = r.stages[0].events[0];
  std::printf("  cracked at %.4e s, wave at %.4e s, drift %.1e\n", event.seconds, 1.5 * length / wave_speed,
              r.stages[0].energy.drift);
  EXPECT_EQ(event.mode, "tension");
  EXPECT_EQ(event.contact_points, 4);
  EXPECT_NEAR(event.seconds, 1.5 * length / wave_speed, 0.03 * length / wave_speed);
  EXPECT_NEAR(r.stages[0].cracked_area, edge * edge, 1e-12);
  EXPECT_LT(r.stages[0].energy.drift, 1e-3);
}

TEST(dynamic, what_cracks_rocks_and_slides_keeps_its_energy_from_stage_to_stage) {
  for (const std::string law : {"brittle", "softening", "frictional"}) {
    std::map<std::string, double> values{{"friction", 0.5}};
    if (law != "frictional") values["tensile_strength"] = 1e3, values["cohesion"] = 2e3;
    if (law == "softening") values["fracture_energy"] = 0.01;
    Model m = pair(law.c_str(), values);
    m.conditions.push_back(condition("gravity", nullptr, tilted(0)));
    for (const double angle : {50.0, -40.0, 0.0}) {
      m.conditions.push_back(condition("gravity", nullptr, tilted(angle * pi / 180)));
      m.conditions.back().everywhere = false;
    }
    m.stages = {stage("rest", StaticSolve{{.tolerance = 1e-8}})};
    for (int s = 0; s < 3; ++s) {
      // Without damping faces chatter at the springs' own frequency, and every touch costs or brings a little.
      m.stages.push_back(stage("swing", DynamicSolve{.duration = 0.05, .stiffness_damping = 1e-4}));
      m.stages.back().name += std::to_string(s);
      m.stages.back().apply = {2 + s};
    }
    const RunResult r = run(m);
    ASSERT_TRUE(r.all_converged()) << r.stages.back().stop_reason;
    for (int s = 1; s < 4; ++s) {
      const EnergyBalance& e = r.stages[s].energy;
      std::printf("  %s, stage %d: kinetic %.3g, dissipated %.3g, work %.3g J, drift %.1e\n", law.c_str(), s, e.kinetic,
                  e.dissipated, e.external_work, e.drift);
      EXPECT_LT(e.drift, 1e-3);
    }
    EXPECT_GT(r.stages[1].energy.contacts.friction, 0);
  }
}

// ---------------------------------------------------------------- determinism

TEST(dynamic, every_number_of_threads_gives_the_same_bits) {
  Mesh mesh = brick({8, 8, 8}, Vec3<double>{1, 1, 1});
  Model m = body(std::move(mesh), 1e9, 0.2, 2400);
  m.interfaces = {{"all",
                   {},
                   true,
                   {"body"},
                   "brittle",
                   {{"tensile_strength", 2e4}, {"cohesion", 4e4}, {"friction", 0.5}, {"stiffness_factor", 5}}}};
  m.conditions = {condition("fix", "bottom", Fix{true, true, true, false}),
                  condition("gravity", nullptr, Gravity{{4, 1, -9.81}}),
                  condition("traction", "top", traction(1e4, 0, 3e4))};
  m.stages = {stage(
      "shake", DynamicSolve{.duration = 4e-3, .local_damping = 0.05, .mass_damping = 2, .stiffness_damping = 1e-6})};
  std::vector<std::vector<double>> results;
  for (const int threads : {1, 2, 3}) {
    Problem problem(m, {.threads = threads});
    Observer nobody;
    const RunResult r = solve(problem, nobody);
    ASSERT_TRUE(r.all_converged()) << r.stages[0].stop_reason;
    EXPECT_GT(r.stages[0].cracked_area, 0) << "nothing cracked: the comparison would be weaker";
    std::vector<double> all = problem.backend->read(Field::displacement);
    for (const Field f : {Field::velocity, Field::slip, Field::contact_state, Field::spring_dissipation})
      for (const double v : problem.backend->read(f)) all.push_back(v);
    const EnergyBalance& e = r.stages[0].energy;
    all.insert(all.end(), {e.kinetic, e.strain, e.dissipated, e.external_work, e.error, e.drift});
    results.push_back(std::move(all));
  }
  for (int i : {1, 2}) {
    ASSERT_EQ(results[i].size(), results[0].size());
    EXPECT_EQ(std::memcmp(results[i].data(), results[0].data(), 8 * results[0].size()), 0);
  }
}

}  // namespace
}  // namespace ashlar
