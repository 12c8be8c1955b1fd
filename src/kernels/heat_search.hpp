#pragma once
#include "base/number.hpp"
#include "kernels/heat_view.hpp"

/// Conjugate gradients with the diagonal as preconditioner for steady temperature, K T = Q on nodes that are not held.
/// Residual and direction of held nodes are zero throughout.
namespace ashlar {

/// One node -> residual of the present temperature and the first direction.
template <class Real>
struct StartSearch {
  HeatView<Real> heat;

  ASHLAR_HD void operator()(int node) const {
    const bool held = heat.held[node];
    heat.residual[node] = held ? Real(0) : heat.heat[node] - heat.flow[node];
    heat.direction[node] = held ? Real(0) : heat.residual[node] / heat.bound[2 * node];
  }
};

/// One node -> moved by `length` along the direction, whose flow is in `flow`.
template <class Real>
struct AdvanceSearch {
  HeatView<Real> heat;
  Real length;

  ASHLAR_HD void operator()(int node) const {
    if (heat.held[node]) return;
    heat.temperature[node] = fma(length, heat.direction[node], heat.temperature[node]);
    heat.residual[node] = fma(-length, heat.flow[node], heat.residual[node]);
  }
};

/// One node -> the next direction: preconditioned residual plus `keep` times the last one.
template <class Real>
struct TurnSearch {
  HeatView<Real> heat;
  Real keep;

  ASHLAR_HD void operator()(int node) const {
    if (heat.held[node]) return;
    heat.direction[node] = fma(keep, heat.direction[node], heat.residual[node] / heat.bound[2 * node]);
  }
};

/// Index of each sum in a chunk's record.
enum HeatSum : int {
  sum_residual,        ///< residual . residual, W^2
  sum_preconditioned,  ///< residual . residual / diagonal, W K
  sum_along,           ///< direction . flow, W K
  heat_sum_count
};

/// Nodes of one chunk -> its sums, in index order and in double (numerics 8).
template <class Real>
struct HeatSums {
  HeatView<Real> heat;
  int chunk_nodes;
  double* chunk_sums;  ///< [heat_sum_count * chunks]

  ASHLAR_HD void operator()(int chunk) const {
    double s[heat_sum_count] = {};
    const int first = chunk * chunk_nodes;
    const int last = first + chunk_nodes < heat.nodes.node_count ? first + chunk_nodes : heat.nodes.node_count;
    for (int node = first; node < last; ++node) {
      if (heat.held[node]) continue;
      const double residual = heat.residual[node];
      s[sum_residual] += residual * residual;
      s[sum_preconditioned] += residual * (residual / double(heat.bound[2 * node]));
      s[sum_along] += double(heat.direction[node]) * double(heat.flow[node]);
    }
    for (int k = 0; k < heat_sum_count; ++k) chunk_sums[chunk * heat_sum_count + k] = s[k];
  }
};

}  // namespace ashlar
