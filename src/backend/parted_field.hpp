#pragma once
#include <span>
#include <vector>

#include "kernels/combine_parts.hpp"

namespace ashlar {

/// Parts of one field in a machine's memory (Backend::write_parts).
template <class Exec, class Real>
class PartedField {
 public:
  void write(const std::vector<std::vector<double>>& parts) {
    count_ = static_cast<int>(parts.size());
    std::vector<Real> all;
    for (const std::vector<double>& part : parts)
      for (const double value : part) all.push_back(Real(value));
    parts_.assign(all);
    factors_.resize(count_ > 0 ? count_ - 1 : 0);
  }
  void combine(Exec& exec, std::span<const double> factors, Real* sum) {
    if (count_ == 0) return;
    factors_.upload(std::vector<Real>(factors.begin(), factors.end()));
    const int size = static_cast<int>(parts_.size() / count_);
    exec.for_each(size, CombineParts<Real>{parts_.data(), factors_.data(), count_, size, sum});
  }

 private:
  template <class T>
  using Array = typename Exec::template Array<T>;
  int count_ = 0;
  Array<Real> parts_, factors_;
};

}  // namespace ashlar
