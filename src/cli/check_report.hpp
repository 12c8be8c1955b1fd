#pragma once
#include <string>

#include "solve/problem.hpp"

namespace ashlar {

/// What `ashlar check` prints of a model made ready to run: mesh, quality, regions, surfaces, contacts, plan,
/// estimated effort, what is left out.
std::string check_report(Problem& problem);

}  // namespace ashlar
