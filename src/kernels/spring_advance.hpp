#pragma once
#include "kernels/spring_break.hpp"

/// What springs remember moves on to the present displacement: in static stages at equilibria, in a motion with every
/// step.
namespace ashlar {

/// Phase advance_springs: in a motion. One contact point -> its state and slip at the present displacement, and the energy that this took out: what its
/// traction did on the way from the displacement before, less what is stored. Central difference does just the work of
/// the mean of two tractions on the way between them, so nothing is lost sight of while a contact stays closed or open.
template <class Real, class View = SpringView<Real>>
struct AdvanceSprings {
  View springs;
  Summed<Real> u;
  const Real* v;        ///< [3 * block nodes] m/s, on the way here
  Real step_before;     ///< s, that the way took
  Real* slip;           ///< [3 * contacts] m, the same array as SpringView::slip
  Real* damage;         ///< [contacts], the same array as SpringView::damage; null: nothing softens
  double* dissipation;  ///< [3 * contacts] J since the stage began: of opening, shear, friction

  ASHLAR_HD void operator()(int c) const {
    const auto law = springs.law_of(c);
    const bool softens = damage && law.softens();
    if (!law.separates()) return;
    const Vec3<Real> to = springs.stretch(springs.gap(u, c), c), from = to - step_before * springs.gap(v, c);
    if (softens) return soften(law, c, from, to);
    const auto before = springs.answer_to(from, c);
    auto now = springs.answer_to(to, c);
    const bool bond = law.can_break(springs.state[c]);
    if (bond) {
      const auto used = utilisation(law, now.traction);
      if (used.largest() < Real(1)) return;
      springs.state[c] = used.mode();
      now = springs.answer_to(to, c);
    }
    // Of a bond friction takes over a part; the rest of its traction is gone.
    const Vec3<Real> slid = now.slip - before.slip, more = before.traction.shear - now.traction.shear;
    const double friction = work(now.traction.shear, slid), rest = 0.5 * work(more, slid);
    book(c, bond ? lost_by_opening(before.traction.normal, from, now.traction.normal, to, c) : 0, bond ? rest : 0,
         bond ? friction : friction + rest, now.slip);
  }

 private:
  ASHLAR_HD void soften(const SpringLaw<Real>& law, int c, const Vec3<Real>& from, const Vec3<Real>& to) const {
    const auto before = springs.softening_answer_to(law, from, c), now = springs.softening_answer_to(law, to, c);
    const Vec3<Real> brought = (now.damage > Real(0) ? damage[c] / now.damage : Real(0)) * before.slip;
    const double friction = 0.5 * work(before.rubbing + now.rubbing, now.slip - brought);
    const Vec3<Real> n = springs.normal_of(c);
    const double sliding = 0.5 * (work(before.traction.shear, split(to, n).shear) -
                                  work(now.traction.shear, split(from, n).shear) + work(now.rubbing, now.slip) -
                                  work(before.rubbing, before.slip));
    const double opening = lost_by_opening(before.traction.normal, from, now.traction.normal, to, c);
    springs.state[c] = now.state;
    damage[c] = now.damage;
    book(c, opening, sliding - friction, friction, now.slip);
  }
  /// Of a contact that was open before; one that was not had no traction yet.
  ASHLAR_HD double lost_by_opening(Real before, const Vec3<Real>& from, Real now, const Vec3<Real>& to, int c) const {
    const double a = dot(from, springs.normal_of(c)), b = dot(to, springs.normal_of(c));
    return a > 0 && b > 0 ? 0.5 * (double(before) * b - double(now) * a) : 0.0;
  }
  ASHLAR_HD void book(int c, double opening, double shear, double friction, const Vec3<Real>& slipped) const {
    const double lost[3] = {opening, shear, friction};
    for (int i = 0; i < 3; ++i) {
      dissipation[3 * c + i] += double(springs.area[c]) * lost[i];
      slip[3 * c + i] = slipped[i];
    }
  }
  ASHLAR_HD static double work(const Vec3<Real>& t, const Vec3<Real>& way) {
    return double(t.x) * double(way.x) + double(t.y) * double(way.y) + double(t.z) * double(way.z);
  }
};

/// Contact points with what they remember, for all that looks at equilibria.
template <class Real, class View = SpringView<Real>>
struct SpringMemory {
  View springs;
  Summed<Real> u;
  Real* slip;    ///< [3 * contacts] m, the same array as SpringView::slip
  Real* damage;  ///< [contacts], the same array as SpringView::damage; null: nothing softens

  ASHLAR_HD bool softens(const SpringLaw<Real>& law) const { return damage && law.softens(); }
  ASHLAR_HD SofteningAnswer<Real> softened(const SpringLaw<Real>& law, int c) const {
    return springs.softening_answer_to(law, springs.stretch(springs.gap(u, c), c), c);
  }
};

/// Phase keep_springs: at an equilibrium, slip and damage become those to go on from, one straight step away from the
/// last ones. Sums: energy that this took out by opening, shear and friction, J; contact points that have softened to
/// the end.
template <class Real, class View = SpringView<Real>>
struct KeepSprings {
  SpringMemory<Real, View> memory;

  ASHLAR_HD void operator()(int c, double (&sum)[4]) const {
    const View& springs = memory.springs;
    const auto law = springs.law_of(c);
    if (memory.softens(law)) {
      const auto now = memory.softened(law, c);
      sum[3] = is_cracked(now.state) && !is_cracked(springs.state[c]) ? 1 : 0;
      springs.state[c] = now.state;
      memory.damage[c] = now.damage;
      keep(c, now.slip, {double(now.lost.opening), double(now.lost.shear), double(now.lost.friction)}, sum);
    } else if (law.separates() && !law.can_break(springs.state[c])) {
      const auto now = springs.answer(memory.u, c);
      keep(c, now.slip, {0, 0, double(dot(now.traction.shear, now.slip - springs.slip_of(c)))}, sum);
    }
  }

 private:
  ASHLAR_HD void keep(int c, const Vec3<Real>& slip, const Dissipation<double>& lost, double (&sum)[4]) const {
    for (int i = 0; i < 3; ++i) memory.slip[3 * c + i] = slip[i];
    const double area = double(memory.springs.area[c]);
    sum[0] = area * lost.opening;
    sum[1] = area * lost.shear;
    sum[2] = area * lost.friction;
  }
};

/// Largest: CrackKey of those that KeepSprings will find softened to the end.
template <class Real, class View = SpringView<Real>>
struct FirstSoftened {
  SpringMemory<Real, View> memory;
  const int* number;  ///< [contacts] in the model

  ASHLAR_HD void operator()(int c, double (&key)[1]) const {
    const auto law = memory.springs.law_of(c);
    if (!memory.softens(law) || is_cracked(memory.springs.state[c])) return;
    const ContactState state = memory.softened(law, c).state;
    if (is_cracked(state)) key[0] = CrackKey::of(number[c], state);
  }
};

/// One contact point -> whether its sides hold each other now, bonded or pressed together. Sum: those that did at the
/// last look and no longer do.
template <class Real, class View = SpringView<Real>>
struct LookAtSprings {
  SpringMemory<Real, View> memory;
  std::uint8_t* joined;  ///< [contacts]

  ASHLAR_HD void operator()(int c, double (&sum)[1]) const {
    const View& springs = memory.springs;
    const auto law = springs.law_of(c);
    const bool bonded = memory.softens(law) ? memory.softened(law, c).damage < Real(1) : law.holds(springs.state[c]);
    const auto gap = split(springs.stretch(springs.gap(memory.u, c), c), springs.normal_of(c));
    const bool now = bonded || gap.normal <= Real(0);
    sum[0] = joined[c] && !now ? 1 : 0;
    joined[c] = now;
  }
};

}  // namespace ashlar
