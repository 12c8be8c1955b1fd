#include "io/mesh_file.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <map>
#include <numeric>

#include "io/abaqus_file.hpp"
#include "io/gmsh_file.hpp"
#include "io/vtu_file.hpp"

namespace ashlar {

namespace {

/// Insertion sort: faster than std::sort on a handful of node numbers.
template <std::size_t N>
void sort_few(std::array<int, N>& values) {
  for (std::size_t i = 1; i < N; ++i)
    for (std::size_t j = i; j > 0 && values[j] < values[j - 1]; --j) std::swap(values[j], values[j - 1]);
}

/// Every node must belong to a volume element, unless only points and lines of the geometry use it.
void check_nodes(const Scanner& scanner, const MeshContent& content) {
  std::string listed;
  int loose = 0;
  for (std::size_t n = 0; n < content.node_ids.size(); ++n)
    if (!content.used_at_all[n] && ++loose <= 10)
      listed += (loose > 1 ? ", " : "") + std::to_string(content.node_ids[n]);
  if (loose)
    scanner.fail_file((loose == 1 ? "1 node belongs" : std::to_string(loose) + " nodes belong") + " to no element: " +
                      listed + (loose > 10 ? ", ..." : "") + "; remove them or save the elements that use them");
}

std::string label(const MeshContent::Elements& list, int e) {
  return std::string(cell_name(list.cells[e])) + " element " + std::to_string(list.ids[e]);
}

std::string group_name(const MeshContent& content, int dimension, int number) {
  const auto it = content.names.find({dimension, number});
  if (it != content.names.end()) return it->second;
  return (dimension == 3 ? "region_" : "surface_") + std::to_string(number);
}

/// The same element given twice: by number, or by its corners (Gmsh 2.2 repeats an element for every group that it is
/// in).
void check_repeated(const Scanner& scanner, const MeshContent& content) {
  const auto& volumes = content.volumes;
  const int count = static_cast<int>(volumes.ids.size());
  struct Print {
    std::uint64_t corners;
    int element;
  };
  std::vector<Print> prints(count);
  std::array<int, 8> nodes;
  auto sorted_nodes = [&](int e) {
    nodes.fill(-1);
    std::copy(volumes.nodes.begin() + volumes.first_node[e], volumes.nodes.begin() + volumes.first_node[e + 1],
              nodes.begin());
    sort_few(nodes);
    return nodes;
  };
  for (int e = 0; e < count; ++e) {
    std::uint64_t print = 0;
    for (const int n : sorted_nodes(e))
      print = (print ^ static_cast<std::uint64_t>(n + 1)) * 0x9E3779B97F4A7C15u, print ^= print >> 29;
    prints[e] = {print, e};
  }
  std::sort(prints.begin(), prints.end(), [](const Print& a, const Print& b) {
    return a.corners != b.corners ? a.corners < b.corners : a.element < b.element;
  });
  for (int i = 1; i < count; ++i) {
    const int a = prints[i - 1].element, b = prints[i].element;
    if (prints[i].corners != prints[i - 1].corners || sorted_nodes(a) != sorted_nodes(b)) continue;
    const auto& in_a = content.memberships[volumes.membership[a]].groups;
    const auto& in_b = content.memberships[volumes.membership[b]].groups;
    std::string message = label(volumes, b) + " has the same nodes as element " + std::to_string(volumes.ids[a]) +
                          " (" + scanner.place(volumes.positions[a]) + ")";
    if (!in_a.empty() && !in_b.empty() && in_a != in_b)
      message += ": it is in two volume groups, '" + group_name(content, 3, in_a[0]) + "' and '" +
                 group_name(content, 3, in_b[0]) + "'; every element must be in exactly one";
    scanner.fail(volumes.positions[b], message);
  }
  std::vector<int> order(count);
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return volumes.ids[a] < volumes.ids[b]; });
  for (int i = 1; i < count; ++i)
    if (volumes.ids[order[i]] == volumes.ids[order[i - 1]])
      scanner.fail(volumes.positions[order[i]], "element " + std::to_string(volumes.ids[order[i]]) +
                                                    " is given twice, first at " +
                                                    scanner.place(volumes.positions[order[i - 1]]));
}

/// Region of every volume element: its group, or its geometric volume where the file has no volume groups.
void add_elements(const Scanner& scanner, const MeshContent& content, const std::vector<int>& node_of, Mesh& mesh) {
  const auto& volumes = content.volumes;
  const int count = static_cast<int>(volumes.ids.size());
  bool grouped = false;
  for (const int m : volumes.membership) grouped = grouped || !content.memberships[m].groups.empty();
  auto number_of = [&](int m) { return grouped ? content.memberships[m].groups.at(0) : content.memberships[m].entity; };
  std::map<int, int> region_of;
  for (int e = 0; e < count; ++e) {
    const auto& membership = content.memberships[volumes.membership[e]];
    if (grouped && membership.groups.empty())
      scanner.fail(volumes.positions[e],
                   label(volumes, e) + " (volume " + std::to_string(membership.entity) +
                       ") is in no volume group, but the file has volume groups: put it into one");
    if (membership.groups.size() > 1)
      scanner.fail(volumes.positions[e], label(volumes, e) + " is in two volume groups, '" +
                                             group_name(content, 3, membership.groups[0]) + "' and '" +
                                             group_name(content, 3, membership.groups[1]) +
                                             "'; every element must be in exactly one");
    region_of[number_of(volumes.membership[e])] = 0;
  }
  for (auto& [number, region] : region_of) {
    region = static_cast<int>(mesh.region_names.size());
    mesh.region_names.push_back(grouped ? group_name(content, 3, number) : "region_" + std::to_string(number));
  }
  for (std::size_t i = 0; i < mesh.region_names.size(); ++i)
    if (std::count(mesh.region_names.begin(), mesh.region_names.end(), mesh.region_names[i]) > 1)
      scanner.fail_file("two volume groups are called '" + mesh.region_names[i] + "'");

  std::vector<int> region_of_membership(content.memberships.size(), -1);
  for (const int m : volumes.membership)
    if (region_of_membership[m] < 0) region_of_membership[m] = region_of.at(number_of(m));
  mesh.shapes.reserve(count);
  mesh.corners.reserve(volumes.nodes.size());
  std::array<int, 8> nodes;
  for (int e = 0; e < count; ++e) {
    const int first = volumes.first_node[e], corners = volumes.first_node[e + 1] - first;
    for (int i = 0; i < corners; ++i) nodes[i] = node_of[volumes.nodes[first + i]];
    mesh.add_element(shape_of(volumes.cells[e]), std::span(nodes.data(), corners),
                     region_of_membership[volumes.membership[e]], volumes.ids[e]);
  }
}

using FaceKey = std::array<int, 4>;  ///< sorted node numbers; triangles start with -1

FaceKey face_key(std::span<const int> nodes) {
  FaceKey key{-1, -1, -1, -1};
  std::copy(nodes.begin(), nodes.end(), key.begin());
  sort_few(key);
  return key;
}

void sort_facets(std::vector<Facet>& facets) {
  auto less = [](const Facet& a, const Facet& b) {
    return a.element != b.element ? a.element < b.element : a.face < b.face;
  };
  std::sort(facets.begin(), facets.end(), less);
  facets.erase(std::unique(facets.begin(), facets.end()), facets.end());
}

/// Finds the element face of every 2-D element and sorts the facets into their surfaces.
void add_surfaces(const Scanner& scanner, const MeshContent& content, const std::vector<int>& node_of, Mesh& mesh) {
  const auto& facets = content.facets;
  const int count = static_cast<int>(facets.ids.size());
  struct Entry {
    FaceKey key;
    int facet;
  };
  std::vector<Entry> entries(count);
  std::vector<char> on_facet(mesh.points.size(), 0);
  std::array<int, 4> nodes;
  auto fail_loose = [&](int f) {
    scanner.fail(facets.positions[f], label(facets, f) + " is not a face of any volume element");
  };
  for (int f = 0; f < count; ++f) {
    const int first = facets.first_node[f], corners = facets.first_node[f + 1] - first;
    for (int i = 0; i < corners; ++i) {
      nodes[i] = node_of[facets.nodes[first + i]];
      if (nodes[i] < 0) fail_loose(f);
      on_facet[nodes[i]] = 1;
    }
    entries[f] = {face_key(std::span(nodes.data(), corners)), f};
  }
  auto before = [](const Entry& a, const Entry& b) { return a.key != b.key ? a.key < b.key : a.facet < b.facet; };
  std::sort(entries.begin(), entries.end(), before);

  std::vector<Facet> owner(count);
  for (int e = 0; count > 0 && e < mesh.element_count(); ++e) {
    const auto element = mesh.element(e);
    for (int face = 0; face < face_count(mesh.shapes[e]); ++face) {
      const auto local = face_corners(mesh.shapes[e], face);
      bool candidate = true;
      for (std::size_t i = 0; i < local.size(); ++i) {
        nodes[i] = element[local[i]];
        candidate = candidate && on_facet[nodes[i]];
      }
      if (!candidate) continue;
      const FaceKey key = face_key(std::span(nodes.data(), local.size()));
      for (auto it = std::lower_bound(entries.begin(), entries.end(), Entry{key, -1}, before);
           it != entries.end() && it->key == key; ++it)
        if (owner[it->facet].element < 0) owner[it->facet] = {e, face};
    }
  }
  std::map<int, std::vector<Facet>> surfaces;
  for (int f = 0; f < count; ++f) {
    if (owner[f].element < 0) fail_loose(f);
    for (const int group : content.memberships[facets.membership[f]].groups) surfaces[group].push_back(owner[f]);
  }
  for (auto& [number, list] : surfaces) {
    sort_facets(list);
    const std::string name = group_name(content, 2, number);
    if (mesh.find_surface(name)) scanner.fail_file("two surface groups are called '" + name + "'");
    mesh.surfaces.push_back({name, std::move(list)});
  }
}

/// Surfaces given by faces, then those given by nodes: the outer faces with all nodes in the set, or, where there is
/// none, the inner ones. A set without any whole face is no surface; nor is one whose name a surface already has.
void add_sets(const MeshContent& content, const std::vector<int>& node_of, Mesh& mesh) {
  if (content.face_sets.empty() && content.node_sets.empty()) return;
  const FaceGraph faces = find_faces(mesh);
  for (const auto& set : content.face_sets) {
    std::vector<Facet> facets = set.facets;
    std::vector<char> is_free(mesh.element_count(), 0);
    for (const int e : set.free_elements) is_free[e] = 1;
    for (const Facet& facet : faces.outer)
      if (is_free[facet.element]) facets.push_back(facet);
    sort_facets(facets);
    std::erase_if(mesh.surfaces, [&](const Surface& other) { return other.name == set.name; });
    mesh.surfaces.push_back({set.name, std::move(facets)});
  }
  for (const auto& set : content.node_sets) {
    if (mesh.find_surface(set.name)) continue;
    std::vector<char> in_set(mesh.points.size(), 0);
    for (const int n : set.nodes)
      if (node_of[n] >= 0) in_set[node_of[n]] = 1;
    auto is_whole = [&](const Facet& facet) {
      const auto element = mesh.element(facet.element);
      const auto local = face_corners(mesh.shapes[facet.element], facet.face);
      return std::all_of(local.begin(), local.end(), [&](int corner) { return in_set[element[corner]] != 0; });
    };
    std::vector<Facet> facets;
    for (const Facet& facet : faces.outer)
      if (is_whole(facet)) facets.push_back(facet);
    if (facets.empty())
      for (const FacePair& pair : faces.inner)
        if (is_whole(pair.a)) facets.push_back(pair.a);
    sort_facets(facets);
    if (!facets.empty()) mesh.surfaces.push_back({set.name, std::move(facets)});
  }
}

/// By the extension of the file's name.
MeshContent read_content(const std::string& path, Scanner& scanner) {
  std::string extension = std::filesystem::path(path).extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (extension == ".msh") return read_gmsh(scanner);
  if (extension == ".inp") return read_abaqus(scanner);
  if (extension == ".vtu") return read_vtu(scanner);
  scanner.fail_file("the extension '" + extension +
                    "' of a mesh file is not known; valid: .msh (Gmsh), .inp (Abaqus, CalculiX), .vtu (VTK)");
}

}  // namespace

Mesh read_mesh(const std::string& path, const Where& where) {
  Scanner scanner(path, where);
  const MeshContent content = read_content(path, scanner);
  if (content.volumes.ids.empty())
    scanner.fail_file(
        "there are no volume elements; hex8, wedge6 and tet4 are read (is the mesh three-dimensional, and saved with "
        "its volume groups?)");
  check_nodes(scanner, content);
  check_repeated(scanner, content);

  Mesh mesh;
  std::vector<int> node_of(content.points.size(), -1);
  for (std::size_t n = 0; n < content.points.size(); ++n) {
    if (!content.used_by_volume[n]) continue;
    node_of[n] = static_cast<int>(mesh.points.size());
    mesh.points.push_back(content.points[n]);
  }
  add_elements(scanner, content, node_of, mesh);
  add_surfaces(scanner, content, node_of, mesh);
  add_sets(content, node_of, mesh);
  return mesh;
}

}  // namespace ashlar
