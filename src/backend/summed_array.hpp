#pragma once
#include <span>
#include <stdexcept>
#include <vector>

#include "model/summed.hpp"

namespace ashlar {

/// Values of a Summed in a machine's memory.
template <class Exec, class Real>
class SummedArray {
 public:
  void resize(std::size_t n) {
    high_.resize(n);
    if (Summed<Real>::paired) low_.resize(n);
  }
  std::size_t size() const { return high_.size(); }
  Summed<Real> view() { return {high_.data(), Summed<Real>::paired ? low_.data() : nullptr}; }
  void copy(const SummedArray& other) {
    high_.copy(other.high_);
    if constexpr (Summed<Real>::paired) low_.copy(other.low_);
  }
  void upload(std::span<const double> values) {
    if (values.size() != size()) throw std::logic_error("field of the wrong size");
    std::vector<Real> part(values.begin(), values.end());
    high_.upload(part);
    if constexpr (Summed<Real>::paired) {
      for (std::size_t i = 0; i < part.size(); ++i) part[i] = Real(values[i] - double(part[i]));
      low_.upload(part);
    }
  }
  void download(std::span<double> values) const {
    std::vector<Real> part(size());
    high_.download(part);
    for (std::size_t i = 0; i < part.size(); ++i) values[i] = double(part[i]);
    if constexpr (Summed<Real>::paired) {
      low_.download(part);
      for (std::size_t i = 0; i < part.size(); ++i) values[i] += double(part[i]);
    }
  }

  /// All bits: the first numbers, then the second ones where there are any.
  std::vector<double> save() const {
    std::vector<double> all;
    std::vector<Real> part(size());
    for (const Array<Real>* array : {&high_, &low_}) {
      if (array->size() == 0) continue;
      array->download(part);
      all.insert(all.end(), part.begin(), part.end());
    }
    return all;
  }
  void restore(std::span<const double> values) {
    if (values.size() != high_.size() + low_.size()) throw std::logic_error("field of the wrong size");
    const auto second = values.begin() + static_cast<std::ptrdiff_t>(size());
    high_.upload(std::vector<Real>(values.begin(), second));
    if (low_.size() > 0) low_.upload(std::vector<Real>(second, values.end()));
  }

 private:
  template <class T>
  using Array = typename Exec::template Array<T>;
  Array<Real> high_, low_;
};

}  // namespace ashlar
