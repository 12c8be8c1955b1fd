#pragma once
#include <vector>

#include "solve/problem.hpp"

/// Which blocks would float away.
namespace ashlar {

/// Blocks that hold each other (contacts bonded or pressed together) but are not kept from moving as a rigid body: the
/// held components of their nodes leave at least one of the six rigid movements free.
struct FreeBody {
  std::vector<int> blocks;    ///< Blocks numbering, ascending
  std::vector<int> nodes;     ///< block nodes in the machine's numbering, ascending
  std::vector<int> supports;  ///< components 3 * node + axis that, held as well, stop it and let it deform freely
};

/// By the contacts that Field::joined holds together. Ordered by first block.
std::vector<FreeBody> free_bodies(const Problem& problem);

}  // namespace ashlar
