#include "model/mesher/extrude.hpp"

namespace ashlar {

std::vector<Lattice> mesh_extrudes(const std::vector<Extrude>& extrudes) {
  auto graph = join_sections(extrudes);
  match_opposite_sides(graph);
  const auto edges = divide_edges(graph);
  const auto planes = layer_planes(graph);

  std::vector<Lattice> lattices;
  for (std::size_t s = 0; s < extrudes.size(); ++s) {
    const auto grid = fill_section(graph, graph.sections[s], edges);
    const int layers = static_cast<int>(planes[s].size()) - 1;
    check_cell_count(extrudes[s].where, "extrude '" + extrudes[s].name + "'", grid.columns, layers, grid.rows);
    Lattice lattice{grid.columns, layers, grid.rows, {}, extrudes[s].shape, true};
    for (int k = 0; k <= grid.rows; ++k)
      for (const double y : planes[s])
        for (int i = 0; i <= grid.columns; ++i) {
          const auto& p = grid.points[k * (grid.columns + 1) + i];
          lattice.points.push_back({p[0], y, p[1]});
        }
    lattices.push_back(std::move(lattice));
  }
  return lattices;
}

}  // namespace ashlar
