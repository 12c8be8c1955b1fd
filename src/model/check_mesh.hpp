#pragma once
#include <set>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "model/mesh.hpp"

namespace ashlar {

/// Rejects what no element can be computed with (numerics 2): coordinates that are not finite, repeated nodes in an
/// element, non-positive Jacobian at a Gauss point or corner, two elements on the same corners, elements that overlap
/// across a face, nodes in no element, faces that touch but are divided differently.
/// @param declared [regions] the declaration that made each region, for messages
/// @param joined pairs of regions that a joint brings together whether their faces match or not, smaller one first
/// Throws DeckError with every complaint found (ten of a kind, then their count).
void check_mesh(const Mesh& mesh, const std::vector<Where>& declared, const std::set<std::pair<int, int>>& joined = {});

/// One quality number with the element that has it.
struct WorstElement {
  double value = 0;
  int element = -1;
  Vec3<double> place;  ///< its centroid, m
};

/// What `ashlar check` prints of a mesh.
struct MeshQuality {
  WorstElement smallest_edge;          ///< m
  WorstElement worst_aspect;           ///< longest over shortest edge of one element, 1 is best
  WorstElement worst_scaled_jacobian;  ///< ElementMeasures::scaled_jacobian: 1 in an ideal element, 0 in a flat one
  double volume = 0;                   ///< m^3
  std::vector<double> region_volume;   ///< [regions], m^3
};
MeshQuality measure_quality(const Mesh& mesh);

/// m^3, by the quadrature that the element forces use.
double element_volume(const Mesh& mesh, int element);

}  // namespace ashlar
