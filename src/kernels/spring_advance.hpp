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
  double* dissipation;  ///< [contacts] J, since the stage began

  ASHLAR_HD void operator()(int c) const {
    const auto& law = springs.law_of(c);
    const auto before = springs.answer(u, c);
    double lost = 0;
    auto now = before;
    if (law.can_break(springs.state[c])) {
      const auto used = utilisation(law, before.traction);
      if (used.largest() < Real(1)) return;
      springs.state[c] = used.mode();
      now = springs.answer(u, c);
      lost = stored(before.traction, c) - stored(now.traction, c);
    } else {
      lost = double(dot(now.traction.shear, now.slip - springs.slip_of(c)));
    }
    dissipation[c] += double(springs.area[c]) * lost;
    for (int i = 0; i < 3; ++i) slip[3 * c + i] = now.slip[i];
  }

 private:
  /// Elastic energy per area, J/m^2.
  ASHLAR_HD double stored(const Split<Real>& t, int c) const {
    return 0.5 * (double(t.normal) * double(t.normal) / double(springs.normal_stiffness[c]) +
                  double(dot(t.shear, t.shear)) / double(springs.shear_stiffness[c]));
  }
};

}  // namespace ashlar
