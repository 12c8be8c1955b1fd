#pragma once
#include <string>

#include "model/model.hpp"

namespace ashlar {

/// What `ashlar check` prints of a model whose mesh is built: mesh, quality, regions, surfaces, contacts, plan,
/// estimated effort, what is left out.
/// @param threads 0: all cores
/// Throws DeckError where blocks cannot be split or contacts not placed.
std::string check_report(const Model& model, int threads);

}  // namespace ashlar
