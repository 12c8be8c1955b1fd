#pragma once
#include <functional>
#include <string>
#include <vector>

#include "solve/checkpoint.hpp"
#include "solve/problem.hpp"
#include "solve/result.hpp"

/// Motion in time with the real mass (paper 2.4; numerics 3, dynamic stages): central difference, velocities in the
/// middle of steps, displacements at their ends.
namespace ashlar {

/// Longest steps at which a motion stays bounded, s.
struct StableStep {
  double blocks = 0;    ///< 2 / omega by row sums of the blocks' stiffness over the mass, never too long
  double springs = 0;   ///< sqrt(2 m / sum k A) of the contacts, 0: no contacts
  double together = 0;  ///< of both, and with stiffness-proportional damping
  double switching = 0;  ///< the same where contacts open, close and slide without energy from nothing
};
/// @param damping stiffness-proportional, s
/// @param large whether contacts are those of large displacement
StableStep stable_step(const Problem& problem, double damping, bool large = false);

/// Equal steps of a stage, as long as they may be. Throws DeckError: a time step of the deck above the stable one.
struct MotionSteps {
  long count = 0;
  double length = 0, stable = 0;  ///< s
};
MotionSteps motion_steps(const Problem& problem, const Stage& stage);

/// What a motion tells while it goes on. Returns true where it shall stop.
struct DynamicLinks {
  std::function<bool(long step, double fraction)> watch;  ///< every few steps
  /// Every few steps, before `watch`; calls back with what to write down if it is wanted.
  std::function<void(const std::function<void(Exchange&)>&)> keep;
  /// Called once the stage is set up; calls back with what to take if it goes on from within.
  std::function<void(const std::function<void(Exchange&)>&)> go_on;
  /// At the interval of DynamicSolve::record_every: number of the record from 1, s since the stage began, velocity
  /// [3 * block nodes, the machine's numbering] m/s at this moment, energies so far.
  std::function<void(int record, double seconds, const std::vector<double>& velocity, const EnergyBalance& energy)>
      record;
  std::function<void(const CrackEvent&)> cracked;
};

/// Moves for the duration of the stage from the displacement in the backend, under the load there; held components stay
/// where they are. Leaves the velocity of the end in Field::velocity.
/// @param moving whether the velocity in the backend is that of the start; else the body starts from rest
void move_in_time(const Problem& problem, const Stage& stage, bool moving, const DynamicLinks& links,
                  StageResult& result);

}  // namespace ashlar
