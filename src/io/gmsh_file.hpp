#pragma once
#include "io/mesh_content.hpp"

namespace ashlar {

/// Reads a Gmsh file, version 2.2 or 4.1, ASCII or binary. Throws DeckError: not a mesh file, truncated, wrong counts,
/// unknown nodes, elements that are not read.
MeshContent read_gmsh(Scanner& scanner);

}  // namespace ashlar
