#include "solve/elastic_start.hpp"

#include <algorithm>
#include <cmath>

namespace ashlar {

namespace {

constexpr double below_tolerance = 0.1;  // of the stage's tolerance: relaxation confirms, it does not repeat

}  // namespace

bool ElasticStart::applies() const {
  const std::vector<double> state = backend_.read(Field::contact_state);
  const std::vector<SpringLaw<double>> laws = problem_.setup().interface_laws;
  for (int c = 0; c < problem_.contacts.count(); ++c)
    if (!laws[problem_.contacts.interface[c]].holds(static_cast<ContactState>(state[c]))) return false;
  return true;
}

long ElasticStart::run(const Relaxation& relaxation, double thermal_load, const RelaxationWatch& watch) {
  if (!coarse_written_) backend_.write_coarse(coarse_balance(problem_, backend_.read(Field::fixed)));
  coarse_written_ = true;

  evaluate_force(backend_);
  const RelaxationMeasure start = backend_.relaxation_sums();
  const double scale = std::max({start.load, start.reaction, thermal_load});
  if (!(scale > 0)) return 0;
  backend_.run(Phase::balance_residual);
  backend_.run(Phase::balance_precondition);
  Controls controls;
  backend_.run(Phase::balance_turn, controls);
  double before = backend_.balance_sums().preconditioned;
  const long usual = 10 * static_cast<long>(std::sqrt(double(backend_.size(Field::inverse_mass)))) + 1000;
  const long limit = relaxation.max_steps > 0 ? std::min(relaxation.max_steps, usual) : usual;
  long iteration = 0;
  while (iteration < limit && before > 0) {
    ++iteration;
    backend_.run(Phase::balance_product);
    controls.search_length = before / backend_.balance_along();
    if (!std::isfinite(controls.search_length)) break;
    backend_.run(Phase::balance_advance, controls);
    backend_.run(Phase::balance_precondition);
    const BalanceMeasure now = backend_.balance_sums();
    if (now.residual <= below_tolerance * relaxation.tolerance * scale) break;
    if (watch && watch(iteration, now.residual / scale)) break;
    controls.search_keep = now.preconditioned / before;
    before = now.preconditioned;
    backend_.run(Phase::balance_turn, controls);
  }
  return iteration;
}

}  // namespace ashlar
