#pragma once
#include <vector>

#include "solve/problem.hpp"

/// What the acting conditions of a stage mean for the block nodes, in the order of Blocks.
namespace ashlar {

struct MechanicalConditions {
  std::vector<double> load;          ///< [3 * block nodes] N, all of it, less the internal force of the initial stress
  std::vector<double> surface_load;  ///< [3 * block nodes] N, loads spread over surfaces only
  std::vector<double> fixed;         ///< [block nodes] bits 0 1 2: x y z held
  std::vector<double> crack_water;   ///< [contact points] Pa, of water where they are open
  std::vector<int> prescribed;       ///< components 3 * node + axis whose displacement is given
  std::vector<double> displacement;  ///< m, parallel to prescribed
};

/// Of the given conditions, or of stage `stage` (0-based) at its beginning. A fix or displacement on a surface acts on
/// the nodes of the elements that own its facets. Throws DeckError: a `fix` with normal on a surface that is not
/// perpendicular to an axis.
MechanicalConditions mechanical_conditions(const Problem& problem, const std::vector<ActingCondition>& acting);
MechanicalConditions mechanical_conditions(const Problem& problem, int stage);

}  // namespace ashlar
