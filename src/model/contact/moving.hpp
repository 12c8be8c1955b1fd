#pragma once
#include <optional>
#include <vector>

#include "model/blocks.hpp"
#include "model/discretisation.hpp"

/// Contacts of blocks that move far: which faces may touch, and the search for those that are near (numerics 5, large
/// movement).
namespace ashlar {

/// Friction between two regions.
struct ContactLaw {
  double normal_stiffness = 0, shear_stiffness = 0;  ///< Pa/m
  double friction = 0;                               ///< tangent of its angle
};

/// Faces of all blocks that may touch another one, cut into triangles, and probes on their corners: a node with those
/// of its faces that look one way. Nodes in the machine's numbering. Empty in models without large displacement.
struct ContactSurface {
  std::vector<int> corner;                                 ///< [3 * triangles] counter-clockwise from outside
  std::vector<int> block, region;                          ///< [triangles]
  std::vector<int> probe_node, probe_block, probe_region;  ///< [probes]
  std::vector<int> first_facet{0};                         ///< [probes + 1] into facet, area
  std::vector<int> facet;                                  ///< [..] one triangle of a face around the probe
  std::vector<double> area;      ///< [..] m^2, integral of the node's shape function over that face
  std::vector<ContactLaw> laws;  ///< [interfaces]
  int regions = 0;
  std::vector<int> interface;  ///< [regions * regions] index into laws; -1: they never touch
  double skin = 0;               ///< m, how far beside it a search looks
  int triangle_count() const { return static_cast<int>(block.size()); }
  int probe_count() const { return static_cast<int>(probe_node.size()); }
  bool empty() const { return probe_node.empty(); }
};

/// Which interface bodies of two regions touch by: [regions * regions] index into Model::interfaces; -1: none, they pass
/// through each other.
std::vector<int> interface_of_regions(const Model& model);

/// Blocks of one region touch as their crackable says, or else the first joint that names it; blocks of two regions as
/// the joint or crackable between them. `model` has only frictional interfaces whose stiffness is given.
ContactSurface contact_surface(const Model& model, const Blocks& blocks, const Discretisation& discretisation);

/// What probes may touch until something has moved by half the skin.
struct ContactCandidates {
  std::vector<int> first{0};  ///< [probes + 1]
  std::vector<int> triangle;  ///< ascending for each probe
  std::vector<int> law;       ///< index into ContactSurface::laws
  std::vector<double> area;   ///< m^2, that of the probe's faces seen along the triangle's normal
};

/// @param places [block nodes, the machine's numbering] m, where they are now
ContactCandidates find_candidates(const ContactSurface& surface, const std::vector<Vec3<double>>& places);

/// Stiffness, N/m, that contacts may give each block node at most, by all of its faces: the node's own and, twice,
/// that of what presses on it.
std::vector<double> contact_stiffness(const ContactSurface& surface, int node_count);

}  // namespace ashlar
