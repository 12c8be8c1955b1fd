#pragma once
#include <string>
#include <vector>

#include "model/blocks.hpp"
#include "model/model.hpp"

namespace ashlar {

/// Memory, steps and time that a run will take, one line each; estimates, and they say so.
/// @param threads 0: all cores
std::vector<std::string> estimate_effort(const Model& model, const Blocks& blocks, const ContactPoints& contacts,
                                         int threads);

}  // namespace ashlar
