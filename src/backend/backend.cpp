#include "backend/backend.hpp"

#include <chrono>

namespace ashlar {

void Backend::run(Phase phase, const Controls& controls) {
  const auto start = std::chrono::steady_clock::now();
  run_phase(phase, controls);
  seconds_[static_cast<std::size_t>(phase)] +=
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void Backend::relax(const Controls& controls, int steps) {
  for (int i = 0; i < steps; ++i)
    for (const Phase phase : {Phase::block_force, Phase::gather_force, Phase::spring_force, Phase::move_nodes})
      run(phase, controls);
}

void Backend::march_heat(const Controls& controls, int steps) {
  for (int i = 0; i < steps; ++i)
    for (const Phase phase : {Phase::heat_flow, Phase::step_heat}) run(phase, controls);
}

std::vector<int> Setup::first_history() const {
  std::vector<int> first{0};
  for (const Batch& batch : discretisation.batches)
    first.push_back(first.back() +
                    (history_size(laws[batch.material]) > 0 ? batch.element_count * gauss_count(batch.shape) : 0));
  return first;
}

const char* phase_name(Phase phase) {
  switch (phase) {
    case Phase::block_force: return "block_force";
    case Phase::gather_force: return "gather_force";
    case Phase::spring_force: return "spring_force";
    case Phase::move_nodes: return "move_nodes";
    case Phase::relaxation_steps: return "relaxation_steps";
    case Phase::stop_nodes: return "stop_nodes";
    case Phase::keep_force: return "keep_force";
    case Phase::relaxation_sums: return "relaxation_sums";
    case Phase::stiffness_bound: return "stiffness_bound";
    case Phase::block_stress: return "block_stress";
    case Phase::spring_utilisation: return "spring_utilisation";
    case Phase::spring_crossing: return "spring_crossing";
    case Phase::advance_history: return "advance_history";
    case Phase::break_springs: return "break_springs";
    case Phase::keep_springs: return "keep_springs";
    case Phase::look_at_springs: return "look_at_springs";
    case Phase::heat_flow: return "heat_flow";
    case Phase::step_heat: return "step_heat";
    case Phase::heat_steps: return "heat_steps";
    case Phase::heat_bound: return "heat_bound";
    case Phase::start_search: return "start_search";
    case Phase::search_flow: return "search_flow";
    case Phase::advance_search: return "advance_search";
    case Phase::turn_search: return "turn_search";
    case Phase::balance_residual: return "balance_residual";
    case Phase::balance_precondition: return "balance_precondition";
    case Phase::balance_turn: return "balance_turn";
    case Phase::balance_product: return "balance_product";
    case Phase::balance_advance: return "balance_advance";
    case Phase::gauss_temperature: return "gauss_temperature";
    case Phase::start_motion: return "start_motion";
    case Phase::advance_springs: return "advance_springs";
    case Phase::damping_force: return "damping_force";
    case Phase::moving_contacts: return "moving_contacts";
    case Phase::step_motion: return "step_motion";
    case Phase::combine_parts: return "combine_parts";
    case Phase::count: break;
  }
  return "?";
}

}  // namespace ashlar
