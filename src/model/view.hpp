#pragma once
#include <cstdint>

#include "model/summed.hpp"

/// All that kernels see: trivially copyable pointers and counts. Owned by a backend.
namespace ashlar {

/// Nodes, patches and sums of one node set (see Topology).
struct NodeSetView {
  int node_count = 0, interior_count = 0, entry_count = 0;
  const std::uint16_t* corner_entry = nullptr;  ///< [slots]
  const int* patch_first_entry = nullptr;       ///< [patches + 1]
  const int* patch_interior = nullptr;          ///< [patches]
  const int* entry_node = nullptr;              ///< [entries]
  const int* entry_first_slot = nullptr;        ///< [entries + 1]
  const int* entry_slot = nullptr;              ///< [slots]
  const int* boundary_first = nullptr;          ///< [boundary nodes + 1]
  const int* boundary_entry = nullptr;
};

/// Nodes that move together: copies of one mesh node that bonded springs tie. Without springs every node is by itself.
/// Relaxation gives a group two masses, one for its mean motion, which bonded springs do not feel, and one for motion
/// against each other, which they do: M^-1 = diag(1/m) + pull * (ones ones^T) on each group (see
/// solve/virtual_mass.hpp).
template <class Real>
struct GroupView {
  int group_count = 0;
  const int* first = nullptr;    ///< [groups + 1] into member; null: group g is node g
  const int* member = nullptr;   ///< [nodes]
  const Real* pull = nullptr;    ///< [groups] 1/kg
  const int* of_node = nullptr;  ///< [nodes] group of each node
  Real* shared = nullptr;        ///< [3 * groups] acceleration of the mean motion in this step
  ASHLAR_HD int begin(int g) const { return first ? first[g] : g; }
  ASHLAR_HD int end(int g) const { return first ? first[g + 1] : g + 1; }
  ASHLAR_HD int node(int j) const { return member ? member[j] : j; }
  ASHLAR_HD bool single(int g) const { return end(g) - begin(g) == 1; }
};

/// A contiguous run of elements of one batch: what an element kernel loops over.
struct BatchView {
  int first_patch = 0, patch_size = 1;  ///< elements a patch
  int element_count = 0;
  int first_slot = 0, first_gauss = 0;
  int first_history = 0;  ///< of the Gauss points that remember, its first
  int corners = 0;        ///< of an element
  /// First of its patch's entries, for the batch's element i.
  ASHLAR_HD int first_entry(const NodeSetView& nodes, int i) const {
    return nodes.patch_first_entry[first_patch + i / patch_size];
  }
  /// Corner slot and Gauss point of the batch's element i.
  ASHLAR_HD int slot(int i, int corners, int k) const { return first_slot + i * corners + k; }
  ASHLAR_HD int gauss(int i, int g) const { return first_gauss + g * element_count + i; }
  ASHLAR_HD int history(int i, int g) const { return first_history + g * element_count + i; }
};

/// The mechanical lane. Vectors are packed x y z per node.
template <class Real>
struct BodyView {
  NodeSetView nodes;
  const Real* x = nullptr;              ///< [3 * entries] m, from the origin of the entry's patch
  Summed<Real> u;                       ///< [3 * nodes] displacement, m
  Real* v = nullptr;                    ///< [3 * nodes] velocity (static stages: displacement of one step, m)
  const Real* load = nullptr;           ///< [3 * nodes] external force, N
  Real* force = nullptr;                ///< [3 * nodes] internal and contact force, N: at rest load = force
  Real* kept_force = nullptr;           ///< [3 * nodes] force of an earlier step
  const Real* inverse_mass = nullptr;   ///< [nodes] 1/kg (static stages: virtual mass, N/m for a unit step)
  const std::uint8_t* fixed = nullptr;  ///< [nodes] bits 0 1 2: x y z held
  Real* corner_force = nullptr;         ///< [3 * slots] per element corner, N
  Real* partial = nullptr;              ///< [3 * entries] sums of one patch, for nodes on patch boundaries
  const Real* warming = nullptr;        ///< [Gauss points] T - T_reference, K
  Real* stress = nullptr;               ///< [6 * Gauss points] Pa, xx yy zz xy yz zx
  Real* history = nullptr;              ///< [numbers a point remembers][Gauss points that remember]
  int history_stride = 0;               ///< Gauss points that remember
  std::uint8_t* remembers = nullptr;    ///< [Gauss points that remember] at an element's first: 1: some number of it
                                        ///< is not 0, else nobody reads them; 2: its law lately took more than elastic
  Real* corner_gradient = nullptr;      ///< [3 * slots] 1/m, mean over the element; null: no law asks for it
  Real* averaged = nullptr;  ///< [Gauss points] dilatation or mean stress of averaged elements; null: there are none
};

}  // namespace ashlar
