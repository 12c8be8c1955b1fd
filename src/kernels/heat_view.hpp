#pragma once
#include <cstdint>

#include "model/view.hpp"

namespace ashlar {

/// The thermal lane: one temperature per mesh node. What a kernel sees of it.
template <class Real>
struct HeatView {
  NodeSetView nodes;
  const Real* x = nullptr;                 ///< [3 * entries] m, from the origin of the entry's patch
  Summed<Real> temperature;                ///< [nodes] degC
  const Real* heat = nullptr;              ///< [nodes] W into the body: flux, and film times ambient
  const Real* inverse_capacity = nullptr;  ///< [nodes] K/J
  const std::uint8_t* held = nullptr;      ///< [nodes] 1: temperature is given
  const Real* given_temperature = nullptr;  ///< [nodes] degC that held nodes take next; null: they keep theirs
  Real* flow = nullptr;                    ///< [nodes] W leaving the node by conduction and film
  Real* corner = nullptr;                  ///< [2 * slots] values at element corners
  Real* partial = nullptr;                 ///< [2 * entries] sums of one patch, for nodes on patch boundaries
  Real* bound = nullptr;                   ///< [2 * nodes] W/K: diagonal and absolute row sum of conduction and film

  /// Conjugate gradients of steady stages.
  Real* residual = nullptr;   ///< [nodes] W
  Real* direction = nullptr;  ///< [nodes] K

  /// Film: the boundary matrix in rows. Node film_node[i] has entries film_first[i] .. film_first[i+1]-1, columns
  /// ascending.
  int film_node_count = 0;
  const int* film_node = nullptr;
  const int* film_first = nullptr;
  const int* film_column = nullptr;
  const Real* film_value = nullptr;  ///< W/K
  Real* film_flow = nullptr;         ///< [nodes] W leaving through film; null: there is none
};

}  // namespace ashlar
