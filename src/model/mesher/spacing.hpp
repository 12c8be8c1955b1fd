#pragma once
#include <vector>

namespace ashlar {

/// How elements are spaced along a length: `first` and `last` are wanted at the ends, growing inwards by the factor
/// `grade` from one element to the next up to `size`. Lengths in m.
struct Spacing {
  double length = 0;
  double size = 0;
  double first = 0, last = 0;
  double grade = 1;  ///< 1: uniform of `size`

  /// Elements needed, not rounded.
  double natural_count() const;
  /// The whole number of elements of which none is longer than wanted (by more than the rounding of a twentieth
  /// element).
  int count() const;
  /// The n + 1 places, from 0 to 1, of n elements spaced in these proportions.
  std::vector<double> places(int n) const;
  /// Seen from the other end.
  Spacing reversed() const { return {length, size, last, first, grade}; }
};

}  // namespace ashlar
