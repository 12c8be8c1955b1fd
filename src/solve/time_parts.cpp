#include "solve/time_parts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace ashlar {

namespace {

constexpr int intervals = 97;  // of a stage, at least; no days of a month or year, which would hide a daily change
constexpr std::size_t most_rows = 1000;   // of a table that become sample times of their own
constexpr int most_halvings = 8;          // of an interval
constexpr double share_of_change = 1e-4;  // that lines between samples may be off, of the largest change
constexpr std::size_t most_bytes = std::size_t(1) << 30;

/// Numbers of conditions that change in a stage.
struct Changing {
  StageTimes times;
  std::vector<ActingCondition> acting;             ///< as the model has them
  std::vector<std::vector<const InTime*>> linear;  ///< of one condition, of which the field takes the product
  std::set<const InTime*> sampled;                 ///< those in which no field is linear, and others beside them
  std::vector<const Condition*> sampled_conditions;
  std::set<std::string> sampled_nouns;

  Changing(const Model& model, int stage) : times(stage_times(model)[stage]), acting(acting_conditions(model, stage)) {
    for (const ActingCondition& a : acting) {
      std::vector<const InTime*> numbers;
      bool sample = false;
      for (const InTime& number : a.condition->in_time)
        if (changes(number.table, times)) {
          numbers.push_back(&number);
          sample = sample || number.field || number.key.ends_with("level");
        }
      if (sample) {
        sampled.insert(numbers.begin(), numbers.end());
        sampled_conditions.push_back(a.condition);
        sampled_nouns.insert(a.condition->noun);
        continue;
      }
      for (const InTime* number : numbers) linear.push_back({number});
      // The heat of a film is its coefficient times the temperature beyond it.
      if (std::holds_alternative<Convection>(a.condition->kind) && numbers.size() == 2) linear.push_back(numbers);
    }
  }

  std::vector<const InTime*> numbers() const {
    std::vector<const InTime*> all(sampled.begin(), sampled.end());
    for (const auto& group : linear)
      if (group.size() == 1) all.push_back(group[0]);
    return all;
  }

  /// The given conditions with the linear numbers in `ones` 1 and others 0, sampled ones as they are at `time`.
  std::vector<ActingCondition> with(std::vector<ActingCondition> conditions, const std::vector<const InTime*>& ones,
                                    double time) const {
    return at_moment(std::move(conditions), [&](const InTime& number) {
      if (sampled.contains(&number)) return number.table.at(time);
      if (!changes(number.table, times)) return number.table.at(times.begin);
      return std::find(ones.begin(), ones.end(), &number) != ones.end() ? 1.0 : 0.0;
    });
  }
};

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
  for (const InTime* number : Changing(model, stage).numbers())
    shortest = std::min(shortest, shortest_period(number->table, stage_times(model)[stage]));
  return shortest;
}

/// The part of a field that its sampled conditions change.
class TimeParts::Sampler {
 public:
  Sampler(const Changing& changing, const FieldOf& field_of) : changing_(changing), field_of_(field_of) {
    for (const ActingCondition& a : changing.acting)  // of one noun, later ones override earlier ones
      if (changing.sampled_nouns.contains(a.condition->noun)) conditions_.push_back(a);
    begin_ = at(changing.times.begin);
    line_.assign(begin_.size(), 0);
  }

  std::vector<Sample> samples() {
    std::vector<Sample> coarse;
    for (const double time : coarse_times()) coarse.push_back(sample(time));
    if (largest_ == 0) return {};  // the changes belong to another field
    std::vector<Sample> all;
    for (std::size_t i = 0; i < coarse.size(); ++i) {
      if (i > 0) fill(all, all.back(), coarse[i], 0);
      all.push_back(std::move(coarse[i]));
    }
    return all;
  }

 private:
  std::vector<double> at(double time) const { return field_of_(changing_.with(conditions_, {}, time)); }

  std::vector<double> coarse_times() const {
    const StageTimes& stage = changing_.times;
    std::set<double> times;
    for (int i = 0; i <= intervals; ++i)
      times.insert(i < intervals ? stage.begin + (stage.end - stage.begin) * i / intervals : stage.end);
    for (const InTime* number : changing_.sampled)
      if (number->table.time.size() <= most_rows)
        for (const double t : number->table.time)
          if (t > stage.begin && t < stage.end) times.insert(t);
    return {times.begin(), times.end()};
  }

  Sample sample(double time) {
    const std::vector<double> now = at(time);
    Sample s{time, {}};
    for (std::size_t i = 0; i < now.size(); ++i)
      if (const double change = now[i] - begin_[i]; change != 0) {
        s.change.emplace_back(static_cast<int>(i), change);
        largest_ = std::max(largest_, std::abs(change));
      }
    bytes_ += s.change.size() * sizeof(s.change[0]);
    if (bytes_ > most_bytes) {
      const Condition& condition = *changing_.sampled_conditions.front();
      throw DeckError(condition.where, condition.noun + (condition.name.empty() ? "" : " '" + condition.name + "'") +
                                           ": its change needs more than 1 GB of samples in this stage; make the stage "
                                           "shorter, or give a number in time, which needs none");
    }
    return s;
  }

  /// Samples between two, until the line through neighbours meets what is halfway.
  void fill(std::vector<Sample>& all, Sample from, const Sample& to, int halvings) {
    if (halvings == most_halvings) return;
    const std::size_t before = bytes_;
    Sample middle = sample(from.time + (to.time - from.time) / 2);
    if (off_line(from, middle, to) <= share_of_change * largest_) {
      bytes_ = before;
      return;
    }
    fill(all, std::move(from), middle, halvings + 1);
    all.push_back(middle);
    fill(all, std::move(middle), to, halvings + 1);
  }

  double off_line(const Sample& from, const Sample& middle, const Sample& to) {
    double most = 0;
    for (const auto& [i, change] : middle.change) line_[i] += change;
    for (const Sample* end : {&from, &to})
      for (const auto& [i, change] : end->change) line_[i] -= change / 2;
    for (const Sample* s : {&from, &middle, &to})
      for (const auto& [i, change] : s->change) {
        most = std::max(most, std::abs(line_[i]));
        line_[i] = 0;
      }
    return most;
  }

  const Changing& changing_;
  const FieldOf& field_of_;
  std::vector<ActingCondition> conditions_;
  std::vector<double> begin_, line_;
  double largest_ = 0;
  std::size_t bytes_ = 0;
};

TimeParts::TimeParts(const Model& model, int stage, Backend& backend, Field field, const FieldOf& field_of, Sets sets)
    : backend_(backend), field_(field) {
  const Changing changing(model, stage);
  if (changing.numbers().empty()) return;
  const auto with_ones = [&](const std::vector<const InTime*>& ones) {
    return field_of(changing.with(changing.acting, ones, changing.times.begin));
  };
  base_ = with_ones({});
  for (const auto& numbers : changing.linear) {
    Term term{{}, with_ones(numbers)};
    const std::vector<double> without = numbers.size() == 2 ? with_ones({numbers[0]}) : base_;
    for (std::size_t i = 0; i < base_.size(); ++i) term.part[i] -= without[i];
    if (numbers.size() == 2) {
      const std::vector<double> alone = with_ones({numbers[1]});
      for (std::size_t i = 0; i < base_.size(); ++i) term.part[i] -= alone[i] - base_[i];
    }
    if (std::all_of(term.part.begin(), term.part.end(), [](double x) { return x == 0; })) continue;  // another field's
    for (const InTime* number : numbers) term.tables.push_back(&number->table);
    terms_.push_back(std::move(term));
  }
  if (!changing.sampled.empty()) samples_ = Sampler(changing, field_of).samples();
  if (sets == Sets::rate) base_.assign(base_.size(), 0.0);  // what stays has no rate
}

TimeParts::~TimeParts() { backend_.write_parts(field_, {}); }

/// Puts the samples on the machine that two times lie between.
void TimeParts::reach(double from, double to) {
  const auto later = [](double time, const Sample& s) { return time < s.time; };
  std::size_t first = 0, last = 0;
  if (!samples_.empty()) {
    const auto after = std::upper_bound(samples_.begin(), samples_.end(), from, later);
    first = after == samples_.begin() ? 0 : after - samples_.begin() - 1;
    last = first;
    while (last + 1 < samples_.size() && samples_[last].time < to) ++last;
  }
  if (written_ && first >= first_ && last <= last_) return;
  first_ = first;
  last_ = last;
  written_ = true;
  std::vector<std::vector<double>> parts{base_};
  for (const Term& term : terms_) parts.push_back(term.part);
  for (std::size_t s = first; s <= last && !samples_.empty(); ++s) {
    parts.emplace_back(base_.size(), 0.0);
    for (const auto& [i, change] : samples_[s].change) parts.back()[i] = change;
  }
  backend_.write_parts(field_, parts);
}

/// Of the terms, then of the samples on the machine.
std::vector<double> TimeParts::factors(double time) const {
  std::vector<double> values;
  for (const Term& term : terms_) {
    values.push_back(1);
    for (const TimeTable* table : term.tables) values.back() *= table->at(time);
  }
  if (samples_.empty()) return values;
  const std::size_t at_first = values.size();
  values.resize(at_first + last_ - first_ + 1);
  std::size_t s = first_;
  while (s < last_ && samples_[s + 1].time <= time) ++s;
  const double share = s < last_ ? (time - samples_[s].time) / (samples_[s + 1].time - samples_[s].time) : 0;
  values[at_first + s - first_] = 1 - share;
  if (s < last_) values[at_first + s + 1 - first_] = share;
  return values;
}

void TimeParts::set(double time) {
  if (!changing()) return;
  reach(time, time);
  combine(factors(time));
}

void TimeParts::set_rate(double from, double to) {
  if (!changing()) return;
  reach(from, to);
  std::vector<double> rate = factors(to);
  const std::vector<double> before = factors(from);
  for (std::size_t k = 0; k < rate.size(); ++k) rate[k] = (rate[k] - before[k]) / (to - from);
  combine(rate);
}

void TimeParts::combine(const std::vector<double>& factors) {
  Controls controls;
  controls.combined = field_;
  controls.factors = factors;
  backend_.run(Phase::combine_parts, controls);
}

}  // namespace ashlar
