#include "solve/coupled.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>

#include "solve/contact_states.hpp"
#include "solve/thermal.hpp"

namespace ashlar {

namespace {

using Clock = Lane::Clock;

double seconds_between(Clock::time_point from, Clock::time_point to) {
  return std::chrono::duration<double>(to - from).count();
}

/// The heat lane in one stage: marches from time to time, and has come to rest when this goes.
class HeatAhead {
 public:
  HeatAhead(Problem& problem, int stage, const std::vector<double>& temperature, const CoupledLinks& links)
      : lane_(*problem.heat_lane), links_(links) {
    lane_.run([&] {
      write_temperature(problem, lane_.backend(), temperature);
      march_ = std::make_unique<HeatMarch>(problem, lane_.backend(), stage);
    });
  }
  ~HeatAhead() {
    stop_ = true;
    try {
      lane_.wait();
    } catch (...) {  // what stopped the stage matters more
    }
  }

  void start(double from, double to) {
    lane_.start([this, from, to] {
      result_ = march_->march(from, to, [&](const ThermalProgress&) {
        return stop_ || (!lane_.beside() && links_.interrupted());
      });
    });
  }
  /// While it rests.
  void open_joints(const std::vector<double>& open) {
    lane_.run([&] { march_->open_joints(open); });
  }
  const ThermalResult& wait() {
    lane_.wait([&] { stop_ = stop_ || links_.interrupted(); });
    return result_;
  }

 private:
  Lane& lane_;
  const CoupledLinks& links_;
  std::unique_ptr<HeatMarch> march_;
  std::atomic<bool> stop_ = false;
  ThermalResult result_;
};

}  // namespace

std::vector<double> balance_times(const CoupledSolve& solve) {
  constexpr double rounding = 1e-9;
  std::vector<double> times{0};
  for (int i = 1; i * solve.every < solve.duration * (1 - rounding); ++i) times.push_back(i * solve.every);
  times.push_back(solve.duration);
  return times;
}

bool march_coupled(Problem& problem, int stage, const std::vector<double>& temperature, const CoupledLinks& links,
                   StageResult& result) {
  const Lane& lane = *problem.heat_lane;
  const std::vector<double> times = balance_times(std::get<CoupledSolve>(problem.model.stages[stage].solve));
  const int last = static_cast<int>(times.size()) - 1;
  LaneTimes& spent = result.lanes.emplace();
  spent.stress_device = problem.backend->name();
  spent.heat_device = lane.backend().name();
  spent.beside = lane.beside();
  HeatAhead heat(problem, stage, temperature, links);
  int i = 0;
  const auto exchange_lanes = [&](Exchange& e) {
    e("coupled.balances", i);
    exchange_field(e, "heat_lane", lane.backend(), Field::temperature);
  };
  links.go_on(exchange_lanes);
  heat.open_joints(open_to_heat(problem));
  for (;;) {
    if (i < last) heat.start(times[i], times[i + 1]);
    const auto began = Clock::now();
    const bool balanced = links.balance(i);
    problem.backend->finish();
    const auto ended = Clock::now();
    spent.stress += seconds_between(began, ended);
    if (!balanced) return false;
    if (i == last) return true;
    const ThermalResult& warmed = heat.wait();
    spent.heat_steps += warmed.steps;
    spent.heat += seconds_between(lane.began(), lane.ended());
    spent.both += std::max(0.0, seconds_between(std::max(began, lane.began()), std::min(ended, lane.ended())));
    if (!warmed.converged) {
      result.stop_reason = warmed.stop_reason;
      return false;
    }
    links.take_over();
    heat.open_joints(open_to_heat(problem));
    ++i;
    links.keep(exchange_lanes);
  }
}

}  // namespace ashlar
