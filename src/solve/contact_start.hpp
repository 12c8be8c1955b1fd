#pragma once
#include "solve/problem.hpp"

namespace ashlar {

/// What contacts of large displacement remember, if they have not looked for each other yet, takes over the shear that the
/// springs of interfaces bear at the present displacement: a body that leans on its friction goes on leaning.
void begin_with_shear_of_springs(const Problem& problem);

}  // namespace ashlar
