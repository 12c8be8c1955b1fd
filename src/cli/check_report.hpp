#pragma once
#include <string>

#include "model/model.hpp"

namespace ashlar {

/// What `ashlar check` prints of a model whose mesh is built: mesh, quality, regions, surfaces, contacts, plan,
/// estimated effort, what is left out.
/// Throws DeckError where blocks cannot be split or contacts not placed.
std::string check_report(const Model& model);

}  // namespace ashlar
