#pragma once
#include <array>
#include <vector>

#include "base/tensor.hpp"
#include "model/mesh.hpp"

namespace ashlar {

/// A section of triangles or quads, extruded along y: points plane by plane, cells layer by layer.
struct Prisms {
  std::vector<std::array<int, 4>>
      cells;               ///< points of the first plane, counter-clockwise in x-z; a triangle ends in -1
  int section_points = 0;  ///< points of one plane
  int layers = 0;
  std::vector<Vec3<double>> points;  ///< [(layers + 1) section_points], m
  Shape shape = Shape::hex8;         ///< hex8: quads; wedge6: triangles; tet4: triangles, each prism split into three
};

/// Adds the prisms to the mesh; `node` maps their points to mesh nodes. Tetrahedra as in a lattice: every quad face is
/// cut from its smallest mesh node.
void add_cells(Mesh& mesh, const Prisms& prisms, const std::vector<int>& node, int region);

}  // namespace ashlar
