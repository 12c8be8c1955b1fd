#pragma once
#include <cstddef>

#include "base/tensor.hpp"
#include "model/view.hpp"

/// Conjugate gradients on the elastic balance K u = load, matrix-free, with two preconditioners added: the virtual mass
/// of relaxation (near-diagonal) and a coarse solution in rigid movements of node aggregates. Vectors of held
/// components are zero throughout.
namespace ashlar {

template <class Real>
struct BalanceView {
  BodyView<Real> body;
  GroupView<Real> groups;
  Real* residual = nullptr;        ///< [3 * nodes] N
  Real* preconditioned = nullptr;  ///< [3 * nodes] m
  Real* direction = nullptr;       ///< [3 * nodes] m
  Real* product = nullptr;         ///< [3 * nodes] N, stiffness times direction
  int aggregate_count = 0;
  const int* aggregate = nullptr;        ///< [nodes]
  const int* aggregate_first = nullptr;  ///< [aggregates + 1] into aggregate_node
  const int* aggregate_node = nullptr;   ///< [nodes]
  const int* aggregate_block = nullptr;  ///< [aggregates + 1] into blocks of sums
  const int* block_aggregate = nullptr;  ///< [blocks]
  const Real* arm = nullptr;             ///< [3 * nodes] m, from the centre of the node's aggregate
  const double* compliance = nullptr;    ///< [6 * aggregates squared] symmetric, rigid movements per resultant
  double* partial = nullptr;             ///< [6 * block_lanes * blocks] N, N m
  double* resultant = nullptr;           ///< [6 * aggregates] N, N m
  double* movement = nullptr;            ///< [6 * aggregates] m, rad
  ASHLAR_HD bool held(int node, int c) const { return (unsigned(body.fixed[node]) >> c) & 1u; }
};

/// Rigid movements per aggregate: three translations, three rotations about its centre.
inline constexpr int rigid_modes = 6;

/// One node -> what is out of balance at the present displacement.
template <class Real>
struct BalanceResidual {
  BalanceView<Real> view;
  ASHLAR_HD void operator()(int node) const {
    for (int c = 0; c < 3; ++c) {
      const int i = 3 * node + c;
      view.residual[i] = view.held(node, c) ? Real(0) : view.body.load[i] - view.body.force[i];
    }
  }
};

/// One node group -> inverse virtual mass times residual.
template <class Real>
struct BalancePrecondition {
  BalanceView<Real> view;
  ASHLAR_HD void operator()(int group) const {
    const GroupView<Real>& groups = view.groups;
    for (int c = 0; c < 3; ++c) {
      Real sum = Real(0);
      bool any_held = false;
      for (int j = groups.begin(group); j < groups.end(group); ++j) {
        any_held = any_held || view.held(groups.node(j), c);
        sum += view.residual[3 * groups.node(j) + c];
      }
      const Real shared = any_held || groups.single(group) ? Real(0) : groups.pull[group] * sum;
      for (int j = groups.begin(group); j < groups.end(group); ++j) {
        const int node = groups.node(j), i = 3 * node + c;
        view.preconditioned[i] =
            view.held(node, c) ? Real(0) : fma(view.body.inverse_mass[node], view.residual[i], shared);
      }
    }
  }
};

/// Nodes of an aggregate are summed in blocks, whose lanes take every block_lanes-th node, so that lanes side by side
/// read side by side.
inline constexpr int block_lanes = 32, nodes_per_lane = 32, nodes_per_block = block_lanes * nodes_per_lane;

/// Sums of many numbers go in parts that wait for each other no more than once a round.
inline constexpr int parts_of_sum = 8;
ASHLAR_HD double total(const double (&part)[parts_of_sum]) {
  return ((part[0] + part[1]) + (part[2] + part[3])) + ((part[4] + part[5]) + (part[6] + part[7]));
}

/// One lane of a block -> force and moment of the residual of its nodes, in double.
template <class Real>
struct BalanceRestrict {
  BalanceView<Real> view;
  ASHLAR_HD void operator()(int i) const {
    const int block = i / block_lanes, a = view.block_aggregate[block], end = view.aggregate_first[a + 1];
    int j = view.aggregate_first[a] + (block - view.aggregate_block[a]) * nodes_per_block + i % block_lanes;
    double s[rigid_modes] = {};
    for (int k = 0; k < nodes_per_lane && j < end; ++k, j += block_lanes) {
      const int n = 3 * view.aggregate_node[j];
      const double x = view.arm[n], y = view.arm[n + 1], z = view.arm[n + 2];
      const double fx = view.residual[n], fy = view.residual[n + 1], fz = view.residual[n + 2];
      s[0] += fx;
      s[1] += fy;
      s[2] += fz;
      s[3] += y * fz - z * fy;
      s[4] += z * fx - x * fz;
      s[5] += x * fy - y * fx;
    }
    for (int k = 0; k < rigid_modes; ++k) view.partial[rigid_modes * i + k] = s[k];
  }
};

/// One component of an aggregate's resultant in one lane of all its blocks, in the room of the first.
template <class Real>
struct BalanceLanes {
  BalanceView<Real> view;
  ASHLAR_HD void operator()(int i) const {
    constexpr int numbers = rigid_modes * block_lanes;
    const int a = i / numbers, first = view.aggregate_block[a], end = view.aggregate_block[a + 1];
    double sum[parts_of_sum] = {};
    for (int b = first; b < end; b += parts_of_sum)
      for (int k = 0; k < parts_of_sum; ++k)
        if (b + k < end) sum[k] += view.partial[numbers * (b + k) + i % numbers];
    view.partial[numbers * first + i % numbers] = total(sum);
  }
};
/// One component of an aggregate's resultant.
template <class Real>
struct BalanceResultant {
  BalanceView<Real> view;
  ASHLAR_HD void operator()(int i) const {
    const int first = rigid_modes * block_lanes * view.aggregate_block[i / rigid_modes] + i % rigid_modes;
    double sum[parts_of_sum] = {};
    for (int l = 0; l < block_lanes; l += parts_of_sum)
      for (int k = 0; k < parts_of_sum; ++k) sum[k] += view.partial[first + rigid_modes * (l + k)];
    view.resultant[i] = total(sum);
  }
};

/// One rigid movement that answers to the resultants.
template <class Real>
struct BalanceCoarse {
  BalanceView<Real> view;
  ASHLAR_HD void operator()(int i) const {
    const int count = rigid_modes * view.aggregate_count;
    double sum[parts_of_sum] = {};
    for (int j = 0; j < count; j += parts_of_sum)
      for (int k = 0; k < parts_of_sum; ++k)
        if (j + k < count) sum[k] += view.compliance[std::size_t(j + k) * count + i] * view.resultant[j + k];
    view.movement[i] = total(sum);
  }
};

/// One node -> the rigid movement of its aggregate, added to the preconditioned residual.
template <class Real>
struct BalanceProlong {
  BalanceView<Real> view;
  ASHLAR_HD void operator()(int node) const {
    const int n = 3 * node;
    const double* m = view.movement + rigid_modes * view.aggregate[node];
    const double x = view.arm[n], y = view.arm[n + 1], z = view.arm[n + 2];
    const double moved[3] = {m[0] + m[4] * z - m[5] * y, m[1] + m[5] * x - m[3] * z, m[2] + m[3] * y - m[4] * x};
    for (int c = 0; c < 3; ++c)
      if (!view.held(node, c)) view.preconditioned[n + c] += Real(moved[c]);
  }
};

/// One component of a node -> the next direction: preconditioned residual plus `keep` times the last one.
template <class Real>
struct BalanceTurn {
  BalanceView<Real> view;
  Real keep;
  ASHLAR_HD void operator()(int i) const { view.direction[i] = fma(keep, view.direction[i], view.preconditioned[i]); }
};

/// One component of a node -> moved by `length` along the direction.
template <class Real>
struct BalanceAdvance {
  BalanceView<Real> view;
  Real length;
  ASHLAR_HD void operator()(int i) const {
    if (view.held(i / 3, i % 3)) return;
    SummedValue<Real> u = view.body.u[i];
    u.add_product(length, view.direction[i]);
    view.body.u.write(i, u);
    view.residual[i] = fma(-length, view.product[i], view.residual[i]);
  }
};

enum BalanceSum : int {
  balance_residual,        ///< residual . residual, N^2
  balance_preconditioned,  ///< residual . preconditioned, N m
  balance_sum_count
};

/// One node -> its share of every sum, in double.
template <class Real>
struct BalanceSums {
  BalanceView<Real> view;
  ASHLAR_HD void operator()(int node, double (&s)[balance_sum_count]) const {
    for (int i = 3 * node; i < 3 * node + 3; ++i) {
      const double r = view.residual[i];
      s[balance_residual] += r * r;
      s[balance_preconditioned] += r * double(view.preconditioned[i]);
    }
  }
};

/// One node -> its share of direction . product over free components, in double, N m.
template <class Real>
struct BalanceAlong {
  BalanceView<Real> view;
  ASHLAR_HD void operator()(int node, double (&s)[1]) const {
    for (int i = 3 * node; i < 3 * node + 3; ++i) s[0] += double(view.direction[i]) * double(view.product[i]);
  }
};

}  // namespace ashlar
