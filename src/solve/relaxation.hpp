#pragma once
#include <functional>
#include <string>

#include "backend/backend.hpp"
#include "model/model.hpp"

/// Dynamic relaxation: steps of the equation of motion with virtual mass until nothing moves (paper 2.4; numerics 3).
namespace ashlar {

struct Equilibrium {
  bool converged = false;
  bool interrupted = false;
  long steps = 0;
  double ratio = 1;         ///< unbalanced force ratio
  std::string stop_reason;  ///< "converged", "precision limit", "step limit", "not finite (...)", "interrupted"
};

/// Called every few steps with the steps done and the ratio; true stops the relaxation.
using RelaxationWatch = std::function<bool(long steps, double ratio)>;

/// Steps until load and internal force balance, from the displacement in the backend; velocity starts at zero.
/// @param scale force beside loads and reactions that the ratio is taken of, N: that of the temperature alone, say
Equilibrium relax(Backend& backend, const Relaxation& relaxation, double scale, const RelaxationWatch& watch);

/// Local damping coefficient that the relaxation uses: 0 unless its damping is local.
double local_damping(const Relaxation& relaxation);

/// Internal and contact force at the present displacement, into Field::force.
void evaluate_force(Backend& backend);

/// Norm of the internal force of the present temperature at zero displacement, N. Leaves the state as it was.
double thermal_load_norm(Backend& backend);

}  // namespace ashlar
