#pragma once
#include <variant>
#include <vector>

#include "model/mesher/closed_surface.hpp"
#include "model/mesher/lattice.hpp"
#include "model/mesher/prisms.hpp"
#include "model/mesher/section_graph.hpp"
#include "model/mesher/strips.hpp"

namespace ashlar {

/// The points of one section: columns along its side 0, rows along its side 1.
struct SectionGrid {
  int columns = 0, rows = 0;       ///< cells
  std::vector<PlanePoint> points;  ///< [(columns + 1) (rows + 1)], column fastest
};

/// Transfinite interpolation between the divided sides. Throws DeckError if a cell folds: no logical quad.
SectionGrid fill_section(const SectionGraph& graph, const Section& section, const EdgePoints& edges);

/// Points and cells of one section that is meshed free.
struct SectionCells {
  std::vector<PlanePoint> points;
  std::vector<std::array<int, 4>> cells;  ///< counter-clockwise; a triangle ends in -1
};

/// Triangles, or quads for hex8, between the divided edges. @param layers along y, for the count of cells
SectionCells fill_free_section(const SectionGraph& graph, int section, const EdgePoints& edges, const FreeSizes& sizes,
                               int layers);

/// Planes along y of every extrude: extrudes that share a vertex of the section and touch along y have common planes
/// where they run side by side; the finest `size` (or, before that, the most `layers`) decides.
std::vector<std::vector<double>> layer_planes(const SectionGraph& graph);

/// What an extrude, a box or a solid is made as, before nodes are merged and cells are split.
using MeshedSource = std::variant<Lattice, Prisms, Tetrahedra>;

/// All extrudes, meshed so that they conform where their sections share edges; in the given order.
std::vector<MeshedSource> mesh_extrudes(const std::vector<Extrude>& extrudes);

}  // namespace ashlar
