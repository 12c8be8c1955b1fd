#pragma once
#include "kernels/spring_view.hpp"
#include "kernels/sum.hpp"

/// Strength tests of converged states and what follows from them (numerics 5, crack events), as terms of sums and
/// maxima over all contact points. Never run inside a step.
namespace ashlar {

/// A contact point and how it has cracked, as a number: the largest of many belongs to the first contact point. Of
/// Largest::start: number -1.
struct CrackKey {
  static ASHLAR_HD double of(int number, ContactState mode) { return -(4.0 * number + static_cast<int>(mode)); }
  static int number(double key) { return key == Largest::start ? -1 : static_cast<int>(-key / 4); }
  static ContactState mode(double key) {
    return key == Largest::start ? ContactState::intact : static_cast<ContactState>(static_cast<long>(-key) % 4);
  }
};

/// Largest: how much of its strength a contact point uses; 0 where there is nothing left to break.
template <class Real, class View = SpringView<Real>>
struct SpringUtilisation {
  View springs;
  Summed<Real> u;

  ASHLAR_HD Utilisation<Real> of(int c) const {
    const auto law = springs.law_of(c);
    if (!law.can_break(springs.state[c])) return {Real(0), Real(0)};
    return utilisation(law, springs.answer(u, c).traction);
  }
  ASHLAR_HD void operator()(int c, double (&largest)[1]) const { largest[0] = double(of(c).largest()); }
};

/// Largest: CrackKey of those that use exactly `most` of their strength.
template <class Real, class View = SpringView<Real>>
struct WorstSpring {
  SpringUtilisation<Real, View> use;
  double most;
  const int* number;  ///< [contacts] in the model

  ASHLAR_HD void operator()(int c, double (&key)[1]) const {
    const Utilisation<Real> used = use.of(c);
    if (double(used.largest()) == most) key[0] = CrackKey::of(number[c], used.mode());
  }
};

/// Largest: CrackKey below `last` of those that use at least `threshold` of their strength.
template <class Real, class View = SpringView<Real>>
struct NextToBreak {
  SpringUtilisation<Real, View> use;
  double threshold, last;
  const int* number;  ///< [contacts] in the model

  ASHLAR_HD void operator()(int c, double (&key)[1]) const {
    const Utilisation<Real> used = use.of(c);
    const double own = CrackKey::of(number[c], used.mode());
    if (double(used.largest()) >= threshold && own < last) key[0] = own;
  }
};

/// Largest: minus the fraction of the way from `u_before` to `u` at which a contact point first uses its whole strength,
/// above 1 if it does not. Exact while its traction is linear on that way.
template <class Real, class View = SpringView<Real>>
struct SpringCrossing {
  View springs;
  Summed<Real> u_before;
  Summed<Real> u;

  ASHLAR_HD Real fraction(int c) const {
    const auto law = springs.law_of(c);
    return law.can_break(springs.state[c])
               ? first_crossing(law, springs.answer(u_before, c).traction, springs.answer(u, c).traction)
               : Real(2);
  }
  ASHLAR_HD void operator()(int c, double (&largest)[1]) const { largest[0] = -double(fraction(c)); }
};

/// Cracks contact points that use at least `threshold` of their strength, in the mode that uses most of it.
/// Sums: energy of opening and shear, J, that is left of a spring once it has slid to its friction limit at this gap
/// (friction work on that way is booked as slip); contact points cracked.
template <class Real, class View = SpringView<Real>>
struct BreakSprings {
  SpringUtilisation<Real, View> use;
  double threshold;

  ASHLAR_HD void operator()(int c, double (&sum)[3]) const {
    const View& springs = use.springs;
    const auto law = springs.law_of(c);
    const Utilisation<Real> used = use.of(c);
    if (!law.can_break(springs.state[c]) || double(used.largest()) < threshold) return;
    const auto traction = springs.answer(use.u, c).traction;
    springs.state[c] = used.mode();
    const double tension = double(larger(traction.normal, Real(0)));
    const double friction = double(larger(-traction.normal, Real(0)) * law.tan_friction);
    const double dropped = larger(double(norm(traction.shear)) - friction, 0.0);
    sum[0] = 0.5 * double(springs.area[c]) * tension * tension / double(springs.normal_stiffness[c]);
    sum[1] = 0.5 * double(springs.area[c]) * dropped * dropped / double(springs.shear_stiffness[c]);
    sum[2] = 1;
  }
};

}  // namespace ashlar
