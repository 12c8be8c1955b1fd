#pragma once
#include <functional>
#include <utility>
#include <vector>

#include "backend/backend.hpp"
#include "model/in_time.hpp"

namespace ashlar {

/// A field of one stage that follows numbers of conditions: on the machine lie parts of it, a step sends their factors.
///
/// Linear numbers (a pressure, a film coefficient): the field with all of them 0, and what each adds when it is 1; its
/// factor is the number itself, so that nothing is lost. Others (a level of water, a function of place and time): the
/// field at sample times and straight lines between them, so many that halfway between two the lines are off by less
/// than 1e-4 of the largest change. The samples are taken when the stage is set up; the machine has those around the
/// present time.
class TimeParts {
 public:
  using FieldOf = std::function<std::vector<double>(const std::vector<ActingCondition>&)>;
  /// What is set is the field, or its rate in time.
  enum class Sets { value, rate };

  /// `field_of`: the field of acting conditions, in the machine's order. Throws DeckError where samples need too much
  /// memory.
  TimeParts(const Model& model, int stage, Backend& backend, Field field, const FieldOf& field_of,
            Sets sets = Sets::value);
  ~TimeParts();
  TimeParts(const TimeParts&) = delete;

  bool changing() const { return !terms_.empty() || !samples_.empty(); }
  /// The field at `time`, s of the run; nothing where it does not change.
  void set(double time);
  /// Its mean rate between two times.
  void set_rate(double from, double to);

 private:
  struct Term {
    std::vector<const TimeTable*> tables;  ///< the factor is their product
    std::vector<double> part;
  };
  struct Sample {
    double time;                                 ///< s of the run
    std::vector<std::pair<int, double>> change;  ///< entries that are not those of the stage's begin, and by how much
  };
  class Sampler;

  std::vector<double> factors(double time) const;
  void reach(double from, double to);
  void combine(const std::vector<double>& factors);

  Backend& backend_;
  Field field_;
  std::vector<double> base_;
  std::vector<Term> terms_;
  std::vector<Sample> samples_;
  std::size_t first_ = 0, last_ = 0;  ///< samples on the machine
  bool written_ = false;
};

/// Whether a load, support or displacement that acts in the stage changes during it.
bool loads_change(const Model& model, int stage);
/// The shortest period of those numbers, s; infinite without one.
double shortest_period(const Model& model, int stage);

}  // namespace ashlar
