#pragma once
#include "base/number.hpp"

/// Phase combine_parts: what changes in time, from numbers alone.
namespace ashlar {

/// One entry of a field -> first part plus factors times the others.
template <class Real>
struct CombineParts {
  const Real* parts;    ///< [parts * size]
  const Real* factors;  ///< [parts - 1]
  int part_count;
  int size;
  Real* sum;  ///< [size]

  ASHLAR_HD void operator()(int i) const {
    Real s = parts[i];
    for (int k = 1; k < part_count; ++k) s = fma(factors[k - 1], parts[std::size_t(k) * size + i], s);
    sum[i] = s;
  }
};

}  // namespace ashlar
