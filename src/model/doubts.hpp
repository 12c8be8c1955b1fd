#pragma once
#include <string>
#include <vector>

namespace ashlar {
struct Model;

/// What is valid but looks like a slip of units, axes or levels: one line each, with the deck's line and the probable
/// remedy. The model's mesh and surfaces are made. Studies without dimensions mean such numbers, so nothing is refused.
std::vector<std::string> doubts(const Model& model);

}  // namespace ashlar
