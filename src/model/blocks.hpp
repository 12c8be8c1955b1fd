#pragma once
#include <string>
#include <vector>

#include "model/contact/facing.hpp"
#include "model/mesh.hpp"
#include "model/model.hpp"

/// Blocks: sets of elements that share nodes. Interfaces between blocks duplicate mesh nodes into block nodes (numerics 1).
namespace ashlar {

/// Two faces of different blocks that lie on each other. Coincident ones are joined by springs at their corner node
/// pairs, others by springs at points of the part that they share.
struct InterfaceFace {
  Facet a, b;            ///< a.element < b.element; the normal points from a to b
  int interface = -1;    ///< index into Model::interfaces
};

/// Copies of mesh nodes, consecutive in mesh-node order, then by lowest element.
struct NodeCopies {
  std::vector<int> corners;     ///< parallel to Mesh::corners: the copy at every element corner
  std::vector<int> mesh_node;   ///< [copies]
  std::vector<int> first_copy;  ///< [mesh nodes + 1]
};
/// Corners of a parted node are one copy where connecting faces join their elements around it. @param parted [nodes]
NodeCopies copy_nodes(const Mesh& mesh, const std::vector<FacePair>& connecting, const std::vector<char>& parted);

/// The mesh after splitting. Elements keep the mesh's order. Without interfaces block nodes are the mesh nodes.
struct Blocks {
  std::vector<int> corners;          ///< parallel to Mesh::corners: block node of every element corner
  std::vector<int> mesh_node;        ///< [block nodes] the mesh node each one copies; copies of one node are consecutive in mesh-node order
  std::vector<int> first_copy;       ///< [mesh nodes + 1]: block nodes first_copy[n] .. first_copy[n+1]-1 copy mesh node n
  std::vector<int> block_of_element; ///< [elements], 0-based, numbered by first element
  int block_count = 0;
  std::vector<InterfaceFace> faces;  ///< coincident ones sorted by (a.element, a.face), then those that overlap
  std::vector<Overlap> overlaps;     ///< of the last faces
  std::vector<JointMatch> matches;   ///< [interfaces] how faces meshed apart found each other

  int node_count() const { return static_cast<int>(mesh_node.size()); }
  int coincident_count() const { return static_cast<int>(faces.size() - overlaps.size()); }
};

/// `joint` overrides `crackable` where both apply. A face between two different crackables, or between a crackable region
/// and a plain one, uses: the joint between their regions if there is one; else the one crackable that applies; two different crackables
/// without a joint are an error that names both. Throws DeckError: a joint between regions that share no face.
Blocks split_blocks(const Model& model, const FaceGraph& faces);

/// Springs; structure of arrays, normal from block a to block b. First one contact point per corner node pair of every
/// coincident face, then those of overlaps: three to every triangle that an overlap is cut into, each between several
/// nodes of both facets.
struct ContactPoints {
  std::vector<int> node_a, node_b;   ///< [pairs] block nodes (before renumbering)
  std::vector<int> first_end{0};     ///< [overlap points + 1] into end_node
  std::vector<int> end_node;         ///< block nodes of a point, side a first
  std::vector<double> end_weight;    ///< gap = sum of weight times displacement: shape functions, side a negative
  std::vector<Vec3<double>> corner;  ///< [overlap points] of the triangle, that the point leans to, m
  std::vector<int> face;                         ///< index into Blocks::faces
  std::vector<int> interface;                    ///< index into Model::interfaces
  std::vector<Vec3<double>> normal;              ///< unit, from a to b: mean normal of face a
  std::vector<double> area;                      ///< m^2, integral of N_i over the face; sums to the face area
  std::vector<double> normal_stiffness, shear_stiffness;  ///< Pa/m (numerics 5: f E_oed / h, f G / h, weaker side, unless given)
  std::vector<double> strength;  ///< share of the law's strength that scatter gives a face; empty: all of it everywhere
  std::vector<double> opening;   ///< m, gap of an undeformed body, less what grout fills; empty: all are closed
  std::vector<Vec3<double>> initial_traction;    ///< Pa on side a, of the initial stress; empty: none
  int count() const { return static_cast<int>(face.size()); }
  int pair_count() const { return static_cast<int>(node_a.size()); }
  /// Whether c is at the tip of a joint, where both nodes are one.
  bool is_tip(int c) const { return c < pair_count() && node_a[c] == node_b[c]; }
  /// Calls visit(block node, weight) for every node of contact point c, side a (negative weights) first.
  template <class Visit>
  void each_end(int c, Visit visit) const {
    if (c < pair_count()) {
      visit(node_a[c], -1.0);
      visit(node_b[c], 1.0);
      return;
    }
    for (int i = first_end[c - pair_count()]; i < first_end[c - pair_count() + 1]; ++i)
      visit(end_node[i], end_weight[i]);
  }
  /// What the traction of the initial stress stretches a spring by, m, and its gap at the start.
  Vec3<double> initial_gap(int c) const;
  std::vector<double> initial_gaps() const;  ///< [3 * contact points] m; empty: none
  bool has_initial_gap() const { return !initial_traction.empty() || !opening.empty(); }
};
ContactPoints place_contacts(const Model& model, const Blocks& blocks);

}  // namespace ashlar
