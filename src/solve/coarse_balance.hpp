#pragma once
#include <vector>

#include "solve/problem.hpp"

namespace ashlar {

/// The coarse part of the elastic search, with neighbouring patches as aggregates (a boundary node belongs to the first
/// patch that has it). Only elements and springs between aggregates, or at supports, resist: the rest moves as a rigid
/// body.
/// @param fixed [block nodes] bits of held components, machine's numbering
CoarseBalance coarse_balance(const Problem& problem, const std::vector<double>& fixed);

}  // namespace ashlar
