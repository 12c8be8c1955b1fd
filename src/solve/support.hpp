#pragma once
#include <vector>

#include "solve/contact_states.hpp"

/// Which blocks would float away.
namespace ashlar {

/// Blocks that hold each other (contacts bonded or pressed together) but are not kept from moving as a rigid body: the
/// held components of their nodes leave at least one of the six rigid movements free.
struct FreeBody {
  std::vector<int> blocks;  ///< Blocks numbering, ascending
  std::vector<int> nodes;   ///< block nodes in the machine's numbering, ascending
};

/// @param fixed [block nodes, the machine's numbering] bits 0 1 2: x y z held
/// @param contacts from read_contacts; empty: no contact holds
std::vector<FreeBody> free_bodies(const Setup& setup, const Mesh& mesh, const Blocks& blocks,
                                  const std::vector<ContactPoint>& contacts, const std::vector<double>& fixed);

}  // namespace ashlar
