#include "solve/coupled.hpp"

#include <gtest/gtest.h>

#include "model/in_time.hpp"
#include "solve/solver.hpp"
#include "support/brick.hpp"

/// Heat and stress together in time: the same numbers as one stage after the other, and as lanes beside each other.
namespace ashlar {
namespace {

constexpr double day = 86400;

Condition condition(const char* noun, const char* surface, Condition::Kind kind, std::vector<InTime> in_time = {}) {
  Condition c;
  c.noun = noun;
  if (surface) c.surfaces = {surface};
  c.kind = std::move(kind);
  c.in_time = std::move(in_time);
  return c;
}
Stage stage(const std::string& name, Solve solve) {
  Stage s;
  s.name = name;
  s.solve = std::move(solve);
  return s;
}

/// A slab of 1 m between rollers, cooled through a film on one side, warmed on the other, pressed in between; what acts
/// changes in time, steadily.
Model slab(std::vector<Stage> stages) {
  Model m;
  m.reference_temperature = 15;
  m.mesh = brick({20, 2, 2}, [](const Vec3<double>& p) { return Vec3<double>{p.x, 0.1 * p.y, 0.1 * p.z}; });
  m.materials = {{"concrete", {}, m.mesh.region_names, "elastic", 2400, 2.7, 960,
                  {{"young", 30e9}, {"poisson", 0.2}, {"expansion", 1e-5}}}};
  Fix rollers;
  rollers.normal = true;
  for (const char* side : {"left", "front", "back", "bottom"}) m.conditions.push_back(condition("fix", side, rollers));
  m.conditions.push_back(condition("pressure", "top", Pressure{{1e6, {}}}, {{"value", {{0, 60 * day}, {1e6, 4e6}}}}));
  m.conditions.push_back(condition("convection", "right", Convection{{15, {}}, 15, {}, {}},
                                   {{"ambient", {{0, 60 * day}, {15, -20}}}}));
  m.conditions.push_back(condition("fixed_temperature", "left", FixedTemperature{{25, {}}, {}, {}}));
  m.stages = std::move(stages);
  History history;
  history.name = "middle";
  history.at = Vec3<double>{0.5, 0.05, 0.05};
  history.record = {"displacement", "temperature", "stress", "nodal_stress"};
  m.histories = {history};
  settle_times(m);
  return m;
}

struct Outcome {
  RunResult result;
  std::vector<double> displacement, temperature;  ///< at the end
};
Outcome run(const Model& model, const RunOptions& options) {
  Problem problem(model, options);
  Observer nobody;
  Outcome outcome{solve(problem, nobody), problem.backend->read(Field::displacement), {}};
  outcome.temperature = problem.backend->read(Field::temperature);
  EXPECT_TRUE(outcome.result.all_converged());
  return outcome;
}
std::vector<double> last_row_of(const Outcome& outcome, const std::string& stage) {
  std::vector<double> values;
  for (const auto& row : outcome.result.histories.at(0).rows)
    if (row.stage == stage) values = row.values;
  return values;
}

const CoupledSolve thirty_days{30 * day, 10 * day, 1, {1e-8}};

TEST(Coupled, gives_the_bits_of_thermal_and_static_stages_in_turn) {
  const StaticSolve balance{{1e-8}};
  const ThermalSolve heat{.duration = 10 * day};
  for (const Precision precision : {Precision::double_precision, Precision::single_precision}) {
    const CoupledSolve coupled{30 * day, 10 * day, 1, {precision == Precision::double_precision ? 1e-8 : 1e-5}};
    StaticSolve rest = balance;
    rest.relaxation = coupled.relaxation;
    const Outcome together = run(slab({stage("month", coupled)}), {precision, 1});
    const Outcome apart = run(slab({stage("0", rest), stage("heat 1", heat), stage("10", rest), stage("heat 2", heat),
                                    stage("20", rest), stage("heat 3", heat), stage("30", rest)}),
                              {precision, 1});
    EXPECT_EQ(together.displacement, apart.displacement);
    EXPECT_EQ(together.temperature, apart.temperature);
    std::vector<double> at_end = last_row_of(apart, "30");
    at_end[0] = 30 * day;  // static stages take no time
    EXPECT_EQ(last_row_of(together, "month"), at_end);
  }
}

TEST(Coupled, records_every_equilibrium_at_its_time) {
  const Outcome outcome = run(slab({stage("month", CoupledSolve{25 * day, 10 * day, 1, {1e-6}})}), {.threads = 1});
  std::vector<double> seconds, share;
  for (const auto& row : outcome.result.histories.at(0).rows) {
    seconds.push_back(row.values[0]);
    share.push_back(row.load_factor);
  }
  EXPECT_EQ(seconds, (std::vector<double>{0, 0, 10 * day, 20 * day, 25 * day}));  // the first: nothing solved yet
  EXPECT_EQ(share, (std::vector<double>{0, 0, 0.4, 0.8, 1}));
}

TEST(Coupled, lanes_beside_each_other_give_the_bits_of_lanes_in_turns) {
  const DeviceChoice cpu{DeviceChoice::cpu};
  for (const Precision precision : {Precision::double_precision, Precision::single_precision}) {
    const CoupledSolve coupled{30 * day, 5 * day, 1, {precision == Precision::double_precision ? 1e-8 : 1e-5}};
    const Model model = slab({stage("month", coupled)});
    const Outcome in_turns = run(model, {precision, 2}), beside = run(model, {precision, 1, cpu, cpu});
    EXPECT_FALSE(in_turns.result.stages[0].lanes->beside);
    EXPECT_TRUE(beside.result.stages[0].lanes->beside);
    EXPECT_EQ(in_turns.displacement, beside.displacement);
    EXPECT_EQ(in_turns.temperature, beside.temperature);
    EXPECT_EQ(in_turns.result.stages[0].steps, beside.result.stages[0].steps);
    EXPECT_EQ(in_turns.result.stages[0].lanes->heat_steps, beside.result.stages[0].lanes->heat_steps);
    const auto &a = in_turns.result.histories.at(0).rows, &b = beside.result.histories.at(0).rows;
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i].values, b[i].values);
  }
}

TEST(Coupled, nvidia_devices_give_the_bits_of_the_cpu_in_turns_and_beside_each_other) {
  const CudaSupport cuda = cuda_support();
  if (cuda.devices.empty()) GTEST_SKIP() << cuda.missing;
  const DeviceChoice first{DeviceChoice::cuda, 0}, last{DeviceChoice::cuda, static_cast<int>(cuda.devices.size()) - 1};
  for (const Precision precision : {Precision::double_precision, Precision::single_precision}) {
    const CoupledSolve coupled{30 * day, 5 * day, 1, {precision == Precision::double_precision ? 1e-8 : 1e-5}};
    const Model model = slab({stage("month", coupled)});
    const Outcome cpu = run(model, {precision, 1});
    for (const RunOptions& devices : {RunOptions{precision, 1, first}, RunOptions{precision, 1, first, first},
                                      RunOptions{precision, 1, first, last}, RunOptions{precision, 1, last, first}}) {
      const Outcome outcome = run(model, devices);
      EXPECT_EQ(outcome.result.stages[0].lanes->beside, devices.heat_device.has_value());
      EXPECT_EQ(outcome.displacement, cpu.displacement);
      EXPECT_EQ(outcome.temperature, cpu.temperature);
      EXPECT_EQ(last_row_of(outcome, "month"), last_row_of(cpu, "month"));
    }
  }
}

/// A bar held at both ends that cools evenly tears in its joint, and the time says when: at E alpha dT = T.
TEST(Coupled, a_cooling_bar_cracks_when_its_stress_reaches_the_strength) {
  Model m;
  m.reference_temperature = 20;
  m.mesh = brick({4, 1, 1}, [](const Vec3<double>& p) { return Vec3<double>{4 * p.x, p.y, p.z}; });
  m.mesh.region_names = {"left half", "right half"};
  for (int e = 0; e < m.mesh.element_count(); ++e) m.mesh.regions[e] = m.mesh.centroid(e).x < 2 ? 0 : 1;
  m.materials = {{"concrete", {}, m.mesh.region_names, "elastic", 2400, 2.7, 960,
                  {{"young", 30e9}, {"poisson", 0}, {"expansion", 1e-5}}}};
  m.interfaces = {{"joint", {}, false, m.mesh.region_names, "brittle",
                   {{"tensile_strength", 1.5e6}, {"cohesion", 5e6}, {"friction", 0.7}, {"normal_stiffness", 1e15},
                    {"shear_stiffness", 1e15}}}};
  Fix held;
  held.x = held.y = held.z = true;
  for (const char* end : {"left", "right"}) m.conditions.push_back(condition("fix", end, held));
  // 0.5 K a day everywhere: rho c dT/dt
  m.conditions.push_back(condition("heat_source", nullptr, HeatSource{{-2400 * 960 * 0.5 / day, {}}, {}}));
  m.stages = {stage("cooling", CoupledSolve{16 * day, 4 * day, 1, {1e-8}})};
  settle_times(m);
  for (const bool beside : {false, true}) {
    RunOptions options{.threads = 1};
    if (beside) options.heat_device = DeviceChoice{DeviceChoice::cpu};
    const Outcome outcome = run(m, options);
    const StageResult& r = outcome.result.stages[0];
    ASSERT_EQ(r.events.size(), 1u);
    EXPECT_NEAR(r.events[0].seconds, 10 * day, 0.006 * 10 * day);  // a crack may come 0.5 % late
    EXPECT_EQ(r.events[0].contact_points, 4);
    EXPECT_NEAR(r.cracked_area, 1, 1e-12);
    EXPECT_EQ(r.load_factor, 1);
  }
}

TEST(Coupled, stops_when_asked_and_leaves_the_heat_lane_at_rest) {
  class Impatient : public Observer {
   public:
    void history_row(const HistoryTable& table) override { asked = table.rows.size() > 3; }
    bool interrupted() override { return asked; }
    bool asked = false;
  };
  const Model model = slab({stage("month", thirty_days)});
  for (const bool beside : {false, true}) {
    RunOptions options{.threads = 1};
    if (beside) options.heat_device = DeviceChoice{DeviceChoice::cpu};
    Problem problem(model, options);
    Impatient observer;
    const RunResult result = solve(problem, observer);
    EXPECT_TRUE(result.interrupted);
    EXPECT_EQ(result.stages.at(0).stop_reason, "interrupted");
    EXPECT_LT(result.stages[0].seconds, 30 * day);
  }
}

TEST(Lane, tells_what_its_work_threw) {
  const auto nothing = [] { return std::unique_ptr<Backend>(); };
  for (const bool beside : {false, true}) {
    Lane lane(nothing, beside);
    lane.start([] { throw std::runtime_error("broken"); });
    EXPECT_THROW(lane.wait(), std::runtime_error);
    int done = 0;
    lane.run([&] { ++done; });
    EXPECT_EQ(done, 1);
    EXPECT_THROW(Lane([]() -> std::unique_ptr<Backend> { throw std::runtime_error("no device"); }, beside),
                 std::runtime_error);
  }
}

}  // namespace
}  // namespace ashlar
