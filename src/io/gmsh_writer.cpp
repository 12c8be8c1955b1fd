#include <algorithm>
#include <map>

#include "io/mesh_writer.hpp"
#include "io/text_file.hpp"

namespace ashlar {

namespace {

std::string quoted(std::string name) {
  std::replace(name.begin(), name.end(), '"', '\'');
  return '"' + name + '"';
}

constexpr int element_type(Shape shape) { return shape == Shape::hex8 ? 5 : shape == Shape::wedge6 ? 6 : 4; }

/// One element of a block: its number and nodes follow the block's head.
struct Block {
  int dimension, entity, type;
  long count = 0;
  std::string lines;
};

/// Adds an element behind those of the same kind, or opens a new block.
void add(std::vector<Block>& blocks, int dimension, int entity, int type, long id, std::span<const int> nodes) {
  if (blocks.empty() || blocks.back().dimension != dimension || blocks.back().entity != entity ||
      blocks.back().type != type)
    blocks.push_back({dimension, entity, type, 0, {}});
  Block& block = blocks.back();
  ++block.count;
  block.lines += std::to_string(id);
  for (const int n : nodes) block.lines += ' ' + std::to_string(n + 1);
  block.lines += '\n';
}

}  // namespace

std::string gmsh_text(const Mesh& mesh) {
  // A facet may be in several surfaces: every set of them is a geometric surface of its own.
  std::map<std::pair<int, int>, std::vector<int>> groups_of;  // by element and face
  for (std::size_t s = 0; s < mesh.surfaces.size(); ++s)
    for (const Facet& f : mesh.surfaces[s].facets) {
      auto& groups = groups_of[{f.element, f.face}];
      if (groups.empty() || groups.back() != static_cast<int>(s) + 1) groups.push_back(static_cast<int>(s) + 1);
    }
  std::map<std::vector<int>, std::vector<Facet>> entities;
  for (const auto& [facet, groups] : groups_of) entities[groups].push_back({facet.first, facet.second});

  const std::size_t regions = mesh.region_names.size();
  std::string text =
      "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n" + std::to_string(regions + mesh.surfaces.size()) + '\n';
  for (std::size_t s = 0; s < mesh.surfaces.size(); ++s)
    text += "2 " + std::to_string(s + 1) + ' ' + quoted(mesh.surfaces[s].name) + '\n';
  for (std::size_t r = 0; r < regions; ++r)
    text += "3 " + std::to_string(r + 1) + ' ' + quoted(mesh.region_names[r]) + '\n';

  Vec3<double> low = mesh.points[0], high = low;
  for (const auto& p : mesh.points)
    for (int a = 0; a < 3; ++a) {
      low[a] = std::min(low[a], p[a]);
      high[a] = std::max(high[a], p[a]);
    }
  std::string box;
  for (const auto& p : {low, high})
    for (int a = 0; a < 3; ++a) box += ' ' + shortest(p[a]);
  text += "$EndPhysicalNames\n$Entities\n0 0 " + std::to_string(entities.size()) + ' ' + std::to_string(regions) + '\n';
  int number = 0;
  for (const auto& [groups, facets] : entities) {
    text += std::to_string(++number) + box + ' ' + std::to_string(groups.size());
    for (const int g : groups) text += ' ' + std::to_string(g);
    text += " 0\n";
  }
  for (std::size_t r = 1; r <= regions; ++r) text += std::to_string(r) + box + " 1 " + std::to_string(r) + " 0\n";

  const std::string nodes = std::to_string(mesh.points.size());
  text += "$EndEntities\n$Nodes\n1 " + nodes + " 1 " + nodes + "\n3 1 0 " + nodes + '\n';
  for (std::size_t n = 1; n <= mesh.points.size(); ++n) text += std::to_string(n) + '\n';
  for (const auto& p : mesh.points) text += shortest(p.x) + ' ' + shortest(p.y) + ' ' + shortest(p.z) + '\n';

  std::vector<Block> blocks;
  for (int e = 0; e < mesh.element_count(); ++e)
    add(blocks, 3, mesh.regions[e] + 1, element_type(mesh.shapes[e]), e + 1, mesh.element(e));
  long id = mesh.element_count();
  number = 0;
  for (const auto& [groups, facets] : entities) {
    ++number;
    for (const Facet& facet : facets) {
      const auto corners = mesh.facet_nodes(facet);
      add(blocks, 2, number, corners.size() == 3 ? 2 : 3, ++id, corners);
    }
  }
  const std::string count = std::to_string(id);
  text += "$EndNodes\n$Elements\n" + std::to_string(blocks.size()) + ' ' + count + " 1 " + count + '\n';
  for (const Block& b : blocks)
    text += std::to_string(b.dimension) + ' ' + std::to_string(b.entity) + ' ' + std::to_string(b.type) + ' ' +
            std::to_string(b.count) + '\n' + b.lines;
  return text + "$EndElements\n";
}

}  // namespace ashlar
