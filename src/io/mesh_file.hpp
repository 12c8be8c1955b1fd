#pragma once
#include <string>

#include "base/error.hpp"
#include "model/mesh.hpp"

namespace ashlar {

/// Reads a mesh file with hex8, wedge6 and tet4 elements, by its extension: Gmsh (.msh, version 2.2 or 4.1, ASCII or
/// binary), Abaqus and CalculiX (.inp, see abaqus_file.hpp), VTK (.vtu, see vtu_file.hpp).
/// Gmsh: volume groups become regions, surface groups become surfaces, by ascending group number; a group without a
/// name is called "region_<number>" or "surface_<number>". A file without volume groups gets one region per geometric
/// volume, "region_<volume>". Points and lines are ignored, with the nodes that only they use. All: a facet between two
/// elements belongs to the element that comes first in the file. `where` is the place in the deck that names the file.
/// Throws DeckError: "dam.lua:3: dam.msh:812: what is wrong and what was expected".
Mesh read_mesh(const std::string& path, const Where& where);

}  // namespace ashlar
