#pragma once
#include "base/tensor.hpp"
#include "model/summed.hpp"

/// Displacements along a path of loads (numerics 5): straight on from the last equilibrium, or part of the way to
/// another.
namespace ashlar {

/// One component -> to = start + factor * (end - before); `start` and `before` may be zero throughout (null).
template <class Real>
struct GoAlong {
  Summed<Real> to, start, end, before;
  double factor;
  ASHLAR_HD void operator()(int i) const {
    const double change = end.whole(i) - (before.high ? before.whole(i) : 0.0);
    const double value = fma(factor, change, start.high ? start.whole(i) : 0.0);
    SummedValue<Real> parts;
    parts.high = Real(value);
    if constexpr (Summed<Real>::paired) parts.low = Real(value - double(parts.high));
    to.write(i, parts);
  }
};

/// Largest: component between two displacements, m.
template <class Real>
struct LargestChange {
  Summed<Real> a, b;
  ASHLAR_HD void operator()(int i, double (&largest)[1]) const {
    const double change = a.whole(i) - b.whole(i);
    largest[0] = change < 0 ? -change : change;
  }
};

}  // namespace ashlar
