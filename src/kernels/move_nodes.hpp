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
  bool operator==(const StepDamping&) const = default;
};

/// One node by itself -> velocity and displacement after a step, from the force that acts on it.
template <class Real>
struct MoveNode {
  BodyView<Real> body;
  const StepDamping<Real>* damping;

  /// What a step needs of the node beside its force, N.
  struct Before {
    SummedValue<Real> u[3];
    Real v[3], load[3], inverse_mass;
    std::uint8_t fixed;
  };
  ASHLAR_HD Before read(int node) const {
    Before b;
    ASHLAR_UNROLL
    for (int c = 0; c < 3; ++c) {
      b.u[c] = body.u[3 * node + c];
      b.v[c] = body.v[3 * node + c];
      b.load[c] = body.load[3 * node + c];
    }
    b.inverse_mass = body.inverse_mass[node];
    b.fixed = body.fixed[node];
    return b;
  }
  ASHLAR_HD static bool held(const Before& b, int c) { return (unsigned(b.fixed) >> c) & 1u; }

  /// Unbalanced force, less local damping; `force` is internal and contact force.
  ASHLAR_HD static Real damped_force(const StepDamping<Real>& d, const Before& b, int c, Real force) {
    const Real f = b.load[c] - force;
    const Real sign = Real((b.v[c] > Real(0)) - (b.v[c] < Real(0)));
    return fma(-d.local * (f < Real(0) ? -f : f), sign, f);
  }

  /// @param shared acceleration of the group that the node belongs to
  ASHLAR_HD void component(const StepDamping<Real>& d, int node, const Before& b, int c, Real force,
                           Real shared) const {
    if (held(b, c)) return;
    const Real moved = fma(d.keep, b.v[c], d.gain * fma(b.inverse_mass, damped_force(d, b, c, force), shared));
    body.v[3 * node + c] = moved;
    SummedValue<Real> u = b.u[c];
    u.add(moved);
    body.u.write(3 * node + c, u);
  }

  ASHLAR_HD void operator()(int node, const Before& b, const Real (&force)[3]) const {
    const StepDamping<Real> d = *damping;
    ASHLAR_UNROLL
    for (int c = 0; c < 3; ++c) component(d, node, b, c, force[c], Real(0));
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
        move.component(*move.damping, node, move.read(node), c, move.body.force[3 * node + c], shared);
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
      const auto before = move.read(node);
      if (move.held(before, c)) return Real(0);
      sum += move.damped_force(*move.damping, before, c, move.body.force[3 * node + c]);
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
