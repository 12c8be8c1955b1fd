#pragma once
#include "kernels/spring_view.hpp"

/// Strength tests of converged states and what follows from them (numerics 5, crack events). Never run inside a step.
namespace ashlar {

/// One contact point -> how much of its strength it uses; 0 where there is nothing left to break.
template <class Real, class View = SpringView<Real>>
struct SpringUtilisation {
  View springs;
  Summed<Real> u;
  Real* used;  ///< [contacts]

  ASHLAR_HD void operator()(int c) const {
    const auto law = springs.law_of(c);
    used[c] = law.can_break(springs.state[c]) ? utilisation(law, springs.answer(u, c).traction).largest() : Real(0);
  }
};

/// One contact point -> the fraction of the way from `u_before` to `u` at which it first uses its whole strength, above
/// 1 if it does not. Exact while its traction is linear on that way.
template <class Real, class View = SpringView<Real>>
struct SpringCrossing {
  View springs;
  Summed<Real> u_before;
  Summed<Real> u;
  Real* fraction;  ///< [contacts]

  ASHLAR_HD void operator()(int c) const {
    const auto law = springs.law_of(c);
    fraction[c] = law.can_break(springs.state[c])
                      ? first_crossing(law, springs.answer(u_before, c).traction, springs.answer(u, c).traction)
                      : Real(2);
  }
};

/// One contact point -> cracked, in the mode that uses most of its strength, if it uses at least `threshold` of it.
template <class Real, class View = SpringView<Real>>
struct BreakSprings {
  View springs;
  Summed<Real> u;
  Real threshold;

  ASHLAR_HD void operator()(int c) const {
    const auto law = springs.law_of(c);
    if (!law.can_break(springs.state[c])) return;
    const auto used = utilisation(law, springs.answer(u, c).traction);
    if (used.largest() >= threshold) springs.state[c] = used.mode();
  }
};

}  // namespace ashlar
