#include "model/mesh.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <tuple>

#include "base/error.hpp"

namespace ashlar {

namespace {

constexpr int hex_faces[6][4] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
constexpr int wedge_triangles[2][3] = {{0, 2, 1}, {3, 4, 5}};
constexpr int wedge_quads[3][4] = {{0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}};
constexpr int tet_faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};

/// A face under the key that both of its owners find: its nodes, sorted, padded with -1.
struct KeyedFace {
  std::array<int, 4> nodes;
  Facet facet;
  bool operator<(const KeyedFace& other) const {
    return std::tie(nodes, facet.element, facet.face) < std::tie(other.nodes, other.facet.element, other.facet.face);
  }
};

KeyedFace keyed(const Mesh& mesh, const Facet& facet) {
  const auto corners = mesh.element(facet.element);
  KeyedFace face{{-1, -1, -1, -1}, facet};
  std::size_t i = 0;
  for (const int c : face_corners(mesh.shapes[facet.element], facet.face)) face.nodes[i++] = corners[c];
  std::sort(face.nodes.begin(), face.nodes.end());
  return face;
}

template <class Work>
void each_facet(const Mesh& mesh, const Work& work) {
  for (int e = 0; e < mesh.element_count(); ++e)
    for (int f = 0; f < face_count(mesh.shapes[e]); ++f) work(Facet{e, f});
}

/// Every facet under the lowest of its nodes: those of node n are first[n] .. first[n + 1].
struct FacetsOfNodes {
  std::vector<std::size_t> first;
  std::vector<Facet> facets;

  explicit FacetsOfNodes(const Mesh& mesh) : first(mesh.points.size() + 1) {
    const auto lowest = [&](const Facet& facet) {
      const auto corners = mesh.element(facet.element);
      int node = std::numeric_limits<int>::max();
      for (const int c : face_corners(mesh.shapes[facet.element], facet.face)) node = std::min(node, corners[c]);
      return node;
    };
    each_facet(mesh, [&](const Facet& facet) { ++first[lowest(facet) + 1]; });
    std::partial_sum(first.begin(), first.end(), first.begin());
    facets.resize(first.back());
    std::vector<std::size_t> next(first.begin(), first.end() - 1);
    each_facet(mesh, [&](const Facet& facet) { facets[next[lowest(facet)]++] = facet; });
  }
};

}  // namespace

std::span<const int> face_corners(Shape shape, int face) {
  switch (shape) {
    case Shape::hex8: return hex_faces[face];
    case Shape::wedge6:
      if (face < 2) return wedge_triangles[face];
      return wedge_quads[face - 2];
    case Shape::tet4: break;
  }
  return tet_faces[face];
}

void Mesh::add_element(Shape shape, std::span<const int> nodes, int region, long source_id) {
  shapes.push_back(shape);
  corners.insert(corners.end(), nodes.begin(), nodes.end());
  first_corner.push_back(static_cast<int>(corners.size()));
  regions.push_back(region);
  source_ids.push_back(source_id);
}

Vec3<double> Mesh::centroid(int e) const {
  const auto nodes = element(e);
  Vec3<double> sum;
  for (const int n : nodes) sum = sum + points[n];
  return (1.0 / static_cast<double>(nodes.size())) * sum;
}

std::vector<int> Mesh::facet_nodes(const Facet& f) const {
  const auto corners_of_element = element(f.element);
  std::vector<int> nodes;
  for (const int c : face_corners(shapes[f.element], f.face)) nodes.push_back(corners_of_element[c]);
  return nodes;
}

Vec3<double> Mesh::facet_centroid(const Facet& f) const {
  const auto corners_of_element = element(f.element);
  const auto local = face_corners(shapes[f.element], f.face);
  Vec3<double> sum;
  for (const int c : local) sum = sum + points[corners_of_element[c]];
  return (1.0 / static_cast<double>(local.size())) * sum;
}

Vec3<double> Mesh::facet_area(const Facet& f) const {
  const auto corners_of_element = element(f.element);
  const auto local = face_corners(shapes[f.element], f.face);
  const auto point = [&](int i) { return points[corners_of_element[local[i]]]; };
  if (local.size() == 3) return 0.5 * cross(point(1) - point(0), point(2) - point(0));
  // The integral of n dA over a bilinear quad is half the product of its diagonals, exactly, warped or not.
  return 0.5 * cross(point(2) - point(0), point(3) - point(1));
}

double Mesh::extent() const {
  if (points.empty()) return 0;
  Vec3<double> low = points[0], high = points[0];
  for (const auto& p : points)
    for (int a = 0; a < 3; ++a) {
      low[a] = std::min(low[a], p[a]);
      high[a] = std::max(high[a], p[a]);
    }
  return norm(high - low);
}

const Surface* Mesh::find_surface(const std::string& name) const {
  for (const auto& surface : surfaces)
    if (surface.name == name) return &surface;
  return nullptr;
}

int Mesh::find_region(const std::string& name) const {
  const auto at = std::find(region_names.begin(), region_names.end(), name);
  return at == region_names.end() ? -1 : static_cast<int>(at - region_names.begin());
}

bool before(const Facet& a, const Facet& b) { return std::tie(a.element, a.face) < std::tie(b.element, b.face); }

FaceGraph find_faces(const Mesh& mesh) {
  constexpr int most_faces = 6;
  std::vector<Facet> across(std::size_t(most_faces) * mesh.element_count(), Facet{-1, -1});
  const auto place = [](const Facet& f) { return std::size_t(most_faces) * f.element + f.face; };
  const FacetsOfNodes of_nodes(mesh);
  std::vector<KeyedFace> faces;
  for (std::size_t n = 0; n + 1 < of_nodes.first.size(); ++n) {
    faces.clear();
    for (std::size_t i = of_nodes.first[n]; i < of_nodes.first[n + 1]; ++i)
      faces.push_back(keyed(mesh, of_nodes.facets[i]));
    std::sort(faces.begin(), faces.end());
    for (std::size_t i = 0; i < faces.size();) {
      std::size_t end = i + 1;
      while (end < faces.size() && faces[end].nodes == faces[i].nodes) ++end;
      if (end - i > 2) {
        std::string elements;
        for (std::size_t k = i; k < end; ++k)
          elements += (elements.empty() ? "" : ", ") + std::to_string(mesh.source_ids[faces[k].facet.element]);
        throw DeckError(Where{}, "one face belongs to more than two elements (" + elements + "): elements overlap");
      }
      if (end - i == 2) {
        across[place(faces[i].facet)] = faces[i + 1].facet;
        across[place(faces[i + 1].facet)] = faces[i].facet;
      }
      i = end;
    }
  }
  FaceGraph graph;
  each_facet(mesh, [&](const Facet& facet) {
    const Facet& other = across[place(facet)];
    if (other.element < 0)
      graph.outer.push_back(facet);
    else if (before(facet, other))
      graph.inner.push_back({facet, other});
  });
  return graph;
}

}  // namespace ashlar
