#pragma once
#include "kernels/spring_view.hpp"

/// Phase spring_force: every spring once, then every node sums its springs, both in the model's order and without
/// atomics.
namespace ashlar {

/// One contact point -> its force (numerics 5). Slip stays as it was at the last kept equilibrium: during a relaxation
/// the traction depends on the present gap alone, so overshoot leaves no trace and the equilibrium does not depend on
/// damping.
template <class Real, class View = SpringView<Real>>
struct SpringForce {
  View springs;
  Summed<Real> u;  ///< [3 * block nodes] m

  ASHLAR_HD void operator()(int c) const {
    const Vec3<Real> force = springs.force_on_a(springs.answer(u, c), c);
    for (int i = 0; i < 3; ++i) springs.force[3 * c + i] = force[i];
  }
};

/// One node with springs -> adds them to its internal force (force = internal - external sign: what the springs pull
/// back with).
template <class Real>
struct GatherSpring {
  SpringView<Real> springs;
  Real* force;  ///< [3 * block nodes] N

  ASHLAR_HD void operator()(int i) const {
    Real sum[3] = {force[3 * springs.node[i]], force[3 * springs.node[i] + 1], force[3 * springs.node[i] + 2]};
    for (int j = springs.node_first[i]; j < springs.node_first[i + 1]; ++j) {
      const int entry = springs.node_contact[j];
      const Real* f = springs.force + 3 * (entry < 0 ? -1 - entry : entry);
      const Real sign = entry < 0 ? Real(1) : Real(-1);
      for (int k = 0; k < 3; ++k) sum[k] = fma(sign, f[k], sum[k]);
    }
    for (int k = 0; k < 3; ++k) force[3 * springs.node[i] + k] = sum[k];
  }
};

/// The same for contact points of overlaps, by the node's weight in each.
template <class Real>
struct GatherOverlap {
  OverlapView<Real> springs;
  Real* force;  ///< [3 * block nodes] N

  ASHLAR_HD void operator()(int i) const {
    const int at = 3 * springs.node[i];
    Real sum[3] = {force[at], force[at + 1], force[at + 2]};
    for (int j = springs.node_first[i]; j < springs.node_first[i + 1]; ++j) {
      const Real* f = springs.force + 3 * springs.node_contact[j];
      for (int k = 0; k < 3; ++k) sum[k] = fma(springs.node_weight[j], f[k], sum[k]);
    }
    for (int k = 0; k < 3; ++k) force[at + k] = sum[k];
  }
};

}  // namespace ashlar
