#pragma once
#include "base/number.hpp"

/// What laws of blocks and of interfaces share that lose their strength by cracking.
namespace ashlar {

/// Linear softening of a point, in units of the strength and of the strain at which it is reached: 1 - damage times
/// what an undamaged point would carry, `used`, falls from 1 at used = 1 to 0 at used = ratio.
template <class Real>
struct Softening {
  Real ratio;
  /// Faster than this and the point itself would snap back; `check` refuses blocks long before.
  static constexpr double least_ratio = 1.001;
  ASHLAR_HD explicit Softening(Real r) : ratio(larger(r, Real(least_ratio))) {}
  ASHLAR_HD Real damage(Real used) const {
    if (!(used > Real(1))) return Real(0);
    return used < ratio ? Real(1) - (ratio - used) / (used * (ratio - Real(1))) : Real(1);
  }
  /// Share of the strength that is left at this damage.
  ASHLAR_HD Real strength(Real damage) const {
    return (Real(1) - damage) * ratio / fma(Real(1) - damage, ratio - Real(1), Real(1));
  }
  /// Energy that is gone at this damage, in units of strength squared over stiffness; ratio / 2 at the end.
  ASHLAR_HD Real released(Real damage) const {
    const Real used = ratio / fma(Real(1) - damage, ratio - Real(1), Real(1));
    return Real(0.5) * damage * used;
  }
};

/// Where softening ends: what Softening takes as ratio, times the length of the element across the crack (of blocks,
/// from a modulus), or that ratio itself (of interfaces, from a stiffness per area).
inline double softening_length(double modulus, double energy, double strength) {
  return 2 * modulus * energy / (strength * strength);
}

}  // namespace ashlar
