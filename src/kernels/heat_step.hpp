#pragma once
#include "base/number.hpp"
#include "kernels/heat_view.hpp"

/// Phase step_heat: C dT/dt + K T = Q by forward Euler with lumped capacity (numerics 6).
namespace ashlar {

/// One node -> its temperature one step later; held nodes keep theirs or take what is given.
template <class Real>
struct StepHeat {
  HeatView<Real> heat;
  Real time_step;  ///< s

  ASHLAR_HD void operator()(int node) const {
    if (heat.held[node]) {
      if (!heat.given_temperature) return;
      SummedValue<Real> given{};
      given.add(heat.given_temperature[node]);
      return heat.temperature.write(node, given);
    }
    SummedValue<Real> temperature = heat.temperature[node];
    temperature.add_product(time_step * heat.inverse_capacity[node], heat.heat[node] - heat.flow[node]);
    heat.temperature.write(node, temperature);
  }
};

}  // namespace ashlar
