#pragma once
#include <vector>

#include "backend/backend.hpp"
#include "model/model.hpp"
#include "solve/result.hpp"

namespace ashlar {

/// What the initial stress is to the machine. Laws that remember have it in their history, as the plastic strain whose
/// stress it is; for the others it adds a constant to stress and force, so that no step pays for it.
struct InitialState {
  std::vector<double> stress;   ///< [6 * Gauss points] Pa, of laws without memory; empty: no initial stress
  std::vector<double> force;    ///< [3 * block nodes] N, Blocks order, internal force of `stress`; empty: none
  std::vector<double> history;  ///< Field::history that the run begins with; empty: none
};
/// `blocks`: the model's.
InitialState initial_state(const Model& model, const Blocks& blocks, const Setup& setup);

struct Problem;
/// At the present displacement, load and supports; evaluates the force.
InitialBalance initial_balance(const Problem& problem);

}  // namespace ashlar
