#pragma once
#include <vector>

#include "solve/problem.hpp"

/// What a run will do, found without solving.
namespace ashlar {

/// Steps of one factor of a strength reduction, before it counts as falling, unless given.
inline constexpr long usual_trial_steps = 20000;

struct StagePlan {
  long steps = 0;        ///< dynamic and transient thermal stages, heat of coupled ones; 0: only solving tells
  double time_step = 0;  ///< s, of these
  int increments = 1;    ///< static, fracture and coupled stages: balances, one after another
};

/// Increments of what is out of balance at the start of a static stage.
int static_increments(const Problem& problem, const StaticSolve& solve);

/// Sets up every stage of the model without solving it, so that what a run would refuse is refused before its first
/// step. Throws DeckError with the complaints of all stages. A run of the problem starts from the same state after it.
std::vector<StagePlan> plan_stages(Problem& problem);

/// Seconds that pieces of a step take on this machine at this moment, measured.
struct StepSeconds {
  double force = 0;  ///< forces of blocks and contacts, gathered
  double heat = 0;   ///< conduction and film; 0: no thermal stage
};
StepSeconds measure_steps(Problem& problem);

}  // namespace ashlar
