#pragma once
#include "io/mesh_content.hpp"

namespace ashlar {

/// Reads the mesh of an Abaqus or CalculiX input file (.inp): *NODE, *ELEMENT, *ELSET, *NSET, *SURFACE, *SOLID SECTION;
/// every other keyword is skipped with its data, unless it makes or moves parts of the mesh: that is refused. Regions
/// are the element sets of *SOLID SECTION; in a file without them those of *ELSET, or else those that *ELEMENT names,
/// where they hold every volume element exactly once; without any set all elements are 'region_1'. Node numbers, names
/// and keywords as in the manuals of both programs: case does not matter, a line that ends with a comma goes on. Throws
/// DeckError.
MeshContent read_abaqus(Scanner& scanner);

}  // namespace ashlar
