#pragma once
#include <algorithm>
#include <cstdint>
#include <vector>

#include "model/blocks.hpp"
#include "model/mesh.hpp"

/// The model in the order that machines work in: batches of one shape and material, elements along a Hilbert curve, cut
/// into patches, in which they keep the order of the mesh. The summation order of every nodal sum (element by element in
/// a patch, then patch by patch) is fixed here, for every machine (numerics 1 and 8).
namespace ashlar {

/// Elements of one shape and one material; consecutive in the new element order.
struct Batch {
  Shape shape = Shape::hex8;
  int material = 0;  ///< index into Model::materials
  int first_element = 0, element_count = 0;
  int first_slot = 0;   ///< corner slot of its first element; element i, corner k has slot first_slot + i * corners + k
  int first_gauss = 0;  ///< see gauss()
  int first_patch = 0, patch_count = 0;
  int patch_size = 1;   ///< elements a patch holds at most
  /// Number of Gauss point g of the batch's element i: points side by side over elements, so that neighbours in memory
  /// belong to neighbouring elements.
  int gauss(int i, int g) const { return first_gauss + g * element_count + i; }
};

/// One set of nodes over the elements: block nodes for displacement, mesh nodes for temperature. Node numbers are new
/// ones: nodes interior to one patch come first, patch by patch; nodes on patch boundaries follow.
struct Topology {
  int node_count = 0;
  int interior_count = 0;
  std::vector<int> corner_node;             ///< [slots] node at each element corner
  std::vector<std::uint16_t> corner_entry;  ///< [slots] the same node as an entry of the element's patch
  std::vector<int> patch_first_entry;       ///< [patches + 1] entries: a patch's own list of nodes, interior ones first
  std::vector<int> patch_interior;          ///< [patches] how many of them are interior
  std::vector<int> entry_node;              ///< [entries]
  std::vector<int> entry_first_slot;        ///< [entries + 1] into entry_slot
  std::vector<int> entry_slot;              ///< [slots] corner slots of an entry, element by element
  std::vector<int> boundary_first;          ///< [boundary nodes + 1] into boundary_entry
  std::vector<int> boundary_entry;          ///< entries that share a boundary node, patch by patch
  std::vector<int> new_node;                ///< [source nodes] new number of each source node
  int boundary_count() const { return node_count - interior_count; }
  int entry_count() const { return static_cast<int>(entry_node.size()); }
};

struct Discretisation {
  std::vector<Batch> batches;
  int element_count = 0, slot_count = 0, gauss_count = 0;
  std::vector<int> patch_first_element;    ///< [patches + 1], new element order
  std::vector<int> patch_batch;            ///< [patches]
  std::vector<int> source_element;         ///< [elements] mesh element at each new position
  std::vector<int> new_element;            ///< [mesh elements] its new position
  Topology blocks;                         ///< source nodes: block nodes (Blocks)
  Topology heat;                           ///< source nodes: mesh nodes (Mesh)
  std::vector<Vec3<double>> block_points;  ///< [block nodes, new numbers] m
  std::vector<Vec3<double>> heat_points;   ///< [mesh nodes, new numbers] m

  int patch_count() const { return static_cast<int>(patch_batch.size()); }
  const Batch& batch_of_patch(int p) const { return batches[patch_batch[p]]; }
};

enum class Precision { double_precision, single_precision };

/// Corner slots a patch holds at most, by precision: what a thread group of a GPU can keep in shared memory. Small models
/// have small patches, enough of them for every processor.
template <class Real>
inline constexpr int most_patch_slots = sizeof(Real) == sizeof(double) ? 3072 : 2048;
inline constexpr int least_patch_slots = 1024;
inline constexpr int patches_wanted = 256;
inline int patch_slots(int slots, Precision precision) {
  const int most = precision == Precision::double_precision ? most_patch_slots<double> : most_patch_slots<float>;
  return std::clamp(slots / patches_wanted / 128 * 128, least_patch_slots, most);
}

/// @param material_of_region [regions] index into Model::materials
/// @param patch_slots see above; at least 8
Discretisation discretise(const Mesh& mesh, const Blocks& blocks, const std::vector<int>& material_of_region,
                          int patch_slots);

/// Points at the entries of a node set, from the first entry of each patch: small numbers, whatever the model's place.
template <class Real>
std::vector<Real> places_in_patches(const Topology& t, const std::vector<Vec3<double>>& points) {
  std::vector<Real> places(3 * t.entry_node.size());
  for (std::size_t p = 0; p + 1 < t.patch_first_entry.size(); ++p)
    for (int e = t.patch_first_entry[p]; e < t.patch_first_entry[p + 1]; ++e)
      for (int c = 0; c < 3; ++c)
        places[3 * std::size_t(e) + c] =
            Real(points[t.entry_node[e]][c] - points[t.entry_node[t.patch_first_entry[p]]][c]);
  return places;
}

}  // namespace ashlar
