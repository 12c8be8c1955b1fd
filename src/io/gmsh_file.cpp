#include "io/gmsh_file.hpp"

#include <array>
#include <climits>
#include <optional>
#include <set>

namespace ashlar {

namespace {

/// Gmsh element types that are known by name; everything else is refused by number.
struct GmshType {
  int number;
  int nodes;
  const char* name;
  int dimension;
  std::optional<Cell> cell;
  bool first_order;
};
constexpr GmshType gmsh_types[] = {
    {15, 1, "point", 0, {}, true},           {1, 2, "line2", 1, {}, true},
    {2, 3, "tri3", 2, Cell::tri3, true},     {3, 4, "quad4", 2, Cell::quad4, true},
    {4, 4, "tet4", 3, Cell::tet4, true},     {5, 8, "hex8", 3, Cell::hex8, true},
    {6, 6, "wedge6", 3, Cell::wedge6, true}, {7, 5, "pyramid5", 3, {}, true},
    {8, 3, "line3", 1, {}, false},           {9, 6, "tri6", 2, {}, false},
    {10, 9, "quad9", 2, {}, false},          {11, 10, "tet10", 3, {}, false},
    {12, 27, "hex27", 3, {}, false},         {13, 18, "wedge18", 3, {}, false},
    {14, 14, "pyramid14", 3, {}, false},     {16, 8, "quad8", 2, {}, false},
    {17, 20, "hex20", 3, {}, false},         {18, 15, "wedge15", 3, {}, false},
    {19, 13, "pyramid13", 3, {}, false},
};

const GmshType& read_type(Scanner& scanner) {
  const int number = scanner.small_integer("an element type");
  for (const auto& type : gmsh_types) {
    if (type.number != number) continue;
    if (!type.first_order)
      scanner.fail("element type " + std::to_string(number) + " (" + type.name +
                   ") is of second order; only first-order elements are read: mesh again with 'Mesh.ElementOrder = 1'");
    if (type.dimension == 3 && !type.cell)
      scanner.fail("element type " + std::to_string(number) + " (" + type.name +
                   ") is not read; valid volume elements are hex8 (5), wedge6 (6) and tet4 (4)");
    return type;
  }
  scanner.fail("unknown element type " + std::to_string(number) +
               "; valid are hex8 (5), wedge6 (6), tet4 (4), tri3 (2), quad4 (3), line2 (1) and point (15)");
}

/// The nodes of one element, appended to the list of its dimension; points and lines only mark their nodes.
void read_element(Scanner& scanner, const NodeIndex& index, MeshContent& content, const GmshType& type, long id,
                  std::size_t position, int membership) {
  std::array<int, 8> nodes;
  for (int i = 0; i < type.nodes; ++i) {
    const long node_id = scanner.integer("a node number");
    nodes[i] = index.find(node_id);
    if (nodes[i] < 0)
      scanner.fail("element " + std::to_string(id) + " (" + type.name + ") uses node " + std::to_string(node_id) +
                   ", which is not in $Nodes");
    content.used_at_all[nodes[i]] = 1;
  }
  if (type.cell)
    content.add_element(scanner, *type.cell, id, position, std::span(nodes.data(), type.nodes), membership);
}

void read_names(Scanner& scanner, MeshContent& content) {
  const long count = scanner.count("the number of physical names");
  scanner.begin_list("names", count);
  for (long i = 0; i < count; ++i, scanner.next()) {
    const int dimension = scanner.small_integer("the dimension of a group (0 to 3)");
    if (dimension < 0 || dimension > 3)
      scanner.fail("expected the dimension of a group (0 to 3), found " + std::to_string(dimension));
    const int number = scanner.small_integer("the number of a group");
    const std::string name = scanner.quoted("the name of a group in quotation marks");
    for (const auto& [group, other] : content.names)
      if (group.first == dimension && (group.second == number || other == name))
        scanner.fail("groups " + std::to_string(group.second) + " '" + other + "' and " + std::to_string(number) +
                     " '" + name + "' of dimension " + std::to_string(dimension) +
                     " share a name or a number; each group needs its own");
    content.names[{dimension, number}] = name;
  }
  scanner.keyword("$EndPhysicalNames");
  scanner.end_list();
}

void read_point(Scanner& scanner, MeshContent& content) {
  const double x = scanner.number("a coordinate x");
  const double y = scanner.number("a coordinate y");
  const double z = scanner.number("a coordinate z");
  content.points.push_back({x, y, z});
}

void reserve_nodes(Scanner& scanner, MeshContent& content, long count) {
  if (count > INT_MAX) scanner.fail("more than 2^31 nodes");
  content.node_ids.reserve(count);
  content.points.reserve(count);
  scanner.begin_list("nodes", count);
}

// ---------------------------------------------------------------- version 2.2

void read_nodes_2(Scanner& scanner, bool binary, MeshContent& content) {
  const long count = scanner.count("the number of nodes");
  reserve_nodes(scanner, content, count);
  if (binary) scanner.begin_binary(4);
  for (long i = 0; i < count; ++i, scanner.next()) {
    content.node_ids.push_back(scanner.integer("a node number"));
    read_point(scanner, content);
  }
  scanner.end_binary();
  scanner.keyword("$EndNodes");
  scanner.end_list();
}

void read_elements_2(Scanner& scanner, bool binary, const NodeIndex& index, MeshContent& content) {
  const long count = scanner.count("the number of elements");
  scanner.begin_list("elements", count);
  std::map<std::pair<int, int>, int> membership_of;
  auto read_one = [&](long id, std::size_t position, const GmshType& type, long tags) {
    int group = 0, entity = 0;
    for (long t = 0; t < tags; ++t) {
      const int tag = scanner.small_integer("a tag");
      if (t == 0) group = std::abs(tag);
      if (t == 1) entity = tag;
    }
    const auto [it, is_new] = membership_of.try_emplace({group, entity}, static_cast<int>(content.memberships.size()));
    if (is_new) content.memberships.push_back({entity, group ? std::vector{group} : std::vector<int>{}});
    read_element(scanner, index, content, type, id, position, it->second);
    scanner.next();
  };
  if (!binary) {
    for (long i = 0; i < count; ++i) {
      const long id = scanner.integer("an element number");
      const auto position = scanner.position();
      const GmshType& type = read_type(scanner);
      read_one(id, position, type, scanner.count("the number of tags"));
    }
  } else {
    scanner.begin_binary(4);
    for (long read = 0; read < count;) {
      const GmshType& type = read_type(scanner);
      const long here = scanner.count("the number of elements of a block");
      if (here == 0 || here > count - read)
        scanner.fail("a block of " + std::to_string(here) + " elements follows after " + std::to_string(read) +
                     " of the " + std::to_string(count) + " elements that the section announces");
      const long tags = scanner.count("the number of tags");
      for (long i = 0; i < here; ++i) {
        const auto position = scanner.position();
        read_one(scanner.integer("an element number"), position, type, tags);
      }
      read += here;
    }
  }
  scanner.end_binary();
  scanner.keyword("$EndElements");
  scanner.end_list();
}

// ---------------------------------------------------------------- version 4.1

/// Membership of every entity, by dimension and entity number.
using Entities = std::map<std::pair<int, int>, int>;

Entities read_entities_4(Scanner& scanner, bool binary, MeshContent& content) {
  if (binary) scanner.begin_binary(8);
  std::array<long, 4> counts;
  for (auto& count : counts) count = scanner.count("the number of entities");
  Entities entities;
  for (int dimension = 0; dimension < 4; ++dimension) {
    scanner.begin_list("entities", counts[dimension]);
    for (long i = 0; i < counts[dimension]; ++i, scanner.next()) {
      Membership membership{scanner.small_integer("an entity number"), {}};
      for (int c = 0; c < (dimension == 0 ? 3 : 6); ++c) scanner.number("a coordinate");
      const long groups = scanner.count("the number of groups");
      // A negative number is the same group seen from the other side.
      for (long g = 0; g < groups; ++g) membership.groups.push_back(std::abs(scanner.small_integer("a group number")));
      if (dimension > 0) {
        const long bounds = scanner.count("the number of bounding entities");
        for (long b = 0; b < bounds; ++b) scanner.small_integer("a bounding entity");
      }
      if (!entities.try_emplace({dimension, membership.entity}, static_cast<int>(content.memberships.size())).second)
        scanner.fail("entity " + std::to_string(membership.entity) + " of dimension " + std::to_string(dimension) +
                     " is given twice");
      content.memberships.push_back(membership);
    }
  }
  scanner.end_binary();
  scanner.keyword("$EndEntities");
  scanner.end_list();
  return entities;
}

int read_dimension(Scanner& scanner) {
  const int dimension = scanner.small_integer("the dimension of an entity (0 to 3)");
  if (dimension < 0 || dimension > 3)
    scanner.fail("expected the dimension of an entity (0 to 3), found " + std::to_string(dimension));
  return dimension;
}

void read_nodes_4(Scanner& scanner, bool binary, MeshContent& content) {
  if (binary) scanner.begin_binary(8);
  const long blocks = scanner.count("the number of node blocks");
  const long count = scanner.count("the number of nodes");
  scanner.integer("the smallest node number");
  scanner.integer("the largest node number");
  reserve_nodes(scanner, content, count);
  for (long b = 0; b < blocks; ++b) {
    const int dimension = read_dimension(scanner);
    scanner.small_integer("an entity number");
    const bool parametric = scanner.small_integer("0 or 1 (parametric nodes)") != 0;
    const long here = scanner.count("the number of nodes of a block");
    for (long i = 0; i < here; ++i) content.node_ids.push_back(scanner.integer("a node number"));
    for (long i = 0; i < here; ++i, scanner.next()) {
      read_point(scanner, content);
      if (parametric)
        for (int p = 0; p < dimension; ++p) scanner.number("a parametric coordinate");
    }
  }
  scanner.end_binary();
  scanner.keyword("$EndNodes");
  if (static_cast<long>(content.node_ids.size()) != count)
    scanner.fail("the blocks of $Nodes hold " + std::to_string(content.node_ids.size()) +
                 " nodes, its first line says " + std::to_string(count));
  scanner.end_list();
}

void read_elements_4(Scanner& scanner, bool binary, const NodeIndex& index, Entities& entities, bool has_entities,
                     MeshContent& content) {
  if (binary) scanner.begin_binary(8);
  const long blocks = scanner.count("the number of element blocks");
  const long count = scanner.count("the number of elements");
  scanner.integer("the smallest element number");
  scanner.integer("the largest element number");
  scanner.begin_list("elements", count);
  long read = 0;
  for (long b = 0; b < blocks; ++b) {
    const int dimension = read_dimension(scanner);
    const int entity = scanner.small_integer("an entity number");
    auto [it, is_new] = entities.try_emplace({dimension, entity}, static_cast<int>(content.memberships.size()));
    if (is_new && has_entities)
      scanner.fail("entity " + std::to_string(entity) + " of dimension " + std::to_string(dimension) +
                   " is not in $Entities");
    if (is_new) content.memberships.push_back({entity, {}});
    const GmshType& type = read_type(scanner);
    if (type.dimension != dimension)
      scanner.fail(std::string("elements of type ") + type.name + " cannot lie on an entity of dimension " +
                   std::to_string(dimension));
    const long here = scanner.count("the number of elements of a block");
    for (long i = 0; i < here; ++i, scanner.next()) {
      const long id = scanner.integer("an element number");
      read_element(scanner, index, content, type, id, scanner.position(), it->second);
    }
    read += here;
  }
  scanner.end_binary();
  scanner.keyword("$EndElements");
  if (read != count)
    scanner.fail("the blocks of $Elements hold " + std::to_string(read) + " elements, its first line says " +
                 std::to_string(count));
  scanner.end_list();
}

// ---------------------------------------------------------------- both versions

struct Format {
  bool version_4 = false, binary = false;
};

Format read_format(Scanner& scanner) {
  const auto first = scanner.word();
  if (first != "$MeshFormat") scanner.fail("this is no Gmsh mesh file: expected '$MeshFormat' as its first word");
  const std::string version(scanner.word());
  if (version != "2.2" && version != "2" && version != "4.1")
    scanner.fail("mesh file version '" + version +
                 "' is not read; save it as version 4.1 or 2.2 ('gmsh -format msh41')");
  const long binary = scanner.integer("0 (ASCII) or 1 (binary)");
  if (binary != 0 && binary != 1) scanner.fail("expected 0 (ASCII) or 1 (binary), found " + std::to_string(binary));
  const long bytes = scanner.integer("the size of a number in bytes");
  if (binary) {
    if (bytes != 8) scanner.fail("binary numbers of " + std::to_string(bytes) + " bytes are not read; valid: 8");
    scanner.begin_binary(4);
    if (scanner.integer("the number 1 that shows the order of bytes") != 1)
      scanner.fail(
          "the binary numbers have another order of bytes than this machine; save the mesh as ASCII "
          "('Mesh.Binary = 0')");
    scanner.end_binary();
  }
  scanner.keyword("$EndMeshFormat");
  return {version == "4.1", binary == 1};
}

}  // namespace

MeshContent read_gmsh(Scanner& scanner) {
  const auto [version_4, binary] = read_format(scanner);
  MeshContent content;
  Entities entities;
  std::set<std::string, std::less<>> sections;
  while (!scanner.at_end()) {
    const auto start = scanner.position();
    const std::string section(scanner.word());
    if (section.size() < 2 || section[0] != '$')
      scanner.fail("expected a section such as '$Nodes', found '" + section.substr(0, 40) + "'");
    if (!sections.insert(section).second && section[1] != 'C' && !section.ends_with("Data"))
      scanner.fail("section " + section + " is given twice");
    if (section == "$PhysicalNames") {
      read_names(scanner, content);
    } else if (section == "$Entities" && version_4) {
      entities = read_entities_4(scanner, binary, content);
    } else if (section == "$PartitionedEntities") {
      scanner.fail(
          "the mesh is partitioned; save it without partitions ('Mesh.PartitionSplitMeshFiles = 0', unpartition)");
    } else if (section == "$Nodes") {
      version_4 ? read_nodes_4(scanner, binary, content) : read_nodes_2(scanner, binary, content);
    } else if (section == "$Elements") {
      if (!sections.contains("$Nodes")) scanner.fail("section $Elements comes before $Nodes");
      const NodeIndex index(scanner, content.node_ids);
      content.used_by_volume.assign(content.node_ids.size(), 0);
      content.used_at_all.assign(content.node_ids.size(), 0);
      if (version_4)
        read_elements_4(scanner, binary, index, entities, sections.contains("$Entities"), content);
      else
        read_elements_2(scanner, binary, index, content);
    } else if (!scanner.skip_past("$End" + section.substr(1))) {
      scanner.fail(start,
                   "section " + section + " does not end with '$End" + section.substr(1) + "': the file is truncated");
    }
  }
  for (const char* needed : {"$Nodes", "$Elements"})
    if (!sections.contains(needed))
      scanner.fail_file(std::string("there is no section ") + needed + ": the file is truncated");
  return content;
}

}  // namespace ashlar
