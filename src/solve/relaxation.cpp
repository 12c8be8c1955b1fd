#include "solve/relaxation.hpp"

#include <algorithm>
#include <cmath>

namespace ashlar {

namespace {

constexpr int sum_interval = 10;     // steps between two looks at the sums
constexpr double most_damping = 1.9;  // bound of the viscous coefficient of one step
constexpr double local_alpha = 0.8;   // Cundall's usual value
constexpr double viscous_default = 0.02;
constexpr double noise_ratio = 1e5;     // roundings in a ratio below which it may be rounding that keeps it from falling
constexpr double worth_going_on = 0.7;  // a ratio that has not fallen to this share of its lowest ...
constexpr long patience = 500;          // ... for so many steps, and half as long as it took to get there, has stopped
constexpr double rounding_floor = 1e4;  // roundings in an unbalanced force ratio that cannot fall further

/// Coefficient near critical damping of the lowest mode that still moves (Underwood 1983, in the incremental form that
/// stays valid after prestress).
double adaptive_damping(const RelaxationMeasure& m) {
  if (m.motion <= 0 || m.curvature <= 0) return 0;
  return std::min(2 * std::sqrt(m.curvature / m.motion), most_damping);
}

double force_ratio(const RelaxationMeasure& m, double other) {
  const double scale = std::max({m.load, m.reaction, other});
  if (scale > 0) return m.unbalanced / scale;
  return m.unbalanced > 0 ? 1 : 0;
}

}  // namespace

double local_damping(const Relaxation& r) {
  if (r.damping != Damping::local) return 0;
  return r.damping_value > 0 ? r.damping_value : local_alpha;
}

void evaluate_force(Backend& backend) {
  backend.run(Phase::block_force);
  backend.run(Phase::gather_force);
  backend.run(Phase::spring_force);
}

double thermal_load_norm(Backend& backend) {
  const std::vector<double> displacement = backend.read(Field::displacement);
  backend.write(Field::displacement, std::vector<double>(displacement.size(), 0.0));
  backend.run(Phase::block_force);
  backend.run(Phase::gather_force);
  backend.write(Field::displacement, displacement);
  double sum = 0;
  for (const double f : backend.read(Field::force)) sum += f * f;
  return std::sqrt(sum);
}

Equilibrium relax(Backend& backend, const Relaxation& relaxation, double scale, const RelaxationWatch& watch) {
  backend.run(Phase::stop_nodes);
  Controls controls;
  controls.local_damping = local_damping(relaxation);
  if (relaxation.damping == Damping::viscous)
    controls.viscous_damping = relaxation.damping_value > 0 ? relaxation.damping_value : viscous_default;
  const long limit = relaxation.max_steps > 0 ? relaxation.max_steps : 1000000;

  Equilibrium result;
  double peak_kinetic = 0, lowest_ratio = HUGE_VAL;
  long lowest_at = 0;
  for (long step = sum_interval;; step += sum_interval) {
    backend.relax(controls, sum_interval - 2);
    evaluate_force(backend);
    backend.run(Phase::keep_force);
    backend.run(Phase::move_nodes, controls);
    evaluate_force(backend);
    const RelaxationMeasure m = backend.relaxation_sums();
    result.steps = step;
    result.ratio = force_ratio(m, scale);
    if (!std::isfinite(m.kinetic) || !std::isfinite(result.ratio)) {
      result.stop_reason = "not finite";
      return result;
    }
    peak_kinetic = std::max(peak_kinetic, m.kinetic);
    const double energy = std::max({peak_kinetic, std::abs(m.load_work), 0.5 * std::abs(m.force_work)});
    // A start that balances to rounding leaves no other motion to compare the present one with.
    const bool still = m.kinetic <= relaxation.tolerance * relaxation.tolerance * energy ||
                       result.ratio <= rounding_floor * backend.rounding();
    if (result.ratio <= relaxation.tolerance && still) {
      result.converged = true;
      result.stop_reason = "converged";
      return result;
    }
    if (result.ratio < worth_going_on * lowest_ratio) {
      lowest_ratio = result.ratio;
      lowest_at = step;
    } else if (result.ratio < noise_ratio * backend.rounding() && step - lowest_at > std::max(patience, lowest_at / 2)) {
      result.stop_reason = "precision limit";
      return result;
    }
    if (step >= limit) {
      result.stop_reason = "step limit";
      return result;
    }
    if (watch && watch(step, result.ratio)) {
      result.interrupted = true;
      result.stop_reason = "interrupted";
      return result;
    }
    if (relaxation.damping == Damping::adaptive) controls.viscous_damping = adaptive_damping(m);
    backend.run(Phase::move_nodes, controls);
  }
}

}  // namespace ashlar
