#pragma once
#include "solve/observer.hpp"
#include "solve/problem.hpp"

namespace ashlar {

/// Runs the model's stages in order; each continues from the state that the one before it left (numerics 7). Stops
/// after a stage that did not converge or was interrupted; everything reached so far has been given to the observer.
/// Throws DeckError for conditions that only show against the mesh.
/// @param restart where an earlier run of the same problem stopped: the same results, to the last bit, as if it had not
RunResult solve(Problem& problem, Observer& observer, const Restart& restart = {});

}  // namespace ashlar
