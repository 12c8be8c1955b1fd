#include "solve/time_parts.hpp"

#include <algorithm>
#include <limits>

namespace ashlar {

namespace {

std::vector<const InTime*> changing_numbers(const Model& model, int stage) {
  const StageTimes times = stage_times(model)[stage];
  std::vector<const InTime*> numbers;
  for (const ActingCondition& a : acting_conditions(model, stage))
    for (const InTime& number : a.condition->in_time)
      if (changes(number.table, times)) numbers.push_back(&number);
  return numbers;
}

}  // namespace

bool loads_change(const Model& model, int stage) {
  const StageTimes times = stage_times(model)[stage];
  for (const ActingCondition& a : acting_conditions(model, stage))
    for (const InTime& number : a.condition->in_time)
      if (!gives_heat(*a.condition) && changes(number.table, times)) return true;
  return false;
}

double shortest_period(const Model& model, int stage) {
  double shortest = std::numeric_limits<double>::infinity();
  for (const InTime* number : changing_numbers(model, stage))
    shortest = std::min(shortest, shortest_period(number->table, stage_times(model)[stage]));
  return shortest;
}

TimeParts::TimeParts(const Model& model, int stage, const FieldOf& field_of) : times_(stage_times(model)[stage]) {
  const std::vector<const InTime*> numbers = changing_numbers(model, stage);
  if (numbers.empty()) return;
  const auto with_one = [&](const InTime* chosen) {
    return field_of(acting_conditions(model, stage, [&](const InTime& number) {
      if (std::find(numbers.begin(), numbers.end(), &number) == numbers.end()) return number.table.at(times_.begin);
      return &number == chosen ? 1.0 : 0.0;
    }));
  };
  const std::vector<double> none = with_one(nullptr);
  parts_.push_back(none);
  for (const InTime* number : numbers) {
    std::vector<double> part = with_one(number);
    if (part == none) continue;  // it belongs to another field
    for (std::size_t i = 0; i < part.size(); ++i) part[i] -= none[i];
    parts_.push_back(std::move(part));
    tables_.push_back(&number->table);
  }
  if (tables_.empty()) parts_.clear();
}

std::vector<double> TimeParts::factors(double time) const {
  std::vector<double> values;
  for (const TimeTable* table : tables_) values.push_back(table->at(time));
  return values;
}

}  // namespace ashlar
