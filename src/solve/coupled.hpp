#pragma once
#include <functional>
#include <vector>

#include "solve/checkpoint.hpp"
#include "solve/problem.hpp"
#include "solve/result.hpp"

/// Coupled stages: two lanes in a pipeline (paper Fig. 7; numerics 7). While the stress lane looks for equilibrium at
/// one time, the heat lane marches to the next; only the temperature crosses, from machine to machine.
namespace ashlar {

/// Times of equilibria, s since the stage began: 0, every, 2 every, ..., the duration.
std::vector<double> balance_times(const CoupledSolve& solve);

/// What the stress lane does in a coupled stage.
struct CoupledLinks {
  /// Takes the temperature over from the heat lane, which rests.
  std::function<void()> take_over;
  /// Equilibrium at time number `number`; before the first one there is nothing to take over. False: stopped.
  std::function<bool(int number)> balance;
  /// Asked now and then; true stops the stage.
  std::function<bool()> interrupted;
  /// Whenever the temperature has been taken over; calls back with what to write down if it is wanted.
  std::function<void(const std::function<void(Exchange&)>&)> keep;
  /// Called once the stage is set up; calls back with what to take if it goes on from within.
  std::function<void(const std::function<void(Exchange&)>&)> go_on;
};

/// Marches coupled stage `stage` (0-based) from a temperature, [mesh nodes] in the mesh's own order, degC. Fills in
/// what the heat lane did and how the lanes shared the time; and the stop reason where heat is what stopped.
/// False: stopped.
bool march_coupled(Problem& problem, int stage, const std::vector<double>& temperature, const CoupledLinks& links,
                   StageResult& result);

}  // namespace ashlar
