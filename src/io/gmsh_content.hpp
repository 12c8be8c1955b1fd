#pragma once
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/tensor.hpp"
#include "io/scanner.hpp"
#include "model/mesh.hpp"

/// The contents of a Gmsh file as they stand there, the same for both versions; mesh_file.cpp makes a Mesh of them.
namespace ashlar {

/// Gmsh element types that are known by name; everything else is refused by number.
struct GmshType {
  int number;
  int nodes;
  const char* name;
  int dimension;
  std::optional<Shape> shape;
  bool first_order;
};
inline constexpr GmshType gmsh_types[] = {
    {15, 1, "point", 0, {}, true},
    {1, 2, "line2", 1, {}, true},
    {2, 3, "tri3", 2, {}, true},
    {3, 4, "quad4", 2, {}, true},
    {4, 4, "tet4", 3, Shape::tet4, true},
    {5, 8, "hex8", 3, Shape::hex8, true},
    {6, 6, "wedge6", 3, Shape::wedge6, true},
    {7, 5, "pyramid5", 3, {}, true},
    {8, 3, "line3", 1, {}, false},
    {9, 6, "tri6", 2, {}, false},
    {10, 9, "quad9", 2, {}, false},
    {11, 10, "tet10", 3, {}, false},
    {12, 27, "hex27", 3, {}, false},
    {13, 18, "wedge18", 3, {}, false},
    {14, 14, "pyramid14", 3, {}, false},
    {16, 8, "quad8", 2, {}, false},
    {17, 20, "hex20", 3, {}, false},
    {18, 15, "wedge15", 3, {}, false},
    {19, 13, "pyramid13", 3, {}, false},
};

/// What an element belongs to: its geometric entity and the groups of its own dimension.
struct Membership {
  int entity = 0;
  std::vector<int> groups;
};

/// What a file says, the same for both versions.
struct GmshContent {
  std::map<std::pair<int, int>, std::string> names;  ///< of groups, by dimension and number
  std::vector<long> node_ids;
  std::vector<Vec3<double>> points;
  std::vector<Membership> memberships;
  struct Elements {
    std::vector<int> type;  ///< index into gmsh_types
    std::vector<long> ids;
    std::vector<std::size_t> positions;  ///< in the file
    std::vector<int> membership;
    std::vector<int> first_node{0}, nodes;  ///< node indices in file order
  };
  Elements volumes, facets;
  std::vector<char> used_by_volume, used_at_all;  ///< [nodes]
};

/// Throws DeckError: not a mesh file, truncated, wrong counts, unknown nodes, elements that are not read.
GmshContent read_gmsh(Scanner& scanner);

}  // namespace ashlar
