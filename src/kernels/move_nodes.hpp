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

  /// What a step needs beside displacement and force of one component of a node.
  struct Component {
    Real v, load;
  };
  ASHLAR_HD Component read_component(int i) const { return {body.v[i], body.load[i]}; }
  ASHLAR_HD static bool held(std::uint8_t fixed, int c) { return (unsigned(fixed) >> c) & 1u; }

  /// Unbalanced force, less local damping; `force` is internal and contact force, N.
  ASHLAR_HD static Real damped_force(const StepDamping<Real>& d, const Component& before, Real force) {
    const Real f = before.load - force;
    const Real sign = Real((before.v > Real(0)) - (before.v < Real(0)));
    return fma(-d.local * (f < Real(0) ? -f : f), sign, f);
  }

  /// A whole node, for machines that make its step as soon as its force is there: they ask for this early, keep what
  /// comes back in result().
  static constexpr bool moves = true;
  struct Before {
    Component along[3];
    Real inverse_mass;
    std::uint8_t fixed;
  };
  ASHLAR_HD Before read(int node) const {
    return {{read_component(3 * node), read_component(3 * node + 1), read_component(3 * node + 2)},
            body.inverse_mass[node],
            body.fixed[node]};
  }
  ASHLAR_HD StepDamping<Real> controls() const { return *damping; }
  ASHLAR_HD Real* result() const { return body.v; }
  /// Velocity of component c of a node after the step; its displacement `u` moves.
  /// @param shared acceleration of the group that the node belongs to
  ASHLAR_HD Real operator()(const StepDamping<Real>& d, const Before& before, int c, Real force, SummedValue<Real>& u,
                            Real shared = Real(0)) const {
    const Real moved = fma(d.keep, before.along[c].v,
                           d.gain * fma(before.inverse_mass, damped_force(d, before.along[c], force), shared));
    SummedValue<Real> at = u;
    at.add(moved);
    const bool free = !held(before.fixed, c);  // chosen, not branched on: lanes stay together
    u = free ? at : u;
    return free ? moved : before.along[c].v;
  }
};

/// One component of one group -> acceleration of the whole group by the sum of its forces; none where a support holds
/// one of its nodes.
template <class Real>
struct PullGroup {
  GroupView<Real> groups;
  MoveNode<Real> step;

  ASHLAR_HD void operator()(int i) const {
    const int group = i / 3, c = i % 3;
    if (groups.single(group)) {
      groups.shared[i] = Real(0);
      return;
    }
    const StepDamping<Real> d = *step.damping;
    Real sum = Real(0);
    bool held = false;
    for (int j = groups.begin(group); j < groups.end(group); ++j) {
      const int node = groups.node(j), k = 3 * node + c;
      held = held || step.held(step.body.fixed[node], c);
      sum += step.damped_force(d, step.read_component(k), step.body.force[k]);
    }
    groups.shared[i] = held ? Real(0) : groups.pull[group] * sum;
  }
};

/// One node -> its velocity and displacement, with the acceleration that its group shares.
template <class Real>
struct MoveNodes {
  GroupView<Real> groups;
  MoveNode<Real> step;

  ASHLAR_HD void operator()(int node) const {
    const BodyView<Real>& body = step.body;
    const StepDamping<Real> d = *step.damping;
    const auto before = step.read(node);
    const Real* shared = groups.first ? groups.shared + 3 * groups.of_node[node] : nullptr;
    ASHLAR_UNROLL
    for (int c = 0; c < 3; ++c) {
      const int i = 3 * node + c;
      SummedValue<Real> u = body.u[i];
      body.v[i] = step(d, before, c, body.force[i], u, shared ? shared[c] : Real(0));
      body.u.write(i, u);
    }
  }
};

/// One node at rest.
template <class Real>
struct StopNode {
  BodyView<Real> body;
  ASHLAR_HD void operator()(int node) const {
    for (int c = 0; c < 3; ++c) body.v[3 * node + c] = Real(0);
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
