#pragma once
#include <string>
#include <vector>

#include "model/blocks.hpp"
#include "model/model.hpp"

namespace ashlar {

/// Memory, steps and time that a run will take, one line each; estimates, within a factor of two or so.
/// @param stiffest_springs how many times stiffer the springs are than the elements beside them; 0: no springs
std::vector<std::string> estimate_effort(const Model& model, const Blocks& blocks, const ContactPoints& contacts,
                                         double stiffest_springs);

}  // namespace ashlar
