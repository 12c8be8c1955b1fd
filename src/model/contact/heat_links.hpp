#pragma once
#include <vector>

#include "model/blocks.hpp"

namespace ashlar {

/// A contact point through which heat passes: conductance * (sum of weight times temperature) leaves node i weight[i]
/// times.
struct HeatLink {
  std::vector<int> nodes;       ///< of the mesh
  std::vector<double> weights;  ///< they sum to zero
  double conductance = 0;       ///< W/K
};

/// Of contact points whose sides have no mesh node in common; what shares its nodes conducts as one body. By the joint's
/// conductance, or so well that half an element beside it resists ten times more. Of a joint that resists heat, open
/// shares pass by its open_conductance.
/// @param open [contact points] open share of each; empty: whatever passes more
std::vector<HeatLink> heat_links(const Model& model, const Blocks& blocks, const ContactPoints& contacts,
                                 const std::vector<double>& open);

}  // namespace ashlar
