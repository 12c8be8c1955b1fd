#pragma once
#include "io/mesh_content.hpp"

namespace ashlar {

/// Reads a VTK XML file of one unstructured grid (.vtu): arrays in ASCII, in base64 or appended raw, not compressed.
/// The integer cell array 'region', 'material' or 'gmsh:physical' (the first of these names that is there) numbers the
/// regions of volume cells, "region_<number>", and the surfaces of triangles and quadrangles, "surface_<number>";
/// without it all volume cells are 'region_1'. Points and lines are skipped. Wedges are taken in either of the two
/// orders that programs write, but one order for the whole file. Cells and points are counted from 0 in messages.
/// Throws DeckError.
MeshContent read_vtu(Scanner& scanner);

}  // namespace ashlar
