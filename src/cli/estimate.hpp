#pragma once
#include <string>
#include <vector>

#include "model/blocks.hpp"
#include "model/model.hpp"

namespace ashlar {

/// Memory, steps and time that a run will take, one line each; estimates, within a factor of two or three.
std::vector<std::string> estimate_effort(const Model& model, const Blocks& blocks, const ContactPoints& contacts);

}  // namespace ashlar
