#include "model/check_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>

#include "model/place_text.hpp"
#include "model/touching.hpp"
#include "physics/gauss_table.hpp"

namespace ashlar {

namespace {

/// The three neighbours of each corner, in right-hand order: their edges span the corner's Jacobian.
constexpr int hex_neighbours[8][3] = {{1, 3, 4}, {2, 0, 5}, {3, 1, 6}, {0, 2, 7},
                                      {7, 5, 0}, {4, 6, 1}, {5, 7, 2}, {6, 4, 3}};
constexpr int wedge_neighbours[6][3] = {{1, 2, 3}, {2, 0, 4}, {0, 1, 5}, {5, 4, 0}, {3, 5, 1}, {4, 3, 2}};
constexpr int tet_neighbours[4][3] = {{1, 2, 3}, {2, 0, 3}, {0, 1, 3}, {0, 2, 1}};

const int* corner_neighbours(Shape shape, int corner) {
  switch (shape) {
    case Shape::hex8: return hex_neighbours[corner];
    case Shape::wedge6: return wedge_neighbours[corner];
    case Shape::tet4: break;
  }
  return tet_neighbours[corner];
}

/// Corner Jacobian over edge lengths of the ideal shape: its reciprocal scales the quality to 1.
double ideal_corner(Shape shape) {
  return shape == Shape::hex8 ? 1.0 : shape == Shape::wedge6 ? std::sqrt(3.0) / 2 : std::sqrt(0.5);
}

template <class Element>
ElementGeometry<Element, double> geometry_of(const Mesh& mesh, int e) {
  double points[3][Element::corners];
  const auto corners = mesh.element(e);
  for (int k = 0; k < Element::corners; ++k)
    for (int a = 0; a < 3; ++a) points[a][k] = mesh.points[corners[k]][a];
  return ElementGeometry<Element, double>(points);
}

struct Jacobians {
  double smallest = std::numeric_limits<double>::infinity();  ///< over Gauss points, in the scale of `factor`
  double volume = 0;                                          ///< m^3
};

template <class Element>
Jacobians gauss_jacobians(const Mesh& mesh, int e) {
  const auto geometry = geometry_of<Element>(mesh, e);
  Jacobians found;
  for (int g = 0; g < Element::gauss_points; ++g) {
    const double det = geometry.jacobian_at(g).det;
    found.smallest = std::min(found.smallest, det);
    found.volume += GaussTable<Element>::factor * det;
  }
  return found;
}

Jacobians gauss_jacobians(const Mesh& mesh, int e) {
  switch (mesh.shapes[e]) {
    case Shape::hex8: return gauss_jacobians<Hex8<double>>(mesh, e);
    case Shape::wedge6: return gauss_jacobians<Wedge6<double>>(mesh, e);
    case Shape::tet4: break;
  }
  return gauss_jacobians<Tet4<double>>(mesh, e);
}

/// Smallest corner Jacobian over the lengths of its edges: -1 .. 1, before scaling by the ideal shape.
double smallest_corner(const Mesh& mesh, int e) {
  const auto nodes = mesh.element(e);
  double smallest = 1;
  for (int c = 0; c < static_cast<int>(nodes.size()); ++c) {
    const int* n = corner_neighbours(mesh.shapes[e], c);
    const auto& p = mesh.points[nodes[c]];
    const auto a = mesh.points[nodes[n[0]]] - p, b = mesh.points[nodes[n[1]]] - p, d = mesh.points[nodes[n[2]]] - p;
    smallest = std::min(smallest, dot(a, cross(b, d)) / (norm(a) * norm(b) * norm(d)));
  }
  return smallest;
}

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
  MeshCheck(const Mesh& mesh, const std::vector<Where>& declared) : mesh_(mesh), declared_(declared) {}

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
      const auto jacobians = gauss_jacobians(mesh_, e);
      const double corner = smallest_corner(mesh_, e);
      // Written so that a quotient 0/0 of a collapsed edge counts as wrong.
      const bool sound = jacobians.smallest > 0 && corner > 1e-9;
      if (sound) continue;
      found.add(mesh_.regions[e], [&] {
        if (!(std::abs(jacobians.volume) > 1e-12 * std::pow(longest_edge(e), 3))) return name(e) + ": has no volume";
        if (jacobians.volume < 0)
          return name(e) + ": is inside out (volume " + number_text(jacobians.volume) +
                 " m^3); its corners must follow the VTK order";
        return name(e) + ": is folded (Jacobian not positive at a " +
               (jacobians.smallest > 0 ? "corner" : "Gauss point") + "); move its nodes or mesh the place finer";
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
      if (!known.insert(std::minmax(a, b)).second) continue;
      complaints_.add(a < static_cast<int>(declared_.size()) ? declared_[a] : Where{},
                      name(pair.a.element) + ": touches " + name(pair.b.element) +
                          " without sharing its nodes, so nothing would hold them together; give both meshes the same "
                          "divisions where they meet");
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
          found.add(mesh_.regions[f.element], [&] {
            return name(f.element) + ": its triangle lies on a quad of " + name(quad.element) +
                   "; give both regions the same elements (hex8 beside wedge6 fits along the sides of a section only)";
          });
        }
      }
    }
  }

  double longest_edge(int e) const {
    double longest = 0;
    const auto corners = mesh_.element(e);
    for (int c = 0; c < static_cast<int>(corners.size()); ++c)
      for (int i = 0; i < 3; ++i)
        longest = std::max(
            longest, norm(mesh_.points[corners[corner_neighbours(mesh_.shapes[e], c)[i]]] - mesh_.points[corners[c]]));
    return longest;
  }

  const Mesh& mesh_;
  const std::vector<Where>& declared_;
  Complaints complaints_;
};

}  // namespace

void check_mesh(const Mesh& mesh, const std::vector<Where>& declared) { MeshCheck(mesh, declared).run(); }

double element_volume(const Mesh& mesh, int element) { return gauss_jacobians(mesh, element).volume; }

MeshQuality measure_quality(const Mesh& mesh) {
  MeshQuality quality;
  quality.region_volume.assign(mesh.region_names.size(), 0);
  quality.smallest_edge.value = std::numeric_limits<double>::infinity();
  quality.worst_scaled_jacobian.value = std::numeric_limits<double>::infinity();
  for (int e = 0; e < mesh.element_count(); ++e) {
    const auto nodes = mesh.element(e);
    double shortest = std::numeric_limits<double>::infinity(), longest = 0;
    for (int c = 0; c < static_cast<int>(nodes.size()); ++c)
      for (int i = 0; i < 3; ++i) {
        const int other = corner_neighbours(mesh.shapes[e], c)[i];
        if (other < c) continue;
        const double length = norm(mesh.points[nodes[other]] - mesh.points[nodes[c]]);
        shortest = std::min(shortest, length);
        longest = std::max(longest, length);
      }
    const auto take = [&](WorstElement& worst, double value, bool worse) {
      if (worse) worst = {value, e, mesh.centroid(e)};
    };
    take(quality.smallest_edge, shortest, shortest < quality.smallest_edge.value);
    take(quality.worst_aspect, longest / shortest, longest / shortest > quality.worst_aspect.value);
    const double scaled = smallest_corner(mesh, e) / ideal_corner(mesh.shapes[e]);
    take(quality.worst_scaled_jacobian, scaled, scaled < quality.worst_scaled_jacobian.value);
    const double volume = element_volume(mesh, e);
    quality.volume += volume;
    quality.region_volume[mesh.regions[e]] += volume;
  }
  return quality;
}

}  // namespace ashlar
