#pragma once
#include "kernels/heat_flow.hpp"

/// Phase gauss_temperature: all that the thermal lane hands to the mechanical one (numerics 7).
namespace ashlar {

/// One element -> warming above the reference temperature at its Gauss points, in the order of the stress routine.
template <template <class> class Element, class Real>
struct GaussTemperature {
  HeatView<Real> heat;
  BatchView batch;
  Real reference;  ///< degC
  Real* warming;   ///< [Gauss points] K

  ASHLAR_HD void operator()(int i) const {
    constexpr int corners = Element<Real>::corners;
    Real temperature[corners];
    int node[corners];
    read_nodes(heat.nodes, batch, i, node);
    // the difference before the sum: no rounding of large temperatures enters a small warming
    for (int k = 0; k < corners; ++k) temperature[k] = heat.temperature.above(node[k], reference);
    ASHLAR_UNROLL
    for (int g = 0; g < Element<Real>::gauss_points; ++g)
      warming[batch.gauss(i, g)] = at_gauss_point<Element<Real>>(temperature, g);
  }
};

}  // namespace ashlar
