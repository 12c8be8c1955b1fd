#pragma once
#include "base/number.hpp"
#include "kernels/heat_view.hpp"

/// Phase step_heat: C dT/dt + K T = Q by forward Euler with lumped capacity (numerics 6).
namespace ashlar {

/// One node -> its temperature one step later; held nodes keep theirs or take what is given.
template <class Real>
struct StepHeat {
  HeatView<Real> heat;
  const Real* time_step;  ///< s

  ASHLAR_HD void operator()(int node) const {
    SummedValue<Real> temperature = heat.temperature[node];
    step(*time_step, read(node), heat.flow[node], temperature);
    heat.temperature.write(node, temperature);
  }

  /// For machines that make a node's step as soon as its conduction is there: see MoveNode. Film has to be in
  /// HeatView::film_flow.
  static constexpr bool moves = true;
  struct Before {
    Real heat, inverse_capacity, given, film;
    std::uint8_t held;
  };
  ASHLAR_HD Before read(int node) const {
    return {heat.heat[node], heat.inverse_capacity[node], heat.given_temperature ? heat.given_temperature[node] : Real(0),
            heat.film_flow ? heat.film_flow[node] : Real(0), heat.held[node]};
  }
  ASHLAR_HD Real controls() const { return *time_step; }
  ASHLAR_HD Real* result() const { return heat.flow; }
  /// Heat flow of the node.
  ASHLAR_HD Real operator()(Real length, const Before& before, int, Real conducted, SummedValue<Real>& temperature) const {
    const Real flow = conducted + before.film;
    step(length, before, flow, temperature);
    return flow;
  }

 private:
  ASHLAR_HD void step(Real length, const Before& before, Real flow, SummedValue<Real>& temperature) const {
    if (!before.held) {
      temperature.add_product(length * before.inverse_capacity, before.heat - flow);
    } else if (heat.given_temperature) {
      temperature = {};
      temperature.add(before.given);
    }
  }
};

}  // namespace ashlar
