#pragma once
#include <vector>

#include "model/mesher/size_field.hpp"

namespace ashlar {

/// Sizes that the shape of a free section asks for along its edges: `size` or `hole_size`, the length of short edges,
/// and the width of what lies between two edges. Throws DeckError where that is less than a fiftieth of the size.
std::vector<SizeAt> sizes_of_shape(const SectionGraph& graph, const Section& section);

}  // namespace ashlar
