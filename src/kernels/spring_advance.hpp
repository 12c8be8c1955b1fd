#pragma once
#include "kernels/spring_view.hpp"

/// Phase advance_springs: in a motion, springs crack and slide from step to step (in static stages at equilibria only).
namespace ashlar {

/// One contact point -> its state and slip at the present displacement, and the energy that this took out: what its
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

}  // namespace ashlar
