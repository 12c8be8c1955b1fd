#pragma once
#include <functional>
#include <string>
#include <vector>

#include "model/model.hpp"

/// Numbers of conditions that follow a table of time. Time is that of the run: the durations of its transient thermal,
/// coupled and dynamic stages, one after the other; other stages take none.
namespace ashlar {

struct StageTimes {
  double begin = 0, end = 0;  ///< s since the start of the run; the same where a stage takes no time
};
std::vector<StageTimes> stage_times(const Model& model);
/// s that a stage takes; 0: none.
double duration_of(const Stage& stage);

/// Whether the table takes more than one value between two times.
bool changes(const TimeTable& table, const StageTimes& stage);
/// The largest value that it takes between two times.
double largest(const TimeTable& table, const StageTimes& stage);
/// Twice the shortest time from one turning point to the next within the stage, s; infinite with fewer than two.
double shortest_period(const TimeTable& table, const StageTimes& stage);

/// The condition with the number of each InTime as `choose` says. Throws std::logic_error for one that cannot change.
Condition with_numbers(const Condition& condition, const std::function<double(const InTime&)>& choose);

/// Gives every InTime its table on the time of the run: functions of time are sampled from the stage where their condition
/// first acts to the end of the run, and what counts time from that stage is shifted.
void settle_times(Model& model);

}  // namespace ashlar
