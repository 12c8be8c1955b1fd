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
    SummedValue<Real> temperature = heat.temperature[node];
    temperature.add_product(length, heat.direction[node]);
    heat.temperature.write(node, temperature);
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

enum HeatSum : int {
  sum_residual,        ///< residual . residual, W^2
  sum_preconditioned,  ///< residual . residual / diagonal, W K
  sum_along,           ///< direction . flow, W K
  heat_sum_count
};

/// One node -> its share of every sum, in double; nothing where the temperature is held.
template <class Real>
struct HeatSums {
  HeatView<Real> heat;

  ASHLAR_HD void operator()(int node, double (&s)[heat_sum_count]) const {
    if (heat.held[node]) return;
    const double residual = heat.residual[node];
    s[sum_residual] = residual * residual;
    s[sum_preconditioned] = residual * (residual / double(heat.bound[2 * node]));
    s[sum_along] = double(heat.direction[node]) * double(heat.flow[node]);
  }
};

}  // namespace ashlar
