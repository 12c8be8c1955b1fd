#pragma once
#include <string>
#include <vector>

#include "model/model.hpp"

namespace ashlar {

/// What an engineer would expect to act on such a dam and this model does not hold, one line each:
/// "uplift: no water pressure acts in joints and cracks". Needs model.mesh.
std::vector<std::string> left_out(const Model& model);

}  // namespace ashlar
