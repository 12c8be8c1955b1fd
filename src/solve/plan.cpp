#include "solve/plan.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "solve/coupled.hpp"
#include "solve/dynamic.hpp"
#include "solve/recorder.hpp"
#include "solve/stage_conditions.hpp"
#include "solve/thermal.hpp"

namespace ashlar {

namespace {

StagePlan plan_stage(Problem& problem, int number) {
  const Stage& stage = problem.model.stages[number];
  std::vector<double> temperature(problem.model.mesh.points.size());
  prescribe_temperature(problem.model, number, temperature);
  if (std::holds_alternative<ThermalSolve>(stage.solve)) {
    const ThermalSteps steps = thermal_steps(problem, number);
    return {steps.count, steps.length};
  }
  mechanical_conditions(problem, number);
  if (const auto* solve = std::get_if<CoupledSolve>(&stage.solve)) {
    ThermalSteps steps;
    Lane& lane = *problem.heat_lane;
    lane.run([&] { steps = HeatMarch(problem, lane.backend(), number).steps(0, solve->duration); });
    return {steps.count, steps.length, static_cast<int>(balance_times(*solve).size())};
  }
  if (const auto* solve = std::get_if<StaticSolve>(&stage.solve)) return {0, 0, static_increments(problem, *solve)};
  if (const auto* solve = std::get_if<FractureSolve>(&stage.solve)) return {0, 0, solve->increments};
  if (const auto* solve = std::get_if<StrengthReduction>(&stage.solve))
    return {0, 0, 2 + std::max(0, static_cast<int>(std::ceil(std::log2((solve->high - solve->low) / solve->width))))};
  const MotionSteps steps = motion_steps(problem, stage);
  return {steps.count, steps.length};
}

/// Shortest of several turns, s: what else the machine does only lengthens them.
template <class Piece>
double shortest_time(Backend& backend, Piece piece) {
  constexpr int turns = 5;
  double shortest = 0;
  for (int i = 0; i < turns; ++i) {
    const auto start = std::chrono::steady_clock::now();
    piece();
    backend.finish();
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    shortest = i == 0 ? taken.count() : std::min(shortest, taken.count());
  }
  return shortest;
}

}  // namespace

int static_increments(const Problem& problem, const StaticSolve& solve) {
  constexpr int with_memory = 20;
  if (solve.increments > 0) return solve.increments;
  const Backend& backend = *problem.backend;
  return backend.size(Field::history) > 0 || backend.size(Field::contact_damage) > 0 ? with_memory : 1;
}

std::vector<StagePlan> plan_stages(Problem& problem) {
  std::vector<StagePlan> plans;
  std::vector<std::string> lines;
  const auto try_to = [&](auto action) {
    try {
      action();
    } catch (const DeckError& error) {
      for (const auto& line : error.lines())
        if (std::find(lines.begin(), lines.end(), line) == lines.end()) lines.push_back(line);
    }
  };
  try_to([&] {
    Observer nobody;
    Recorder(problem, nobody);
  });
  for (int s = 0; s < static_cast<int>(problem.model.stages.size()); ++s)
    try_to([&] { plans.push_back(plan_stage(problem, s)); });
  if (!lines.empty()) throw DeckError(lines);
  return plans;
}

StepSeconds measure_steps(Problem& problem) {
  Backend& backend = *problem.backend;
  StepSeconds seconds;
  seconds.force = shortest_time(backend, [&] {
    backend.run(Phase::block_force);
    backend.run(Phase::gather_force);
    backend.run(Phase::spring_force);
  });
  for (const Stage& stage : problem.model.stages)
    if (is_thermal(stage)) {
      seconds.heat = shortest_time(backend, [&] { backend.run(Phase::heat_flow); });
      break;
    }
  return seconds;
}

}  // namespace ashlar
