#pragma once
#include "kernels/spring_break.hpp"

/// What springs remember moves on to the present displacement: in static stages at equilibria, in a motion with every
/// step.
namespace ashlar {

/// One contact point -> its state, slip and damage at the present displacement, and the energy that this took out. Slip
/// moves by Coulomb's return.
template <class Real, class View = SpringView<Real>>
struct SpringAdvance {
  View springs;
  Summed<Real> u;
  Real* slip;    ///< [3 * contacts] m, the same array as SpringView::slip
  Real* damage;  ///< [contacts], the same array as SpringView::damage; null: nothing softens

  /// @param breaks whether it cracks at its strength; what it loses beyond its friction is gone at once
  /// @return J
  ASHLAR_HD Dissipation<double> advance(int c, bool breaks) const {
    const auto law = springs.law_of(c);
    if (damage && law.softens()) {
      const auto now = softened(law, c);
      springs.state[c] = now.state;
      damage[c] = now.damage;
      return lost(c, double(now.lost.opening), double(now.lost.shear), double(now.lost.friction), now.slip);
    }
    if (!breaks && law.can_break(springs.state[c])) return {};
    const auto before = springs.answer(u, c);
    if (!law.can_break(springs.state[c]))
      return lost(c, 0, 0, double(dot(before.traction.shear, before.slip - springs.slip_of(c))), before.slip);
    const auto used = utilisation(law, before.traction);
    if (used.largest() < Real(1)) return {};
    springs.state[c] = used.mode();
    const auto now = springs.answer(u, c);
    return lost(c,
                stored(before.traction.normal, springs.normal_stiffness[c]) -
                    stored(now.traction.normal, springs.normal_stiffness[c]),
                stored(norm(before.traction.shear), springs.shear_stiffness[c]) -
                    stored(norm(now.traction.shear), springs.shear_stiffness[c]),
                0, now.slip);
  }
  ASHLAR_HD SofteningAnswer<Real> softened(const SpringLaw<Real>& law, int c) const {
    return springs.softening_answer_to(law, springs.stretch(springs.gap(u, c), c), c);
  }

 private:
  ASHLAR_HD Dissipation<double> lost(int c, double opening, double shear, double friction,
                                     const Vec3<Real>& slipped) const {
    for (int i = 0; i < 3; ++i) slip[3 * c + i] = slipped[i];
    const double area = double(springs.area[c]);
    return {area * opening, area * shear, area * friction};
  }
  /// Elastic energy per area, J/m^2.
  ASHLAR_HD static double stored(Real traction, Real stiffness) {
    return 0.5 * double(traction) * double(traction) / double(stiffness);
  }
};

/// Phase advance_springs: in a motion.
template <class Real, class View = SpringView<Real>>
struct AdvanceSprings {
  SpringAdvance<Real, View> spring;
  double* dissipation;  ///< [3 * contacts] J since the stage began: of opening, shear, friction

  ASHLAR_HD void operator()(int c) const {
    const Dissipation<double> lost = spring.advance(c, true);
    dissipation[3 * c] += lost.opening;
    dissipation[3 * c + 1] += lost.shear;
    dissipation[3 * c + 2] += lost.friction;
  }
};

/// Phase keep_springs: at an equilibrium. Sums: energy of opening, shear and friction, J; contact points that have
/// softened to the end.
template <class Real, class View = SpringView<Real>>
struct KeepSprings {
  SpringAdvance<Real, View> spring;

  ASHLAR_HD void operator()(int c, double (&sum)[4]) const {
    const bool cracked = is_cracked(spring.springs.state[c]);
    const Dissipation<double> lost = spring.advance(c, false);
    sum[0] = lost.opening;
    sum[1] = lost.shear;
    sum[2] = lost.friction;
    sum[3] = is_cracked(spring.springs.state[c]) && !cracked ? 1 : 0;
  }
};

/// Largest: CrackKey of those that KeepSprings will find softened to the end.
template <class Real, class View = SpringView<Real>>
struct FirstSoftened {
  SpringAdvance<Real, View> spring;
  const int* number;  ///< [contacts] in the model

  ASHLAR_HD void operator()(int c, double (&key)[1]) const {
    const auto law = spring.springs.law_of(c);
    if (!law.softens() || is_cracked(spring.springs.state[c])) return;
    const ContactState state = spring.softened(law, c).state;
    if (is_cracked(state)) key[0] = CrackKey::of(number[c], state);
  }
};

/// One contact point -> whether its sides hold each other now, bonded or pressed together. Sum: those that did at the
/// last look and no longer do.
template <class Real, class View = SpringView<Real>>
struct LookAtSprings {
  SpringAdvance<Real, View> spring;
  std::uint8_t* joined;  ///< [contacts]

  ASHLAR_HD void operator()(int c, double (&sum)[1]) const {
    const View& springs = spring.springs;
    const auto law = springs.law_of(c);
    const bool softens = spring.damage && law.softens();
    const bool bonded = softens ? spring.softened(law, c).damage < Real(1) : law.holds(springs.state[c]);
    const auto gap = split(springs.stretch(springs.gap(spring.u, c), c), springs.normal_of(c));
    const bool now = bonded || gap.normal <= Real(0);
    sum[0] = joined[c] && !now ? 1 : 0;
    joined[c] = now;
  }
};

}  // namespace ashlar
