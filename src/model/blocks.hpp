#pragma once
#include <string>
#include <vector>

#include "model/mesh.hpp"
#include "model/model.hpp"

/// Blocks: sets of elements that share nodes. Interfaces between blocks duplicate mesh nodes into block nodes (numerics 1).
namespace ashlar {

/// Two coincident faces of different blocks, joined by springs at their corner node pairs.
struct InterfaceFace {
  Facet a, b;            ///< a.element < b.element; the normal points from a to b
  int interface = -1;    ///< index into Model::interfaces
};

/// The mesh after splitting. Elements keep the mesh's order. Without interfaces block nodes are the mesh nodes.
struct Blocks {
  std::vector<int> corners;          ///< parallel to Mesh::corners: block node of every element corner
  std::vector<int> mesh_node;        ///< [block nodes] the mesh node each one copies; copies of one node are consecutive in mesh-node order
  std::vector<int> first_copy;       ///< [mesh nodes + 1]: block nodes first_copy[n] .. first_copy[n+1]-1 copy mesh node n
  std::vector<int> block_of_element; ///< [elements], 0-based, numbered by first element
  int block_count = 0;
  std::vector<InterfaceFace> faces;  ///< sorted by (a.element, a.face)

  int node_count() const { return static_cast<int>(mesh_node.size()); }
};

/// `joint` overrides `crackable` where both apply. A face between two different crackables, or between a crackable region
/// and a plain one, uses: the joint between their regions if there is one; else the one crackable that applies; two different crackables
/// without a joint are an error that names both. Throws DeckError: a joint between regions that share no face.
Blocks split_blocks(const Model& model, const FaceGraph& faces);

/// Springs: one contact point per corner node pair of every interface face; structure of arrays. Normal from block a to block b.
struct ContactPoints {
  std::vector<int> node_a, node_b;               ///< block nodes (before renumbering)
  std::vector<int> face;                         ///< index into Blocks::faces
  std::vector<int> interface;                    ///< index into Model::interfaces
  std::vector<Vec3<double>> normal;              ///< unit, from a to b: mean normal of face a
  std::vector<double> area;                      ///< m^2, integral of N_i over the face; sums to the face area
  std::vector<double> normal_stiffness, shear_stiffness;  ///< Pa/m (numerics 5: f E_oed / h, f G / h, weaker side, unless given)
  std::vector<Vec3<double>> initial_traction;    ///< Pa on side a, of the initial stress; empty: none
  int count() const { return static_cast<int>(node_a.size()); }
  /// What the traction of the initial stress stretches a spring by, m; zero without.
  Vec3<double> initial_gap(int c) const;
};
ContactPoints place_contacts(const Model& model, const Blocks& blocks);

}  // namespace ashlar
