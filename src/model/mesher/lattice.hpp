#pragma once
#include <array>
#include <vector>

#include "base/tensor.hpp"
#include "model/mesh.hpp"
#include "model/model.hpp"

namespace ashlar {

/// A structured block of points: nx x ny x nz cells, x fastest, then y, then z; x, y, z in right-hand order.
/// What boxes and extruded sections are made as, before nodes are merged and cells are split.
struct Lattice {
  int nx = 0, ny = 0, nz = 0;        ///< cells
  std::vector<Vec3<double>> points;  ///< [(nx + 1) (ny + 1) (nz + 1)], m
  Shape shape = Shape::hex8;         ///< what each cell is split into
  bool wedges_along_y = false;       ///< wedge6: triangles in the x-z plane (extruded sections), else in x-y

  int node(int i, int j, int k) const { return (k * (ny + 1) + j) * (nx + 1) + i; }
  /// Points of cell (i, j, k) in VTK order.
  std::array<int, 8> cell(int i, int j, int k) const {
    return {node(i, j, k),     node(i + 1, j, k),     node(i + 1, j + 1, k),     node(i, j + 1, k),
            node(i, j, k + 1), node(i + 1, j, k + 1), node(i + 1, j + 1, k + 1), node(i, j + 1, k + 1)};
  }
};

/// Throws DeckError where a mesh would have more cells than this program can number, before memory is asked for them.
void check_cell_count(const Where& where, const std::string& what, int nx, int ny, int nz);

/// Uniform cells, then bent. Throws DeckError: no extent along an axis, no cells, numbers that are not finite.
Lattice mesh_box(const Box& box);

/// Adds the cells of a lattice to the mesh as hex8, wedge6 or tet4; `node` maps points of the lattice to mesh nodes.
/// Wedges are cut along the shorter diagonal of their triangles' plane in extruded sections, along corners 0-2 in
/// boxes. Tetrahedra: every quad face is cut from its smallest mesh node, which conforms between any neighbours.
void add_cells(Mesh& mesh, const Lattice& lattice, const std::vector<int>& node, int region);

}  // namespace ashlar
