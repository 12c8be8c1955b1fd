#pragma once
#include "base/number.hpp"
#include "model/view.hpp"

/// Phase move_nodes: paper (13), velocity first, then displacement, with unit time step and virtual mass (numerics 3).
namespace ashlar {

/// Damping of one step: local (Cundall) and mass-proportional, both central.
template <class Real>
struct StepDamping {
  Real local = 0;  ///< alpha: force opposes motion by alpha |f|
  Real keep = 1;   ///< (2 - c) / (2 + c), c the viscous coefficient times the step
  Real gain = 1;   ///< 2 / (2 + c)
};

template <class Real>
struct MoveNodes {
  BodyView<Real> body;
  StepDamping<Real> damping;

  ASHLAR_HD void operator()(int node) const {
    const Real scale = damping.gain * body.inverse_mass[node];
    const unsigned fixed = body.fixed[node];
    for (int c = 0; c < 3; ++c) {
      const int i = 3 * node + c;
      if ((fixed >> c) & 1u) continue;
      Real f = body.load[i] - body.force[i];
      const Real v = body.v[i];
      const Real sign = Real((v > Real(0)) - (v < Real(0)));
      f = fma(-damping.local * (f < Real(0) ? -f : f), sign, f);
      const Real moved = fma(damping.keep, v, scale * f);
      body.v[i] = moved;
      body.u[i] += moved;
    }
  }
};

/// Remembers the force of this step for the stiffness estimate of the next.
template <class Real>
struct KeepForce {
  BodyView<Real> body;
  ASHLAR_HD void operator()(int node) const {
    for (int c = 0; c < 3; ++c) body.kept_force[3 * node + c] = body.force[3 * node + c];
  }
};

}  // namespace ashlar
