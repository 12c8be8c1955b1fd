#include "io/gmsh_content.hpp"

#include <algorithm>
#include <array>
#include <climits>
#include <set>

namespace ashlar {

namespace {

/// Node number of the file -> index. Numbers may have gaps and any order; consecutive ones are found at the first try.
class NodeIndex {
 public:
  NodeIndex(const Scanner& scanner, const std::vector<long>& ids) {
    sorted_.reserve(ids.size());
    for (std::size_t i = 0; i < ids.size(); ++i) sorted_.push_back({ids[i], static_cast<int>(i)});
    if (!std::is_sorted(sorted_.begin(), sorted_.end())) std::sort(sorted_.begin(), sorted_.end());
    for (std::size_t i = 1; i < sorted_.size(); ++i)
      if (sorted_[i].first == sorted_[i - 1].first)
        scanner.fail_file("node " + std::to_string(sorted_[i].first) + " is given twice");
  }
  /// -1 if there is no such node.
  int find(long id) const {
    if (sorted_.empty() || id < sorted_.front().first || id > sorted_.back().first) return -1;
    const auto guess = static_cast<std::size_t>(id) - static_cast<std::size_t>(sorted_.front().first);
    if (guess < sorted_.size() && sorted_[guess].first == id) return sorted_[guess].second;
    const auto it = std::lower_bound(sorted_.begin(), sorted_.end(), std::pair{id, 0});
    return it != sorted_.end() && it->first == id ? it->second : -1;
  }

 private:
  std::vector<std::pair<long, int>> sorted_;
};

int small_integer(Scanner& scanner, const char* expected) {
  const long value = scanner.integer(expected);
  if (value > INT_MAX || value < -INT_MAX)
    scanner.fail(std::string("expected ") + expected + ", found " + std::to_string(value) + ": too large");
  return static_cast<int>(value);
}

int type_index(Scanner& scanner) {
  const long number = scanner.integer("an element type");
  for (std::size_t i = 0; i < std::size(gmsh_types); ++i) {
    const auto& type = gmsh_types[i];
    if (type.number != number) continue;
    if (!type.first_order)
      scanner.fail("element type " + std::to_string(number) + " (" + type.name +
                   ") is of second order; only first-order elements are read: mesh again with 'Mesh.ElementOrder = 1'");
    if (type.dimension == 3 && !type.shape)
      scanner.fail("element type " + std::to_string(number) + " (" + type.name +
                   ") is not read; valid volume elements are hex8 (5), wedge6 (6) and tet4 (4)");
    return static_cast<int>(i);
  }
  scanner.fail("unknown element type " + std::to_string(number) +
               "; valid are hex8 (5), wedge6 (6), tet4 (4), tri3 (2), quad4 (3), line2 (1) and point (15)");
}

/// The nodes of one element, appended to the list of its dimension; points and lines only mark their nodes.
void read_element(Scanner& scanner, const NodeIndex& index, GmshContent& content, int type, long id,
                  std::size_t position, int membership) {
  const auto& gmsh = gmsh_types[type];
  auto* list = gmsh.dimension == 3 ? &content.volumes : gmsh.dimension == 2 ? &content.facets : nullptr;
  if (list && list->nodes.size() + gmsh.nodes > INT_MAX) scanner.fail("more than 2^31 element corners");
  for (int i = 0; i < gmsh.nodes; ++i) {
    const long node_id = scanner.integer("a node number");
    const int node = index.find(node_id);
    if (node < 0)
      scanner.fail("element " + std::to_string(id) + " (" + gmsh.name + ") uses node " + std::to_string(node_id) +
                   ", which is not in $Nodes");
    content.used_at_all[node] = 1;
    if (gmsh.dimension == 3) content.used_by_volume[node] = 1;
    if (list) list->nodes.push_back(node);
  }
  if (list) {
    list->type.push_back(type);
    list->ids.push_back(id);
    list->positions.push_back(position);
    list->membership.push_back(membership);
    list->first_node.push_back(static_cast<int>(list->nodes.size()));
  }
}

void read_names(Scanner& scanner, GmshContent& content) {
  const long count = scanner.count("the number of physical names");
  scanner.begin_list("names", count);
  for (long i = 0; i < count; ++i, scanner.next()) {
    const int dimension = small_integer(scanner, "the dimension of a group (0 to 3)");
    if (dimension < 0 || dimension > 3)
      scanner.fail("expected the dimension of a group (0 to 3), found " + std::to_string(dimension));
    const int number = small_integer(scanner, "the number of a group");
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

void read_point(Scanner& scanner, GmshContent& content) {
  const double x = scanner.number("a coordinate x");
  const double y = scanner.number("a coordinate y");
  const double z = scanner.number("a coordinate z");
  content.points.push_back({x, y, z});
}

void reserve_nodes(Scanner& scanner, GmshContent& content, long count) {
  if (count > INT_MAX) scanner.fail("more than 2^31 nodes");
  content.node_ids.reserve(count);
  content.points.reserve(count);
  scanner.begin_list("nodes", count);
}

// ---------------------------------------------------------------- version 2.2

void read_nodes_2(Scanner& scanner, GmshContent& content) {
  const long count = scanner.count("the number of nodes");
  reserve_nodes(scanner, content, count);
  for (long i = 0; i < count; ++i, scanner.next()) {
    content.node_ids.push_back(scanner.integer("a node number"));
    read_point(scanner, content);
  }
  scanner.keyword("$EndNodes");
  scanner.end_list();
}

void read_elements_2(Scanner& scanner, const NodeIndex& index, GmshContent& content) {
  const long count = scanner.count("the number of elements");
  scanner.begin_list("elements", count);
  std::map<std::pair<int, int>, int> membership_of;
  for (long i = 0; i < count; ++i, scanner.next()) {
    const long id = scanner.integer("an element number");
    const auto position = scanner.position();
    const int type = type_index(scanner);
    const long tags = scanner.count("the number of tags");
    int group = 0, entity = 0;
    for (long t = 0; t < tags; ++t) {
      const int tag = small_integer(scanner, "a tag");
      if (t == 0) group = std::abs(tag);
      if (t == 1) entity = tag;
    }
    const auto [it, is_new] = membership_of.try_emplace({group, entity}, static_cast<int>(content.memberships.size()));
    if (is_new) content.memberships.push_back({entity, group ? std::vector{group} : std::vector<int>{}});
    read_element(scanner, index, content, type, id, position, it->second);
  }
  scanner.keyword("$EndElements");
  scanner.end_list();
}

// ---------------------------------------------------------------- version 4.1

/// Membership of every entity, by dimension and entity number.
using Entities = std::map<std::pair<int, int>, int>;

Entities read_entities_4(Scanner& scanner, GmshContent& content) {
  std::array<long, 4> counts;
  for (auto& count : counts) count = scanner.count("the number of entities");
  Entities entities;
  for (int dimension = 0; dimension < 4; ++dimension) {
    scanner.begin_list("entities", counts[dimension]);
    for (long i = 0; i < counts[dimension]; ++i, scanner.next()) {
      Membership membership{small_integer(scanner, "an entity number"), {}};
      for (int c = 0; c < (dimension == 0 ? 3 : 6); ++c) scanner.number("a coordinate");
      const long groups = scanner.count("the number of groups");
      // A negative number is the same group seen from the other side.
      for (long g = 0; g < groups; ++g) membership.groups.push_back(std::abs(small_integer(scanner, "a group number")));
      if (dimension > 0) {
        const long bounds = scanner.count("the number of bounding entities");
        for (long b = 0; b < bounds; ++b) scanner.integer("a bounding entity");
      }
      if (!entities.try_emplace({dimension, membership.entity}, static_cast<int>(content.memberships.size())).second)
        scanner.fail("entity " + std::to_string(membership.entity) + " of dimension " + std::to_string(dimension) +
                     " is given twice");
      content.memberships.push_back(membership);
    }
  }
  scanner.keyword("$EndEntities");
  scanner.end_list();
  return entities;
}

int read_dimension(Scanner& scanner) {
  const long dimension = scanner.integer("the dimension of an entity (0 to 3)");
  if (dimension < 0 || dimension > 3)
    scanner.fail("expected the dimension of an entity (0 to 3), found " + std::to_string(dimension));
  return static_cast<int>(dimension);
}

void read_nodes_4(Scanner& scanner, GmshContent& content) {
  const long blocks = scanner.count("the number of node blocks");
  const long count = scanner.count("the number of nodes");
  scanner.integer("the smallest node number");
  scanner.integer("the largest node number");
  reserve_nodes(scanner, content, count);
  for (long b = 0; b < blocks; ++b) {
    const int dimension = read_dimension(scanner);
    scanner.integer("an entity number");
    const bool parametric = scanner.integer("0 or 1 (parametric nodes)") != 0;
    const long here = scanner.count("the number of nodes of a block");
    for (long i = 0; i < here; ++i) content.node_ids.push_back(scanner.integer("a node number"));
    for (long i = 0; i < here; ++i, scanner.next()) {
      read_point(scanner, content);
      if (parametric)
        for (int p = 0; p < dimension; ++p) scanner.number("a parametric coordinate");
    }
  }
  scanner.keyword("$EndNodes");
  if (static_cast<long>(content.node_ids.size()) != count)
    scanner.fail("the blocks of $Nodes hold " + std::to_string(content.node_ids.size()) +
                 " nodes, its first line says " + std::to_string(count));
  scanner.end_list();
}

void read_elements_4(Scanner& scanner, const NodeIndex& index, Entities& entities, bool has_entities,
                     GmshContent& content) {
  const long blocks = scanner.count("the number of element blocks");
  const long count = scanner.count("the number of elements");
  scanner.integer("the smallest element number");
  scanner.integer("the largest element number");
  scanner.begin_list("elements", count);
  long read = 0;
  for (long b = 0; b < blocks; ++b) {
    const int dimension = read_dimension(scanner);
    const int entity = small_integer(scanner, "an entity number");
    auto [it, is_new] = entities.try_emplace({dimension, entity}, static_cast<int>(content.memberships.size()));
    if (is_new && has_entities)
      scanner.fail("entity " + std::to_string(entity) + " of dimension " + std::to_string(dimension) +
                   " is not in $Entities");
    if (is_new) content.memberships.push_back({entity, {}});
    const int type = type_index(scanner);
    if (gmsh_types[type].dimension != dimension)
      scanner.fail(std::string("elements of type ") + gmsh_types[type].name + " cannot lie on an entity of dimension " +
                   std::to_string(dimension));
    const long here = scanner.count("the number of elements of a block");
    for (long i = 0; i < here; ++i, scanner.next()) {
      const long id = scanner.integer("an element number");
      read_element(scanner, index, content, type, id, scanner.position(), it->second);
    }
    read += here;
  }
  scanner.keyword("$EndElements");
  if (read != count)
    scanner.fail("the blocks of $Elements hold " + std::to_string(read) + " elements, its first line says " +
                 std::to_string(count));
  scanner.end_list();
}

// ---------------------------------------------------------------- both versions

bool read_is_version_4(Scanner& scanner) {
  const auto first = scanner.word();
  if (first != "$MeshFormat") scanner.fail("this is no Gmsh mesh file: expected '$MeshFormat' as its first word");
  const std::string version(scanner.word());
  const long binary = scanner.integer("0 (ASCII) or 1 (binary)");
  if (version != "2.2" && version != "2" && version != "4.1")
    scanner.fail("mesh file version '" + version +
                 "' is not read; save it as version 4.1 or 2.2 ('gmsh -format msh41')");
  if (binary != 0) scanner.fail("the file is binary; save it as ASCII ('Mesh.Binary = 0' or without 'gmsh -bin')");
  scanner.integer("the size of a number in bytes");
  scanner.keyword("$EndMeshFormat");
  return version == "4.1";
}

}  // namespace

GmshContent read_gmsh(Scanner& scanner) {
  const bool version_4 = read_is_version_4(scanner);
  GmshContent content;
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
      entities = read_entities_4(scanner, content);
    } else if (section == "$PartitionedEntities") {
      scanner.fail(
          "the mesh is partitioned; save it without partitions ('Mesh.PartitionSplitMeshFiles = 0', unpartition)");
    } else if (section == "$Nodes") {
      version_4 ? read_nodes_4(scanner, content) : read_nodes_2(scanner, content);
    } else if (section == "$Elements") {
      if (!sections.contains("$Nodes")) scanner.fail("section $Elements comes before $Nodes");
      const NodeIndex index(scanner, content.node_ids);
      content.used_by_volume.assign(content.node_ids.size(), 0);
      content.used_at_all.assign(content.node_ids.size(), 0);
      if (version_4)
        read_elements_4(scanner, index, entities, sections.contains("$Entities"), content);
      else
        read_elements_2(scanner, index, content);
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
