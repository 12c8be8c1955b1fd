#pragma once
#include <string>
#include <vector>

#include "model/mesher/closed_surface.hpp"
#include "model/model.hpp"

namespace ashlar {

/// The inside of a solid's surface as tetrahedra. What the deck should know is added to `notes`.
/// Throws DeckError: a surface that bounds no body, elements too many, or too large for its shape.
Tetrahedra mesh_solid(const Solid& solid, std::vector<std::string>& notes);

/// Adds the tetrahedra to the mesh; `node` maps their points to mesh nodes.
void add_cells(Mesh& mesh, const Tetrahedra& tetrahedra, const std::vector<int>& node, int region);

}  // namespace ashlar
