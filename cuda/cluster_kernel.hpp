#pragma once
#include "cluster_lists.hpp"
#include "kernels/move_nodes.hpp"
#include "kernels/spring_view.hpp"

namespace ashlar {

/// One step of nodes with springs, whole clusters a thread group: every contact point once, one thread a node for its
/// sum and its step. The same as SpringForce, GatherSpring, PullGroup and MoveNodes one after the other.
template <class Real>
__global__ void __launch_bounds__(cluster_members, 8)
    step_clusters(const ClusterListsView lists, const SpringView<Real> springs, const GroupView<Real> groups,
                  const MoveNode<Real> step) {
  __shared__ SummedValue<Real> u[3][cluster_members];
  __shared__ Real damped[3][cluster_members], pull[3][cluster_pairs];
  __shared__ std::uint8_t fixed[cluster_members];
  const ClusterHead head = lists.heads[blockIdx.x];
  const BodyView<Real>& body = step.body;
  const int member = threadIdx.x;
  const bool mine = member < head.members;
  int node = 0;
  typename MoveNode<Real>::Before before{};
  Real force[3] = {};
  if (mine) {
    node = lists.node[head.first_member + member];
    for (int k = 0; k < 3; ++k) u[k][member] = body.u[3 * node + k];
    before = step.read(node);
    for (int k = 0; k < 3; ++k) force[k] = body.force[3 * node + k];
    fixed[member] = before.fixed;
  }
  __syncthreads();

  for (int i = threadIdx.x; i < head.pairs; i += cluster_members) {
    const int c = head.first_pair + i;
    const ClusterEnds ends = lists.ends[c];
    Vec3<Real> gap;
    for (int k = 0; k < 3; ++k) gap[k] = difference(u[k][ends.b], u[k][ends.a]);
    const Vec3<Real> force = springs.force_on_a(springs.answer_to(springs.stretch(gap, c), c), c);
    for (int k = 0; k < 3; ++k) pull[k][i] = force[k];
  }
  __syncthreads();

  const auto controls = step.controls();
  if (mine) {
    const int first = member == 0 ? 0 : lists.uses_end[head.first_member + member - 1];
    const int last = lists.uses_end[head.first_member + member];
    for (int j = first; j < last; ++j) {
      const int use = lists.use[2 * head.first_pair + j];
      const Real sign = use & 1 ? Real(1) : Real(-1);
      for (int k = 0; k < 3; ++k) force[k] = fma(sign, pull[k][use >> 1], force[k]);
    }
    for (int k = 0; k < 3; ++k) damped[k][member] = step.damped_force(controls, before.along[k], force[k]);
  }
  __syncthreads();
  if (!mine) return;

  Real shared[3] = {};
  if (groups.first) {
    const int group = groups.of_node[node];
    if (!groups.single(group)) {
      unsigned held = 0;
      for (int j = groups.begin(group); j < groups.end(group); ++j) {
        const int other = lists.place[groups.node(j)];
        held |= fixed[other];
        for (int k = 0; k < 3; ++k) shared[k] += damped[k][other];
      }
      for (int k = 0; k < 3; ++k)
        shared[k] = step.held(static_cast<std::uint8_t>(held), k) ? Real(0) : groups.pull[group] * shared[k];
    }
  }
  for (int k = 0; k < 3; ++k) {
    SummedValue<Real> moved = u[k][member];
    body.v[3 * node + k] = step(controls, before, k, force[k], moved, shared[k]);
    body.u.write(3 * node + k, moved);
  }
}

}  // namespace ashlar
