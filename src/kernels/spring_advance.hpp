#pragma once
#include "kernels/spring_view.hpp"

/// Phase advance_springs: in a motion, springs crack and slide from step to step (in static stages at equilibria only).
namespace ashlar {

/// One contact point -> its state and slip at the present displacement, and the energy that this took out. Slip moves
/// by Coulomb's return; what a cracking spring loses beyond its friction is gone at once.
template <class Real, class View = SpringView<Real>>
struct AdvanceSprings {
  View springs;
  Summed<Real> u;
  Real* slip;           ///< [3 * contacts] m, the same array as SpringView::slip
  Real* damage;         ///< [contacts], the same array as SpringView::damage; null: nothing softens
  double* dissipation;  ///< [3 * contacts] J since the stage began: of opening, shear, friction

  ASHLAR_HD void operator()(int c) const {
    const auto law = springs.law_of(c);
    if (damage && law.softens()) {
      const auto now = springs.softening_answer_to(law, springs.stretch(springs.gap(u, c), c), c);
      springs.state[c] = now.state;
      damage[c] = now.damage;
      book(c, double(now.lost.opening), double(now.lost.shear), double(now.lost.friction), now.slip);
      return;
    }
    const auto before = springs.answer(u, c);
    if (!law.can_break(springs.state[c]))
      return book(c, 0, 0, double(dot(before.traction.shear, before.slip - springs.slip_of(c))), before.slip);
    const auto used = utilisation(law, before.traction);
    if (used.largest() < Real(1)) return;
    springs.state[c] = used.mode();
    const auto now = springs.answer(u, c);
    book(c,
         stored(before.traction.normal, springs.normal_stiffness[c]) -
             stored(now.traction.normal, springs.normal_stiffness[c]),
         stored(norm(before.traction.shear), springs.shear_stiffness[c]) -
             stored(norm(now.traction.shear), springs.shear_stiffness[c]),
         0, now.slip);
  }

 private:
  ASHLAR_HD void book(int c, double opening, double shear, double friction, const Vec3<Real>& slipped) const {
    const double lost[3] = {opening, shear, friction};
    for (int i = 0; i < 3; ++i) {
      dissipation[3 * c + i] += double(springs.area[c]) * lost[i];
      slip[3 * c + i] = slipped[i];
    }
  }
  /// Elastic energy per area, J/m^2.
  ASHLAR_HD static double stored(Real traction, Real stiffness) {
    return 0.5 * double(traction) * double(traction) / double(stiffness);
  }
};

}  // namespace ashlar
