#include "model/blocks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "model/place_text.hpp"

namespace ashlar {

namespace {

/// Disjoint sets whose representative is their smallest member.
class Sets {
 public:
  explicit Sets(int count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }
  int find(int i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(int a, int b) {
    a = find(a), b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<int> parent_;
};

std::string kind_and_name(const Interface& i) { return (i.crackable ? "crackable '" : "joint '") + i.name + "'"; }

/// Which interface a face between two regions belongs to.
class InterfaceTable {
 public:
  static constexpr int none = -1;

  explicit InterfaceTable(const Model& model)
      : model_(model),
        regions_(static_cast<int>(model.mesh.region_names.size())),
        joint_(regions_ * regions_, none),
        crackable_(regions_, none) {
    Complaints wrong;
    for (int i = 0; i < static_cast<int>(model.interfaces.size()); ++i) {
      const auto& declared = model.interfaces[i];
      std::vector<int> regions;
      for (const auto& name : declared.regions) {
        regions.push_back(model.mesh.find_region(name));
        if (regions.back() < 0)
          wrong.add(declared.where,
                    kind_and_name(declared) + ": no region '" + name + "'; there are: " + region_list());
      }
      if (std::count(regions.begin(), regions.end(), none)) continue;
      if (declared.crackable) {
        for (const int r : regions) claim(crackable_[r], i, "region '" + model.mesh.region_names[r] + "'", wrong);
      } else if (regions.size() == 2 && regions[0] != regions[1]) {
        const int a = std::min(regions[0], regions[1]), b = std::max(regions[0], regions[1]);
        claim(joint_[a * regions_ + b], i,
              "the faces between '" + model.mesh.region_names[a] + "' and '" + model.mesh.region_names[b] + "'", wrong);
      } else {
        wrong.add(declared.where, kind_and_name(declared) + ": 'between' takes two different regions");
      }
    }
    wrong.raise();
  }

  /// Index into Model::interfaces, or none. Throws DeckError where two crackables meet without a joint.
  int of(int region_a, int region_b) const {
    if (region_a == region_b) return crackable_[region_a];
    const int joint = joint_[std::min(region_a, region_b) * regions_ + std::max(region_a, region_b)];
    if (joint != none) return joint;
    const int a = crackable_[region_a], b = crackable_[region_b];
    if (a != none && b != none && a != b) {
      const auto& later = model_.interfaces[std::max(a, b)];
      throw DeckError(later.where, kind_and_name(later) + " meets " + kind_and_name(model_.interfaces[std::min(a, b)]) +
                                       " and nothing says which law holds between them: add joint { between = { '" +
                                       model_.mesh.region_names[region_a] + "', '" +
                                       model_.mesh.region_names[region_b] + "' }, ... }");
    }
    return a != none ? a : b;
  }

 private:
  void claim(int& owner, int interface, const std::string& what, Complaints& wrong) const {
    if (owner != none && owner != interface)
      wrong.add(model_.interfaces[interface].where, kind_and_name(model_.interfaces[interface]) + ": " +
                                                        kind_and_name(model_.interfaces[owner]) + " already takes " +
                                                        what);
    owner = interface;
  }
  std::string region_list() const {
    std::string list;
    for (const auto& name : model_.mesh.region_names) list += (list.empty() ? "" : ", ") + name;
    return list;
  }

  const Model& model_;
  int regions_;
  std::vector<int> joint_;      ///< [smaller region * regions + larger region]
  std::vector<int> crackable_;  ///< [regions]
};

/// Corners of all elements grouped by mesh node: corners first[n] .. first[n+1]-1 of `corner` touch node n, elements
/// ascending.
struct CornersOfNodes {
  std::vector<int> first, corner;
};
CornersOfNodes corners_of_nodes(const Mesh& mesh) {
  CornersOfNodes of;
  of.first.assign(mesh.node_count() + 1, 0);
  for (const int n : mesh.corners) ++of.first[n + 1];
  std::partial_sum(of.first.begin(), of.first.end(), of.first.begin());
  of.corner.resize(mesh.corners.size());
  auto next = of.first;
  for (int c = 0; c < static_cast<int>(mesh.corners.size()); ++c) of.corner[next[mesh.corners[c]]++] = c;
  return of;
}

/// Why two regions may share no face: the gap between the boxes around them, or meshes that do not meet.
std::string why_apart(const Mesh& mesh, const std::vector<std::string>& regions) {
  const double none = std::numeric_limits<double>::infinity();
  Vec3<double> low[2], high[2];
  for (int side = 0; side < 2; ++side) {
    low[side] = {none, none, none}, high[side] = {-none, -none, -none};
    const int region = mesh.find_region(regions[side]);
    for (int e = 0; e < mesh.element_count(); ++e)
      for (int node : mesh.element(e))
        for (int i = 0; mesh.regions[e] == region && i < 3; ++i) {
          low[side][i] = std::min(low[side][i], mesh.points[node][i]);
          high[side][i] = std::max(high[side][i], mesh.points[node][i]);
        }
  }
  for (int i = 0; i < 3; ++i)
    if (const double gap = std::max(low[0][i] - high[1][i], low[1][i] - high[0][i]);
        gap > 1e-9 * (high[0][i] - low[0][i]))
      return "a gap of " + number_text(gap) + " m along " + "xyz"[i] + " lies between them; let them touch";
  return "none of their faces look at each other from near";
}

/// Of facets that were found, but beyond the tolerance.
std::string why_too_far(const JointMatch& match) {
  const double distance = std::abs(match.too_far_by);
  return std::string("faces look at each other, the nearest ") +
         (match.too_far_by > 0 ? "across a gap of " : "overlapping by ") + number_text(distance) +
         " m; let them touch, or give tolerance = " + number_text(distance * 1.01) + "*m or more to join them";
}

void refuse_joints_without_faces(const Model& model, const Blocks& blocks) {
  const std::vector<InterfaceFace>& faces = blocks.faces;
  std::vector<int> count(model.interfaces.size(), 0);
  for (const auto& face : faces) ++count[face.interface];
  Complaints wrong;
  for (std::size_t i = 0; i < model.interfaces.size(); ++i) {
    const auto& declared = model.interfaces[i];
    if (count[i] || declared.crackable) continue;
    wrong.add(declared.where, kind_and_name(declared) + ": regions '" + declared.regions[0] + "' and '" +
                                  declared.regions[1] + "' share no face: " +
                                  (blocks.matches[i].too_far ? why_too_far(blocks.matches[i])
                                                             : why_apart(model.mesh, declared.regions)));
  }
  wrong.raise();
}

}  // namespace

NodeCopies copy_nodes(const Mesh& mesh, const std::vector<FacePair>& connecting, const std::vector<char>& parted) {
  Sets sets(static_cast<int>(mesh.corners.size()));
  const auto corner_at = [&](int element, int node) {
    const auto nodes = mesh.element(element);
    return mesh.first_corner[element] + static_cast<int>(std::find(nodes.begin(), nodes.end(), node) - nodes.begin());
  };
  for (const auto& pair : connecting)
    for (const int n : mesh.facet_nodes(pair.a))
      if (parted[n]) sets.join(corner_at(pair.a.element, n), corner_at(pair.b.element, n));

  // A set's representative is its corner in the lowest element.
  const auto around = corners_of_nodes(mesh);
  NodeCopies copies{std::vector<int>(mesh.corners.size(), -1), {}, {0}};
  const auto add = [&](int n) {
    copies.mesh_node.push_back(n);
    return static_cast<int>(copies.mesh_node.size()) - 1;
  };
  for (int n = 0; n < mesh.node_count(); ++n) {
    const int whole = parted[n] ? -1 : add(n);
    for (int i = around.first[n]; i < around.first[n + 1]; ++i) {
      const int corner = around.corner[i], head = parted[n] ? sets.find(corner) : -1;
      copies.corners[corner] = !parted[n] ? whole : head == corner ? add(n) : copies.corners[head];
    }
    copies.first_copy.push_back(static_cast<int>(copies.mesh_node.size()));
  }
  return copies;
}

Blocks split_blocks(const Model& model, const FaceGraph& graph) {
  const Mesh& mesh = model.mesh;
  const InterfaceTable table(model);
  Blocks blocks;

  std::vector<char> touches_interface(mesh.node_count(), 0);
  std::vector<FacePair> inside;
  for (const auto& pair : graph.inner) {
    const int interface = table.of(mesh.regions[pair.a.element], mesh.regions[pair.b.element]);
    if (interface == InterfaceTable::none) {
      inside.push_back(pair);
    } else {
      blocks.faces.push_back({pair.a, pair.b, interface});
      for (const int n : mesh.facet_nodes(pair.a)) touches_interface[n] = 1;
    }
  }
  Facing facing = find_facing(model, graph);
  for (const bool identical : {true, false})
    for (FacingFaces& pair : facing.faces) {
      if (pair.identical != identical) continue;
      blocks.faces.push_back({pair.a, pair.b, pair.interface});
      if (!identical) blocks.overlaps.push_back(std::move(pair.overlap));
      for (const Facet& side : {pair.a, pair.b})
        for (const int n : mesh.facet_nodes(side)) touches_interface[n] = 1;
    }
  std::stable_sort(blocks.faces.begin(), blocks.faces.begin() + blocks.coincident_count(),
                   [](const InterfaceFace& p, const InterfaceFace& q) { return before(p.a, q.a); });
  blocks.matches = std::move(facing.matches);
  if (!has_large_displacement(model)) refuse_joints_without_faces(model, blocks);  // else they may meet later

  NodeCopies copies = copy_nodes(mesh, inside, touches_interface);
  blocks.corners = std::move(copies.corners);
  blocks.mesh_node = std::move(copies.mesh_node);
  blocks.first_copy = std::move(copies.first_copy);

  Sets elements(mesh.element_count());
  std::vector<int> owner(blocks.node_count(), -1);
  for (int e = 0; e < mesh.element_count(); ++e)
    for (int c = mesh.first_corner[e]; c < mesh.first_corner[e + 1]; ++c) {
      int& first = owner[blocks.corners[c]];
      if (first < 0) first = e;
      elements.join(first, e);
    }
  blocks.block_of_element.resize(mesh.element_count());
  for (int e = 0; e < mesh.element_count(); ++e)
    blocks.block_of_element[e] =
        elements.find(e) == e ? blocks.block_count++ : blocks.block_of_element[elements.find(e)];
  return blocks;
}

}  // namespace ashlar
