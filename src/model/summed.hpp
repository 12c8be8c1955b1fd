#pragma once
#include "base/number.hpp"

/// Nodal values that many small steps add up to. In single precision they are kept as a sum of two numbers, so that a
/// step far below the value's rounding is not lost, and differences of neighbours are taken before they are rounded
/// (numerics 3); in double precision the second number does not exist.
namespace ashlar {

template <class Real>
struct SummedValue {
  Real high;
  ASHLAR_HD void add(Real amount) { high += amount; }
  ASHLAR_HD void add_product(Real a, Real b) { high = fma(a, b, high); }
};
template <>
struct SummedValue<float> {
  float high, low;
  ASHLAR_HD void add(float amount) { join(low + amount); }
  ASHLAR_HD void add_product(float a, float b) { join(fma(a, b, low)); }

 private:
  /// high + rest as a rounded sum and what rounding took (Knuth's two-sum, exact).
  ASHLAR_HD void join(float rest) {
    const float sum = high + rest, part = sum - high;
    low = (high - (sum - part)) + (rest - part);
    high = sum;
  }
};

/// What is left of the numbers behind a value, relative to `base`: their difference in single precision, where it
/// matters, the value itself in double. Strains and flows do not change with a constant.
ASHLAR_HD double relative(const SummedValue<double>& value, const SummedValue<double>&) { return value.high; }
ASHLAR_HD float relative(const SummedValue<float>& value, const SummedValue<float>& base) {
  return (value.high - base.high) + (value.low - base.low);
}
template <class Real>
ASHLAR_HD Real difference(const SummedValue<Real>& a, const SummedValue<Real>& b) {
  if constexpr (sizeof(Real) == sizeof(double))
    return a.high - b.high;
  else
    return relative(a, b);
}

ASHLAR_HD double difference(double a, double b) { return a - b; }
ASHLAR_HD float difference(float a, float b) { return a - b; }

/// An array of them as kernels see it.
template <class Real>
struct Summed {
  static constexpr bool paired = sizeof(Real) < sizeof(double);
  Real* high = nullptr;
  Real* low = nullptr;  ///< null: zero throughout

  ASHLAR_HD SummedValue<Real> operator[](int i) const {
    if constexpr (paired)
      return {high[i], low ? low[i] : Real(0)};
    else
      return {high[i]};
  }
  ASHLAR_HD void write(int i, const SummedValue<Real>& value) const {
    high[i] = value.high;
    if constexpr (paired) low[i] = value.low;
  }
  /// Value i less `base`.
  ASHLAR_HD Real above(int i, Real base) const {
    if constexpr (paired)
      return (high[i] - base) + (low ? low[i] : Real(0));
    else
      return high[i] - base;
  }
  ASHLAR_HD double whole(int i) const {
    if constexpr (paired)
      return double(high[i]) + (low ? double(low[i]) : 0.0);
    else
      return high[i];
  }
};

}  // namespace ashlar
