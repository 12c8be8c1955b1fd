#pragma once
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/tensor.hpp"
#include "io/scanner.hpp"
#include "model/mesh.hpp"

/// What a mesh file says, the same for all formats; mesh_file.cpp makes a Mesh of it.
namespace ashlar {

/// Elements that are read, with their corners in the order of Shape.
enum class Cell : std::uint8_t { tri3, quad4, tet4, wedge6, hex8 };

constexpr int corner_count(Cell cell) {
  constexpr int counts[] = {3, 4, 4, 6, 8};
  return counts[static_cast<int>(cell)];
}
constexpr const char* cell_name(Cell cell) {
  constexpr const char* names[] = {"tri3", "quad4", "tet4", "wedge6", "hex8"};
  return names[static_cast<int>(cell)];
}
constexpr bool is_volume(Cell cell) { return cell >= Cell::tet4; }
/// Of volume elements only.
constexpr Shape shape_of(Cell cell) {
  return cell == Cell::tet4 ? Shape::tet4 : cell == Cell::wedge6 ? Shape::wedge6 : Shape::hex8;
}

/// What an element belongs to: its geometric entity and the groups of its own dimension.
struct Membership {
  int entity = 0;
  std::vector<int> groups;
};

struct MeshContent {
  std::map<std::pair<int, int>, std::string> names;  ///< of groups, by dimension (3 or 2) and number
  std::vector<long> node_ids;
  std::vector<Vec3<double>> points;
  std::vector<Membership> memberships;
  struct Elements {
    std::vector<Cell> cells;
    std::vector<long> ids;
    std::vector<std::size_t> positions;  ///< in the file
    std::vector<int> membership;
    std::vector<int> first_node{0}, nodes;  ///< node indices in file order
    int count() const { return static_cast<int>(ids.size()); }
    std::span<const int> element(int e) const {
      return std::span(nodes).subspan(first_node[e], first_node[e + 1] - first_node[e]);
    }
  };
  Elements volumes, facets;
  /// Surfaces given by faces of volume elements (which keep their order in the mesh), or by all outer faces of some.
  struct FaceSet {
    std::string name;
    std::vector<Facet> facets;
    std::vector<int> free_elements;
  };
  /// Surfaces given by nodes, as indices.
  struct NodeSet {
    std::string name;
    std::vector<int> nodes;
  };
  std::vector<FaceSet> face_sets;
  std::vector<NodeSet> node_sets;
  std::vector<char> used_by_volume, used_at_all;  ///< [nodes]

  /// Appends an element to the list of its dimension and marks its nodes, which are indices. Throws DeckError when
  /// there are more corners than an int counts.
  void add_element(const Scanner& scanner, Cell cell, long id, std::size_t position, std::span<const int> element_nodes,
                   int membership);
};

/// Node number of the file -> index. Numbers may have gaps and any order; consecutive ones are found at the first try.
class NodeIndex {
 public:
  /// Throws DeckError if a number is given twice.
  NodeIndex(const Scanner& scanner, const std::vector<long>& ids);
  /// -1 if there is no such node.
  int find(long id) const;

 private:
  std::vector<std::pair<long, int>> sorted_;
};

}  // namespace ashlar
