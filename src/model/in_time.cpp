#include "model/in_time.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace ashlar {

namespace {

constexpr int intervals = 1000;          // of a stage, at least
constexpr double share_of_range = 1e-4;  // that a sampled function may be off the table in the middle of an interval
constexpr int most_halvings = 12;
constexpr std::size_t most_samples = 200'000;

/// A function as a table: every interval is halved until the line through its ends meets the middle.
class Sampler {
 public:
  Sampler(const std::function<double(double)>& function, TimeTable& table) : function_(function), table_(table) {}

  void add(double begin, double end) {
    std::vector<double> time, value;
    for (int i = 0; i <= intervals; ++i) {
      time.push_back(i < intervals ? begin + (end - begin) * i / intervals : end);
      value.push_back(function_(time.back()));
      low_ = std::min(low_, value.back());
      high_ = std::max(high_, value.back());
    }
    if (table_.time.empty()) keep(time[0], value[0]);
    for (int i = 0; i < intervals; ++i) fill(time[i], value[i], time[i + 1], value[i + 1], 0);
  }
  void keep(double time, double value) {
    table_.time.push_back(time);
    table_.value.push_back(value);
  }

 private:
  /// Adds what lies after a, up to b.
  void fill(double a, double at_a, double b, double at_b, int halvings) {
    if (halvings < most_halvings && table_.time.size() < most_samples) {
      const double middle = a + (b - a) / 2, there = function_(middle);
      low_ = std::min(low_, there);
      high_ = std::max(high_, there);
      if (std::abs(there - (at_a + at_b) / 2) > share_of_range * (high_ - low_)) {
        fill(a, at_a, middle, there, halvings + 1);
        return fill(middle, there, b, at_b, halvings + 1);
      }
    }
    keep(b, at_b);
  }

  const std::function<double(double)>& function_;
  TimeTable& table_;
  double low_ = std::numeric_limits<double>::infinity(), high_ = -low_;
};

auto& component(const std::string& key, auto& x, auto& y, auto& z) { return key == "x" ? x : key == "y" ? y : z; }

/// The value that a deck key gives; null where it is a plain number.
Value* value_of(Condition::Kind& kind, const std::string& key) {
  if (auto* c = std::get_if<Displacement>(&kind)) return &*component(key, c->x, c->y, c->z);
  if (auto* c = std::get_if<Traction>(&kind)) return &component(key, c->x, c->y, c->z);
  if (auto* c = std::get_if<Pressure>(&kind)) return &c->value;
  if (auto* c = std::get_if<FixedTemperature>(&kind)) return &c->value;
  if (auto* c = std::get_if<Convection>(&kind)) return key == "film" ? nullptr : &c->ambient;
  if (auto* c = std::get_if<Flux>(&kind)) return &c->value;
  if (auto* c = std::get_if<HeatSource>(&kind)) return &c->value;
  if (auto* c = std::get_if<TemperatureField>(&kind)) return &c->value;
  return nullptr;
}
double& number_of(Condition::Kind& kind, const std::string& key) {
  if (auto* c = std::get_if<Gravity>(&kind))
    return component(key, c->acceleration.x, c->acceleration.y, c->acceleration.z);
  if (auto* c = std::get_if<WaterPressure>(&kind)) return c->level;
  if (auto* c = std::get_if<CrackWater>(&kind)) return c->level;
  if (auto* c = std::get_if<Uplift>(&kind)) return key == "upstream_level" ? c->upstream_level : c->downstream_level;
  if (auto* c = std::get_if<PointLoad>(&kind)) return component(key, c->force.x, c->force.y, c->force.z);
  if (auto* c = std::get_if<Convection>(&kind)) return c->film;
  throw std::logic_error("'" + key + "' cannot change in time");
}

}  // namespace

double TimeTable::at(double t) const {
  const auto after = std::upper_bound(time.begin(), time.end(), t);
  if (after == time.begin()) return value.front();
  if (after == time.end()) return value.back();
  const std::size_t i = after - time.begin();
  return value[i - 1] + (value[i] - value[i - 1]) * ((t - time[i - 1]) / (time[i] - time[i - 1]));
}

double duration_of(const Stage& stage) {
  if (const auto* thermal = std::get_if<ThermalSolve>(&stage.solve)) return thermal->duration;
  if (const auto* coupled = std::get_if<CoupledSolve>(&stage.solve)) return coupled->duration;
  if (const auto* dynamic = std::get_if<DynamicSolve>(&stage.solve)) return dynamic->duration;
  return 0;
}

std::vector<StageTimes> stage_times(const Model& model) {
  std::vector<StageTimes> times;
  double now = 0;
  for (const Stage& stage : model.stages) {
    const double duration = duration_of(stage);
    times.push_back({now, now + duration});
    now += duration;
  }
  return times;
}

bool changes(const TimeTable& table, const StageTimes& stage) {
  const double first = table.at(stage.begin);
  if (table.at(stage.end) != first) return true;
  for (std::size_t i = 0; i < table.time.size(); ++i)
    if (table.time[i] > stage.begin && table.time[i] < stage.end && table.value[i] != first) return true;
  return false;
}

double largest(const TimeTable& table, const StageTimes& stage) {
  double most = std::max(table.at(stage.begin), table.at(stage.end));
  for (std::size_t i = 0; i < table.time.size(); ++i)
    if (table.time[i] > stage.begin && table.time[i] < stage.end) most = std::max(most, table.value[i]);
  return most;
}

double shortest_period(const TimeTable& table, const StageTimes& stage) {
  double shortest = std::numeric_limits<double>::infinity(), last_turn = -shortest;
  double direction = 0;
  for (std::size_t i = 1; i < table.time.size(); ++i) {
    const double change = table.value[i] - table.value[i - 1];
    if (change == 0) continue;
    const double turn = table.time[i - 1];
    if (change * direction < 0 && turn > stage.begin && turn < stage.end) {
      shortest = std::min(shortest, 2 * (turn - last_turn));
      last_turn = turn;
    }
    direction = change;
  }
  return shortest;
}


Condition with_numbers(const Condition& condition, const std::function<double(const InTime&)>& choose) {
  Condition now = condition;
  for (const InTime& number : condition.in_time) {
    const double chosen = choose(number);
    Value* value = value_of(now.kind, number.key);
    if (number.field)
      value->at = [field = number.field, chosen](const Vec3<double>& p) { return field(p, chosen); };
    else
      (value ? value->constant : number_of(now.kind, number.key)) = chosen;
  }
  return now;
}

void settle_times(Model& model) {
  const std::vector<StageTimes> times = stage_times(model);
  if (times.empty()) return;
  for (std::size_t c = 0; c < model.conditions.size(); ++c) {
    std::size_t first = 0;
    const auto gives = [&](const Stage& stage) {
      return std::find(stage.apply.begin(), stage.apply.end(), static_cast<int>(c)) != stage.apply.end();
    };
    if (!model.conditions[c].everywhere)
      while (first + 1 < times.size() && !gives(model.stages[first])) ++first;
    for (InTime& number : model.conditions[c].in_time) {
      const double origin = number.from_stage ? times[first].begin : 0;
      if (number.field) {
        const double from = times[first].begin - origin, to = times.back().end - origin;
        number.table = to > from ? TimeTable{{from, to}, {from, to}} : TimeTable{{from}, {from}};
      } else if (number.function) {
        Sampler sampler(number.function, number.table);
        for (std::size_t s = first; s < times.size(); ++s)
          if (times[s].end > times[s].begin) sampler.add(times[s].begin - origin, times[s].end - origin);
        if (number.table.time.empty())
          sampler.keep(times[first].begin - origin, number.function(times[first].begin - origin));
        number.function = {};
      }
      for (double& t : number.table.time) t += origin;
      number.from_stage = false;
    }
    if (!model.conditions[c].in_time.empty())
      model.conditions[c] =
          with_numbers(model.conditions[c], [&](const InTime& number) { return number.table.at(times[first].begin); });
  }
}

}  // namespace ashlar
