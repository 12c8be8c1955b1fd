#pragma once
#include <string>
#include <vector>

#include "solve/plan.hpp"

namespace ashlar {

/// Memory, steps and time that a run on this machine will take, one line each; estimates, within a factor of two or
/// three where solving alone tells the steps. @param plan [stages]
std::vector<std::string> estimate_effort(const Problem& problem, const std::vector<StagePlan>& plan,
                                         const StepSeconds& seconds);

}  // namespace ashlar
