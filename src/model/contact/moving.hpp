#pragma once
#include <array>
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

/// Faces of all blocks that may touch another one, in triangles, probes on their corners (a node with those of its
/// faces that look one way), sharp edges. Nodes in the machine's numbering. Empty in models without large displacement.
struct ContactSurface {
  std::vector<int> corner;                                 ///< [3 * triangles] counter-clockwise from outside
  std::vector<int> block, region;                          ///< [triangles]
  std::vector<double> face_area;                           ///< [triangles] m^2, of the whole face
  std::vector<int> probe_node, probe_block, probe_region;  ///< [probes]
  std::vector<int> first_facet{0};                         ///< [probes + 1] into facet, area
  std::vector<int> facet;                                  ///< [..] one triangle of a face around the probe
  std::vector<double> area;       ///< [..] m^2, integral of the node's shape function over that face
  std::vector<int> first_rim{0};  ///< [probes + 1] into rim
  std::vector<int> rim;           ///< [..] nodes at the other ends of those edges of the faces that meet at the node
  std::vector<double> may_dip;    ///< [probes] sine by which a rim may dip into what the node presses on
  std::vector<char> sharp;        ///< [probes] whether the node has faces that look another way, too
  std::vector<ContactLaw> laws;   ///< [interfaces]
  int regions = 0;
  std::vector<int> interface;  ///< [regions * regions] index into laws; -1: they never touch
  double skin = 0;             ///< m, how far beside it a search looks
  /// Sharp edges: two nodes, then for each of the two faces a further node of it and a triangle of it.
  std::vector<int> edge, edge_facet;         ///< [4 * edges], [2 * edges]
  std::vector<int> edge_ends;                ///< [2 * edges] 1: the long edge that it is a piece of ends there, too
  std::vector<int> long_edge;                ///< [edges] number of that long, nearly straight edge
  std::vector<int> edge_block, edge_region;  ///< [edges]
  std::vector<double> edge_area;             ///< [2 * edges] m^2, what the edge presses with of each face
  int edge_count() const { return static_cast<int>(edge_block.size()); }
  int triangle_count() const { return static_cast<int>(block.size()); }
  int probe_count() const { return static_cast<int>(probe_node.size()); }
  bool empty() const { return probe_node.empty(); }
};

/// Which interface bodies of two regions touch by: [regions * regions] index into Model::interfaces; -1: none, they
/// pass through each other.
std::vector<int> interface_of_regions(const Model& model);

/// Blocks of one region touch as their crackable says, or else the first joint that names it; blocks of two regions as
/// the joint or crackable between them. `model` has only frictional interfaces whose stiffness is given.
ContactSurface contact_surface(const Model& model, const Blocks& blocks, const Discretisation& discretisation);

/// What probes on corners may touch until something has moved by half the skin, then all pairs of long edges that may.
struct ContactCandidates {
  std::vector<std::array<int, 2>> pairs;  ///< long edges, the smaller number first; ascending
  std::vector<int> first{0};              ///< [probes + pairs + 1]
  std::vector<int> own;                   ///< node of a probe, edge of a pair's first long edge
  std::vector<int> target;                ///< triangle of a probe, edge of a pair's second one; ascending for each
  std::vector<int> law;                   ///< index into ContactSurface::laws
  std::vector<double> area;               ///< m^2 that press with the interface's stiffness
};

/// Both sides look for each other. Where faces lie flat on each other those with the smaller faces press with more, up
/// to all of the stiffness at half the size; nodes at edges and corners with half at least.
/// @param places [block nodes, the machine's numbering] m, where they are now
ContactCandidates find_candidates(const ContactSurface& surface, const std::vector<Vec3<double>>& places);

/// Stiffness, N/m, that contacts may give each block node at most, by all of its faces: the node's own and, twice,
/// that of what presses on it; edges likewise.
std::vector<double> contact_stiffness(const ContactSurface& surface, int node_count);

}  // namespace ashlar
