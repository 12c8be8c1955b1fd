#include "model/check_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>

#include "model/element_measures.hpp"
#include "model/place_text.hpp"
#include "model/touching.hpp"

namespace ashlar {

namespace {

/// One check's complaints: ten with their whole text, the others counted.
class LimitedComplaints {
 public:
  LimitedComplaints(Complaints& all, const std::vector<Where>& declared) : all_(all), declared_(declared) {}
  template <class Text>
  void add(int region, Text text) {
    if (++count_ <= shown) all_.add(where(region), text());
  }
  ~LimitedComplaints() {
    if (count_ > shown) all_.add(where(0), "... and " + std::to_string(count_ - shown) + " more of the same kind");
  }

 private:
  Where where(int region) const {
    return region >= 0 && region < static_cast<int>(declared_.size()) ? declared_[region] : Where{};
  }
  static constexpr int shown = 10;
  Complaints& all_;
  const std::vector<Where>& declared_;
  int count_ = 0;
};

class MeshCheck {
 public:
  MeshCheck(const Mesh& mesh, const std::vector<Where>& declared, const std::set<std::pair<int, int>>& joined)
      : mesh_(mesh), declared_(declared), joined_(joined) {}

  void run() {
    finite_coordinates();
    repeated_nodes();
    complaints_.raise();  // the checks below compute with both
    positive_jacobians();
    nodes_in_elements();
    same_corners();
    complaints_.raise();  // the faces below need elements that are sound one by one
    matching_faces();
    complaints_.raise();
  }

 private:
  std::string name(int e) const {
    return std::string(shape_name(mesh_.shapes[e])) + " element " + std::to_string(mesh_.source_ids[e]) +
           " of region '" + mesh_.region_names[mesh_.regions[e]] + "' at " + place_text(mesh_.centroid(e));
  }

  void finite_coordinates() {
    LimitedComplaints found(complaints_, declared_);
    for (int n = 0; n < mesh_.node_count(); ++n) {
      const auto& p = mesh_.points[n];
      if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
        found.add(
            0, [&] { return "node " + std::to_string(n + 1) + ": coordinates " + place_text(p) + " are not finite"; });
    }
  }

  void repeated_nodes() {
    LimitedComplaints found(complaints_, declared_);
    for (int e = 0; e < mesh_.element_count(); ++e) {
      const auto corners = mesh_.element(e);
      std::vector<int> nodes(corners.begin(), corners.end());
      std::sort(nodes.begin(), nodes.end());
      const auto twice = std::adjacent_find(nodes.begin(), nodes.end());
      if (twice != nodes.end())
        found.add(mesh_.regions[e], [&] {
          return name(e) + ": node " + std::to_string(*twice + 1) +
                 " is two of its corners; collapsed elements cannot " + "be computed, use a wedge6 or tet4 there";
        });
    }
  }

  void positive_jacobians() {
    LimitedComplaints found(complaints_, declared_);
    for (int e = 0; e < mesh_.element_count(); ++e) {
      const auto measures = measure_element(mesh_, e);
      const bool sound = measures.smallest_gauss_jacobian > 0 && measures.smallest_corner > 1e-9;
      if (sound) continue;
      found.add(mesh_.regions[e], [&] {
        if (std::abs(measures.volume) <= 1e-12 * std::pow(measures.longest_edge, 3)) return name(e) + ": has no volume";
        if (measures.volume < 0)
          return name(e) + ": is inside out (volume " + number_text(measures.volume) +
                 " m^3): its corners must follow the VTK order, so are its lower and upper face exchanged, or two "
                 "axes?";
        return name(e) + ": is folded (Jacobian not positive at a " +
               (measures.smallest_gauss_jacobian > 0 ? "corner" : "Gauss point") +
               "); move its nodes or mesh the place finer";
      });
    }
  }

  void nodes_in_elements() {
    std::vector<char> used(mesh_.points.size(), 0);
    for (const int n : mesh_.corners) used[n] = 1;
    LimitedComplaints found(complaints_, declared_);
    for (int n = 0; n < mesh_.node_count(); ++n)
      if (!used[n])
        found.add(0, [&] {
          return "node " + std::to_string(n + 1) + " at " + place_text(mesh_.points[n]) + " belongs to no element";
        });
  }

  void same_corners() {
    std::vector<int> order(mesh_.element_count());
    std::iota(order.begin(), order.end(), 0);
    const auto sorted = [&](int e) {
      std::array<int, 8> key;
      key.fill(-1);
      const auto corners = mesh_.element(e);
      std::copy(corners.begin(), corners.end(), key.begin());
      std::sort(key.begin(), key.end());
      return key;
    };
    std::vector<std::array<int, 8>> keys;
    keys.reserve(order.size());
    for (const int e : order) keys.push_back(sorted(e));
    std::sort(order.begin(), order.end(), [&](int a, int b) { return std::tie(keys[a], a) < std::tie(keys[b], b); });
    LimitedComplaints found(complaints_, declared_);
    for (std::size_t i = 1; i < order.size(); ++i)
      if (keys[order[i]] == keys[order[i - 1]])
        found.add(mesh_.regions[order[i]], [&] {
          return name(order[i]) + ": has the same corners as element " +
                 std::to_string(mesh_.source_ids[order[i - 1]]) + " of region '" +
                 mesh_.region_names[mesh_.regions[order[i - 1]]] + "'; an element belongs to one region only";
        });
  }

  void matching_faces() {
    const auto faces = find_faces(mesh_);
    elements_on_one_side(faces);
    quads_on_triangles(faces);
    complaints_.raise();
    touching_without_sharing(faces);
  }

  void elements_on_one_side(const FaceGraph& faces) {
    LimitedComplaints found(complaints_, declared_);
    for (const auto& pair : faces.inner)
      if (dot(mesh_.facet_area(pair.a), mesh_.facet_area(pair.b)) > 0)
        found.add(mesh_.regions[pair.b.element], [&] {
          return name(pair.b.element) + ": lies on the same side of its face as " + name(pair.a.element) +
                 "; elements overlap";
        });
  }

  /// One complaint for each two regions.
  void touching_without_sharing(const FaceGraph& faces) {
    std::set<std::pair<int, int>> known;
    for (const auto& pair : find_touching(mesh_, faces)) {
      const int a = mesh_.regions[pair.a.element], b = mesh_.regions[pair.b.element];
      if (joined_.contains(std::minmax(a, b)) || !known.insert(std::minmax(a, b)).second) continue;
      complaints_.add(a < static_cast<int>(declared_.size()) ? declared_[a] : Where{},
                      name(pair.a.element) + ": touches " + name(pair.b.element) +
                          " without sharing its nodes, so nothing would hold them together; join their "
                          "regions by a joint, or give both meshes the same divisions where they meet");
    }
  }

  /// A free quad and a free triangle on three of its nodes: two element shapes meet that do not fit together.
  void quads_on_triangles(const FaceGraph& faces) {
    std::map<std::pair<int, int>, std::vector<Facet>> quads_by_diagonal;
    for (const auto& f : faces.outer) {
      const auto n = mesh_.facet_nodes(f);
      if (n.size() != 4) continue;
      quads_by_diagonal[std::minmax(n[0], n[2])].push_back(f);
      quads_by_diagonal[std::minmax(n[1], n[3])].push_back(f);
    }
    if (quads_by_diagonal.empty()) return;
    LimitedComplaints found(complaints_, declared_);
    for (const auto& f : faces.outer) {
      const auto n = mesh_.facet_nodes(f);
      if (n.size() != 3) continue;
      for (int i = 0; i < 3; ++i) {
        const auto at = quads_by_diagonal.find(std::minmax(n[i], n[(i + 1) % 3]));
        if (at == quads_by_diagonal.end()) continue;
        for (const auto& quad : at->second) {
          const auto q = mesh_.facet_nodes(quad);
          if (std::find(q.begin(), q.end(), n[(i + 2) % 3]) == q.end()) continue;
          if (joined_.contains(std::minmax(mesh_.regions[f.element], mesh_.regions[quad.element]))) continue;
          found.add(mesh_.regions[f.element], [&] {
            return name(f.element) + ": its triangle lies on a quad of " + name(quad.element) +
                   "; join them by a joint, or give both regions the same elements (hex8 beside wedge6 fits along the "
                   "sides "
                   "of a section only)";
          });
        }
      }
    }
  }

  const Mesh& mesh_;
  const std::vector<Where>& declared_;
  const std::set<std::pair<int, int>>& joined_;
  Complaints complaints_;
};

}  // namespace

void check_mesh(const Mesh& mesh, const std::vector<Where>& declared, const std::set<std::pair<int, int>>& joined) {
  MeshCheck(mesh, declared, joined).run();
}

MeshQuality measure_quality(const Mesh& mesh) {
  MeshQuality quality;
  quality.region_volume.assign(mesh.region_names.size(), 0);
  quality.smallest_edge.value = std::numeric_limits<double>::infinity();
  quality.worst_scaled_jacobian.value = std::numeric_limits<double>::infinity();
  for (int e = 0; e < mesh.element_count(); ++e) {
    const auto measures = measure_element(mesh, e);
    const auto take = [&](WorstElement& worst, double value, bool worse) {
      if (worse) worst = {value, e, mesh.centroid(e)};
    };
    const double aspect = measures.longest_edge / measures.shortest_edge;
    const double scaled = measures.scaled_jacobian(mesh.shapes[e]);
    take(quality.smallest_edge, measures.shortest_edge, measures.shortest_edge < quality.smallest_edge.value);
    take(quality.worst_aspect, aspect, aspect > quality.worst_aspect.value);
    take(quality.worst_scaled_jacobian, scaled, scaled < quality.worst_scaled_jacobian.value);
    quality.volume += measures.volume;
    quality.region_volume[mesh.regions[e]] += measures.volume;
  }
  return quality;
}

double element_volume(const Mesh& mesh, int element) { return measure_element(mesh, element).volume; }

}  // namespace ashlar
