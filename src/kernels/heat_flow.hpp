#pragma once
#include "kernels/heat_view.hpp"
#include "physics/conduction.hpp"

/// Phase heat_flow: K T of the paper's (10), element by element, and the film on top. No matrix of the body is formed.
namespace ashlar {

/// Corner coordinates of one element, [component][corner].
template <int corners, class Real>
ASHLAR_HD void read_places(const HeatView<Real>& heat, const BatchView& batch, int i, Real (&x)[3][corners]) {
  const int first = batch.first_entry(heat.nodes, i);
  ASHLAR_UNROLL
  for (int k = 0; k < corners; ++k)
    for (int c = 0; c < 3; ++c)
      x[c][k] = heat.x[3 * (first + heat.nodes.corner_entry[batch.slot(i, corners, k)]) + c];
}

/// Nodes at the corners of one element.
template <int corners>
ASHLAR_HD void read_nodes(const NodeSetView& nodes, const BatchView& batch, int i, int (&node)[corners]) {
  const int first = batch.first_entry(nodes, i);
  ASHLAR_UNROLL
  for (int k = 0; k < corners; ++k) node[k] = nodes.entry_node[first + nodes.corner_entry[batch.slot(i, corners, k)]];
}

/// One element -> heat leaving through its own corner slots.
template <template <class> class Element, class Real>
struct HeatFlow {
  HeatView<Real> heat;
  BatchView batch;
  Real conductivity;
  Summed<Real> field;  ///< [nodes] temperature, or the search direction of conjugate gradients

  ASHLAR_HD void operator()(int i) const {
    constexpr int corners = Element<Real>::corners;
    Real x[3][corners], temperature[corners], flow[corners];
    read_places(heat, batch, i, x);
    int node[corners];
    read_nodes(heat.nodes, batch, i, node);
    ASHLAR_UNROLL
    for (int k = 0; k < corners; ++k) temperature[k] = relative(field[node[k]], field[node[0]]);
    heat_flow<Element<Real>>(x, temperature, conductivity, flow);
    ASHLAR_UNROLL
    for (int k = 0; k < corners; ++k) heat.corner[batch.slot(i, corners, k)] = flow[k];
  }
};

/// One node with film -> what leaves through it.
template <class Real>
struct FilmFlow {
  HeatView<Real> heat;
  Summed<Real> field;  ///< [nodes]

  ASHLAR_HD void operator()(int i) const {
    Real sum = Real(0);
    for (int j = heat.film_first[i]; j < heat.film_first[i + 1]; ++j)
      sum = fma(heat.film_value[j], field[heat.film_column[j]].high, sum);
    heat.film_flow[heat.film_node[i]] = sum;
  }
};

/// One node with film -> adds it to the conducted flow.
template <class Real>
struct AddFilm {
  HeatView<Real> heat;
  ASHLAR_HD void operator()(int i) const { heat.flow[heat.film_node[i]] += heat.film_flow[heat.film_node[i]]; }
};

/// One element -> diagonal and absolute row sum of its conduction, in its corner slots (Gershgorin: their nodal sums
/// bound the fastest rate). The columns are the flows of unit temperatures through the same routine.
template <template <class> class Element, class Real>
struct HeatBound {
  HeatView<Real> heat;
  BatchView batch;
  Real conductivity;

  ASHLAR_HD void operator()(int i) const {
    constexpr int corners = Element<Real>::corners;
    Real x[3][corners], unit[corners], flow[corners], diagonal[corners], row_sum[corners];
    read_places(heat, batch, i, x);
    for (int k = 0; k < corners; ++k) row_sum[k] = unit[k] = Real(0);
    for (int k = 0; k < corners; ++k) {
      unit[k] = Real(1);
      heat_flow<Element<Real>>(x, unit, conductivity, flow);
      unit[k] = Real(0);
      diagonal[k] = flow[k];
      for (int q = 0; q < corners; ++q) row_sum[q] += flow[q] < Real(0) ? -flow[q] : flow[q];
    }
    for (int k = 0; k < corners; ++k) {
      heat.corner[2 * batch.slot(i, corners, k)] = diagonal[k];
      heat.corner[2 * batch.slot(i, corners, k) + 1] = row_sum[k];
    }
  }
};

/// One node with film -> adds the film's diagonal and absolute row sum.
template <class Real>
struct FilmBound {
  HeatView<Real> heat;

  ASHLAR_HD void operator()(int i) const {
    const int node = heat.film_node[i];
    for (int j = heat.film_first[i]; j < heat.film_first[i + 1]; ++j) {
      if (heat.film_column[j] == node) heat.bound[2 * node] += heat.film_value[j];
      heat.bound[2 * node + 1] += larger(heat.film_value[j], -heat.film_value[j]);
    }
  }
};

}  // namespace ashlar
