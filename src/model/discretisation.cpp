#include "model/discretisation.hpp"

#include <algorithm>
#include <climits>
#include <iterator>

#include "model/hilbert.hpp"

namespace ashlar {

namespace {

/// Patches, entries and node numbers of one node set. `corner` holds source node numbers, slot by slot in new element
/// order.
Topology build_topology(const Discretisation& d, std::vector<int> corner, int source_nodes) {
  Topology t;
  t.node_count = source_nodes;
  const int patches = d.patch_count();
  const auto slots_of_patch = [&](int p) {
    const Batch& b = d.batch_of_patch(p);
    const int corners = corner_count(b.shape);
    const int first = b.first_slot + (d.patch_first_element[p] - b.first_element) * corners;
    return std::pair{first, first + (d.patch_first_element[p + 1] - d.patch_first_element[p]) * corners};
  };

  std::vector<int> first_patch(source_nodes, INT_MAX), last_patch(source_nodes, -1);
  for (int p = 0; p < patches; ++p) {
    const auto [first, last] = slots_of_patch(p);
    for (int s = first; s < last; ++s) {
      first_patch[corner[s]] = std::min(first_patch[corner[s]], p);
      last_patch[corner[s]] = std::max(last_patch[corner[s]], p);
    }
  }

  t.corner_entry.resize(corner.size());
  t.patch_first_entry.assign(1, 0);
  t.new_node.assign(source_nodes, -1);
  std::vector<int> entry_in_patch(source_nodes, -1), entry_source, interior, boundary;
  int next = 0;
  for (int p = 0; p < patches; ++p) {
    const auto [first, last] = slots_of_patch(p);
    interior.clear();
    boundary.clear();
    // First corners of all elements, then second ones: neighbours in a patch find theirs side by side.
    const int corners = corner_count(d.batch_of_patch(p).shape);
    for (int k = 0; k < corners; ++k)
      for (int s = first + k; s < last; s += corners) {
        const int n = corner[s];
        if (entry_in_patch[n] >= 0) continue;
        entry_in_patch[n] = 0;
        (first_patch[n] == last_patch[n] ? interior : boundary).push_back(n);
      }
    for (const int n : interior) t.new_node[n] = next++;
    int entry = 0;
    for (const auto* list : {&interior, &boundary})
      for (const int n : *list) {
        entry_in_patch[n] = entry++;
        entry_source.push_back(n);
      }
    t.patch_interior.push_back(static_cast<int>(interior.size()));
    t.patch_first_entry.push_back(static_cast<int>(entry_source.size()));
    for (int s = first; s < last; ++s) t.corner_entry[s] = static_cast<std::uint16_t>(entry_in_patch[corner[s]]);
    for (const auto* list : {&interior, &boundary})
      for (const int n : *list) entry_in_patch[n] = -1;
  }
  t.interior_count = next;
  for (const int n : entry_source)
    if (t.new_node[n] < 0) t.new_node[n] = next++;

  t.entry_node.resize(entry_source.size());
  for (std::size_t e = 0; e < entry_source.size(); ++e) t.entry_node[e] = t.new_node[entry_source[e]];
  for (auto& n : corner) n = t.new_node[n];
  t.corner_node = std::move(corner);

  t.entry_first_slot.assign(t.entry_node.size() + 1, 0);
  for (int p = 0; p < patches; ++p) {
    const auto [first, last] = slots_of_patch(p);
    for (int s = first; s < last; ++s) ++t.entry_first_slot[t.patch_first_entry[p] + t.corner_entry[s] + 1];
  }
  for (std::size_t e = 0; e < t.entry_node.size(); ++e) t.entry_first_slot[e + 1] += t.entry_first_slot[e];
  t.entry_slot.resize(t.corner_node.size());
  std::vector<int> fill(t.entry_first_slot.begin(), t.entry_first_slot.end() - 1);
  for (int p = 0; p < patches; ++p) {
    const auto [first, last] = slots_of_patch(p);
    for (int s = first; s < last; ++s) t.entry_slot[fill[t.patch_first_entry[p] + t.corner_entry[s]]++] = s;
  }

  t.boundary_first.assign(t.boundary_count() + 1, 0);
  for (const int n : t.entry_node)
    if (n >= t.interior_count) ++t.boundary_first[n - t.interior_count + 1];
  for (int b = 0; b < t.boundary_count(); ++b) t.boundary_first[b + 1] += t.boundary_first[b];
  t.boundary_entry.resize(t.boundary_first.back());
  fill.assign(t.boundary_first.begin(), t.boundary_first.end() - 1);
  for (int e = 0; e < t.entry_count(); ++e)
    if (t.entry_node[e] >= t.interior_count) t.boundary_entry[fill[t.entry_node[e] - t.interior_count]++] = e;
  return t;
}

/// Those elements of the curve that belong, cut into patches; in a patch as the mesh has them, rows side by side.
template <class Belongs>
std::vector<int> elements_in_patches(const std::vector<int>& along_curve, int patch_size, const Belongs& belongs) {
  std::vector<int> elements;
  std::copy_if(along_curve.begin(), along_curve.end(), std::back_inserter(elements), belongs);
  for (auto first = elements.begin(); first != elements.end();) {
    const auto last = first + std::min<std::ptrdiff_t>(patch_size, elements.end() - first);
    std::sort(first, last);
    first = last;
  }
  return elements;
}

}  // namespace

Discretisation discretise(const Mesh& mesh, const Blocks& blocks, const std::vector<int>& material_of_region,
                          int patch_slots) {
  Discretisation d;
  d.element_count = mesh.element_count();
  std::vector<Vec3<double>> centroids(d.element_count);
  for (int e = 0; e < d.element_count; ++e) centroids[e] = mesh.centroid(e);
  const std::vector<int> along_curve = hilbert_order(centroids);

  std::vector<int> block_corner, heat_corner;
  d.new_element.resize(d.element_count);
  d.patch_first_element.assign(1, 0);
  const int materials =
      material_of_region.empty() ? 0 : 1 + *std::max_element(material_of_region.begin(), material_of_region.end());
  for (int material = 0; material < materials; ++material)
    for (const Shape shape : {Shape::hex8, Shape::wedge6, Shape::tet4}) {
      for (; d.slot_count % 8 > 0; ++d.slot_count)  // batches begin at 16-byte borders of Topology::corner_entry
        for (auto* corner : {&block_corner, &heat_corner}) corner->push_back(0);
      Batch b;
      b.shape = shape;
      b.material = material;
      b.first_element = static_cast<int>(d.source_element.size());
      b.first_slot = d.slot_count;
      b.first_gauss = d.gauss_count;
      b.first_patch = d.patch_count();
      b.patch_size = patch_slots / corner_count(shape);
      for (const int e : elements_in_patches(along_curve, b.patch_size, [&](int e) {
             return mesh.shapes[e] == shape && material_of_region[mesh.regions[e]] == material;
           })) {
        d.new_element[e] = static_cast<int>(d.source_element.size());
        d.source_element.push_back(e);
        for (int s = mesh.first_corner[e]; s < mesh.first_corner[e + 1]; ++s) {
          block_corner.push_back(blocks.corners[s]);
          heat_corner.push_back(mesh.corners[s]);
        }
        d.gauss_count += gauss_count(shape);
        ++b.element_count;
      }
      if (b.element_count == 0) continue;
      d.slot_count += b.element_count * corner_count(shape);
      b.patch_count = (b.element_count + b.patch_size - 1) / b.patch_size;
      for (int p = 0; p < b.patch_count; ++p) {
        d.patch_batch.push_back(static_cast<int>(d.batches.size()));
        d.patch_first_element.push_back(b.first_element + std::min(b.element_count, (p + 1) * b.patch_size));
      }
      d.batches.push_back(b);
    }

  d.blocks = build_topology(d, std::move(block_corner), blocks.node_count());
  d.heat = build_topology(d, std::move(heat_corner), mesh.node_count());
  d.block_points.resize(blocks.node_count());
  for (int n = 0; n < blocks.node_count(); ++n) d.block_points[d.blocks.new_node[n]] = mesh.points[blocks.mesh_node[n]];
  d.heat_points.resize(mesh.node_count());
  for (int n = 0; n < mesh.node_count(); ++n) d.heat_points[d.heat.new_node[n]] = mesh.points[n];
  return d;
}

}  // namespace ashlar
