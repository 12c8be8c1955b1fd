#include "model/in_time.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace ashlar {
namespace {

constexpr double pi = std::numbers::pi;

Stage heated(const char* name, double duration) {
  Stage stage;
  stage.name = name;
  stage.solve = ThermalSolve{.duration = duration};
  return stage;
}

Model two_heated_stages() {
  Model m;
  m.stages = {heated("first", 100), heated("second", 300)};
  m.conditions = {{"flux", "sun", {}, {"top"}, Flux{}, {}, true}};
  return m;
}

TEST(InTime, a_table_is_straight_between_its_rows_and_constant_beyond) {
  const TimeTable table{{1, 3, 4}, {10, 20, 0}};
  EXPECT_EQ(table.at(0), 10);
  EXPECT_EQ(table.at(1), 10);
  EXPECT_EQ(table.at(2), 15);
  EXPECT_EQ(table.at(3.25), 15);
  EXPECT_EQ(table.at(4), 0);
  EXPECT_EQ(table.at(1e9), 0);
  EXPECT_FALSE(changes(table, {0, 1}));
  EXPECT_TRUE(changes(table, {0, 1.5}));
  EXPECT_FALSE(changes(table, {4, 9}));
}

TEST(InTime, the_shortest_period_of_a_sampled_sine_is_its_period) {
  Model m = two_heated_stages();
  const double period = 37;
  m.conditions[0].in_time = {{"value", {}, false, [&](double t) { return 5 * std::sin(2 * pi * t / period); }}};
  settle_times(m);
  const TimeTable& table = m.conditions[0].in_time[0].table;
  const std::vector<StageTimes> times = stage_times(m);
  EXPECT_NEAR(shortest_period(table, times[1]), period, 0.02 * period);
  EXPECT_TRUE(std::isinf(shortest_period(table, {0, 20})));
  EXPECT_EQ(table.time.front(), 0);
  EXPECT_EQ(table.time.back(), 400);
  for (double t = 0; t < 400; t += 0.0137) EXPECT_NEAR(table.at(t), 5 * std::sin(2 * pi * t / period), 2e-4 * 10) << t;
}

TEST(InTime, time_from_the_stage_counts_from_where_the_condition_first_acts) {
  Model m = two_heated_stages();
  m.conditions[0].everywhere = false;
  m.stages[1].apply = {0};
  m.conditions[0].in_time = {{"value", {{0, 50}, {3, 8}}, true, {}}};
  settle_times(m);
  EXPECT_EQ(m.conditions[0].in_time[0].table.time, (std::vector<double>{100, 150}));
  EXPECT_EQ(std::get<Flux>(m.conditions[0].kind).value.constant, 3);
  const Condition later = with_numbers(m.conditions[0], [](const InTime& n) { return n.table.at(125); });
  EXPECT_EQ(std::get<Flux>(later.kind).value.constant, 5.5);
}

TEST(InTime, a_step_is_found_between_samples) {
  Model m = two_heated_stages();
  m.conditions[0].in_time = {{"value", {}, false, [](double t) { return t < 12.3456 ? 1.0 : 2.0; }}};
  settle_times(m);
  EXPECT_EQ(m.conditions[0].in_time[0].table.at(12.345), 1);
  EXPECT_EQ(m.conditions[0].in_time[0].table.at(12.346), 2);
}

TEST(InTime, a_function_of_place_and_time_is_asked_at_the_time_that_its_condition_counts) {
  Model m = two_heated_stages();
  m.conditions[0].everywhere = false;
  m.stages[1].apply = {0};
  m.conditions[0].in_time = {{"value", {}, true, {}, [](const Vec3<double>& p, double t) { return 1000 * p.z + t; }}};
  settle_times(m);
  const auto at = [&](double time) {
    return with_numbers(m.conditions[0], [&](const InTime& number) { return number.table.at(time); });
  };
  EXPECT_EQ(std::get<Flux>(m.conditions[0].kind).value({0, 0, 2}), 2000);
  EXPECT_NEAR(std::get<Flux>(at(250).kind).value({0, 0, 2}), 2150, 1e-9);
  EXPECT_NEAR(std::get<Flux>(at(400).kind).value({0, 0, 2}), 2300, 1e-9);
}

TEST(InTime, the_largest_value_of_a_stage_may_lie_inside_it) {
  const TimeTable table{{0, 10, 20, 30}, {1, 7, 2, 9}};
  EXPECT_EQ(largest(table, {0, 20}), 7);
  EXPECT_EQ(largest(table, {12, 25}), 6);
  EXPECT_EQ(largest(table, {5, 5}), 4);
}

}  // namespace
}  // namespace ashlar
