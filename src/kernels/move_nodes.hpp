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

/// One node by itself -> velocity and displacement after a step, from the force that acts on it.
template <class Real>
struct MoveNode {
  BodyView<Real> body;
  const StepDamping<Real>* damping;

  ASHLAR_HD bool held(int node, int c) const { return (unsigned(body.fixed[node]) >> c) & 1u; }

  /// Unbalanced force of component i = 3 node + c, less local damping; `force` is internal and contact force, N.
  ASHLAR_HD Real damped_force(int i, Real force) const {
    const Real f = body.load[i] - force;
    const Real v = body.v[i];
    const Real sign = Real((v > Real(0)) - (v < Real(0)));
    return fma(-damping->local * (f < Real(0) ? -f : f), sign, f);
  }

  /// @param shared acceleration of the group that the node belongs to
  ASHLAR_HD void component(int node, int c, Real force, Real shared) const {
    if (held(node, c)) return;
    const int i = 3 * node + c;
    const Real moved = fma(damping->keep, body.v[i],
                           damping->gain * fma(body.inverse_mass[node], damped_force(i, force), shared));
    body.v[i] = moved;
    body.u[i] += moved;
  }

  ASHLAR_HD void operator()(int node, const Real (&force)[3]) const {
    ASHLAR_UNROLL
    for (int c = 0; c < 3; ++c) component(node, c, force[c], Real(0));
  }
};

/// One group of nodes -> its velocities and displacements.
template <class Real>
struct MoveNodes {
  GroupView<Real> groups;
  MoveNode<Real> move;

  ASHLAR_HD void operator()(int group) const {
    for (int c = 0; c < 3; ++c) {
      const Real shared = shared_pull(group, c);
      for (int j = groups.begin(group); j < groups.end(group); ++j) {
        const int node = groups.node(j);
        move.component(node, c, move.body.force[3 * node + c], shared);
      }
    }
  }

 private:
  /// Acceleration of the whole group by the sum of its forces; none where a support holds one of its nodes.
  ASHLAR_HD Real shared_pull(int group, int c) const {
    if (groups.single(group)) return Real(0);
    Real sum = Real(0);
    for (int j = groups.begin(group); j < groups.end(group); ++j) {
      const int node = groups.node(j);
      if (move.held(node, c)) return Real(0);
      sum += move.damped_force(3 * node + c, move.body.force[3 * node + c]);
    }
    return groups.pull[group] * sum;
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
