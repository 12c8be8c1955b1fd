#pragma once
#include <string>
#include <vector>

#include "model/blocks.hpp"

namespace ashlar {

/// Blocks tied together by interfaces that the supports of a stage leave free to move as one rigid body.
struct LooseBody {
  std::vector<std::string> regions;
  std::string movement;  ///< a movement that nothing holds: "along x", "about the y axis", "in any direction"
};

/// Bodies that the conditions `fix` and `displacement` acting in a stage do not hold: the rank of the six rigid
/// movements on the held components is less than six. Ordered by first element.
std::vector<LooseBody> loose_bodies(const Model& model, const Blocks& blocks, int stage);

}  // namespace ashlar
