#pragma once
#include <functional>
#include <vector>

#include "backend/backend.hpp"
#include "model/in_time.hpp"

namespace ashlar {

/// A field of one stage that is linear in the numbers of conditions that change during it: the field with all of those
/// 0, and what each adds when it is 1.
class TimeParts {
 public:
  using FieldOf = std::function<std::vector<double>(const std::vector<ActingCondition>&)>;
  /// `field_of`: the field of acting conditions, in the machine's order.
  TimeParts(const Model& model, int stage, const FieldOf& field_of);

  bool changing() const { return !tables_.empty(); }
  /// Parts for Backend::write_parts; none where nothing changes.
  const std::vector<std::vector<double>>& parts() const { return parts_; }
  std::vector<double> factors(double time) const;

 private:
  StageTimes times_;
  std::vector<const TimeTable*> tables_;
  std::vector<std::vector<double>> parts_;
};

/// Whether a load, support or displacement that acts in the stage changes during it.
bool loads_change(const Model& model, int stage);
/// The shortest period of those numbers, s; infinite without one.
double shortest_period(const Model& model, int stage);

}  // namespace ashlar
