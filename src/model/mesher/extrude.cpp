#include "model/mesher/extrude.hpp"

#include <map>
#include <set>

namespace ashlar {

namespace {

/// Sections that are meshed free and have the same edges get the same mesh, so that they fit one behind the other.
using SectionKey = std::pair<std::set<Edge>, Shape>;
SectionKey key_of(const Section& section) {
  SectionKey key{{}, section.extrude->shape};
  SectionGraph::for_each_edge(section, [&](int a, int b) { key.first.insert(edge_of(a, b)); });
  return key;
}

Lattice lattice_of(const SectionGrid& grid, const std::vector<double>& planes, const Extrude& extrude) {
  const int layers = static_cast<int>(planes.size()) - 1;
  check_cell_count(extrude.where, "extrude '" + extrude.name + "'", grid.columns, layers, grid.rows);
  Lattice lattice{grid.columns, layers, grid.rows, {}, extrude.shape, true};
  for (int k = 0; k <= grid.rows; ++k)
    for (const double y : planes)
      for (int i = 0; i <= grid.columns; ++i) {
        const auto& p = grid.points[k * (grid.columns + 1) + i];
        lattice.points.push_back({p[0], y, p[1]});
      }
  return lattice;
}

Prisms prisms_of(const SectionCells& section, const std::vector<double>& planes, const Extrude& extrude) {
  const int layers = static_cast<int>(planes.size()) - 1;
  check_cell_count(extrude.where, "extrude '" + extrude.name + "'", static_cast<int>(section.cells.size()), layers, 1);
  Prisms prisms{section.cells, static_cast<int>(section.points.size()), layers, {}, extrude.shape};
  for (const double y : planes)
    for (const auto& p : section.points) prisms.points.push_back({p[0], y, p[1]});
  return prisms;
}

}  // namespace

std::vector<MeshedSource> mesh_extrudes(const std::vector<Extrude>& extrudes) {
  auto graph = join_sections(extrudes);
  match_opposite_sides(graph);
  FreeSizes sizes(graph);
  const auto edges = divide_edges(graph, sizes);
  const auto planes = layer_planes(graph);

  std::vector<MeshedSource> meshed;
  std::map<SectionKey, SectionCells> free_sections;
  for (int s = 0; s < static_cast<int>(extrudes.size()); ++s) {
    const auto& section = graph.sections[s];
    if (!section.free) {
      meshed.push_back(lattice_of(fill_section(graph, section, edges), planes[s], extrudes[s]));
      continue;
    }
    const auto key = key_of(section);
    if (!free_sections.contains(key))
      free_sections[key] = fill_free_section(graph, s, edges, sizes, static_cast<int>(planes[s].size()) - 1);
    meshed.push_back(prisms_of(free_sections[key], planes[s], extrudes[s]));
  }
  return meshed;
}

}  // namespace ashlar
