#include "cli/estimate.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "backend/machine_memory.hpp"
#include "cli/wording.hpp"
#include "model/check_mesh.hpp"

namespace ashlar {
namespace {

// Steps per element across and decade of the ratio, fitted to runs of dams, whole and split into blocks: right within a
// factor of two or three for such bodies. The elastic search of static stages hardly feels the mesh beyond some size;
// fracture increments and crack events begin near their balance.
constexpr double search_steps = 1, most_search_steps = 45, event_steps = 4, rest_steps = 8, steady_steps = 0.45;
// Time of a whole step over that of its largest piece, which is measured.
constexpr double search_over_force = 2.2, relaxation_over_force = 1.6, motion_over_force = 1.4, march_over_heat = 1.2,
                 steady_over_heat = 1.4;

/// What the program holds at this moment, bytes.
std::size_t resident_memory() {
  std::size_t all = 0, resident = 0;
  std::ifstream("/proc/self/statm") >> all >> resident;
  return resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

/// Machine and model are set up: what is still to come are arrays that stages add.
std::string memory_text(const Backend& backend) {
  const std::size_t machine = backend.memory_bytes(), to_come = machine - std::min(machine, MachineMemory::bytes);
  return text("memory %.3g MB for the machine that computes, %.3g MB in all on a CPU",
              static_cast<double>(machine) / 1e6, static_cast<double>(resident_memory() + to_come) / 1e6);
}

/// Nodes that a wave passes on its way through the model.
double elements_across(const Mesh& mesh) {
  Vec3<double> low = mesh.points[0], high = low;
  for (const auto& p : mesh.points)
    for (int i = 0; i < 3; ++i) low[i] = std::min(low[i], p[i]), high[i] = std::max(high[i], p[i]);
  double volume = 0;
  for (int e = 0; e < mesh.element_count(); ++e) volume += element_volume(mesh, e);
  return std::max({high.x - low.x, high.y - low.y, high.z - low.z}) / std::cbrt(volume / mesh.node_count());
}

const Relaxation* relaxation_of(const Stage& stage) {
  if (const auto* s = std::get_if<StaticSolve>(&stage.solve)) return &s->relaxation;
  if (const auto* f = std::get_if<FractureSolve>(&stage.solve)) return &f->relaxation;
  if (const auto* r = std::get_if<StrengthReduction>(&stage.solve)) return &r->relaxation;
  if (const auto* c = std::get_if<CoupledSolve>(&stage.solve)) return &c->relaxation;
  return nullptr;
}

/// One digit and zeros: 20 000.
std::string rounded(double steps) {
  const double power = std::pow(10, std::floor(std::log10(steps)));
  return count_text(std::lround(std::round(steps / power) * power));
}

}  // namespace

std::vector<std::string> estimate_effort(const Problem& problem, const std::vector<StagePlan>& plan,
                                         const StepSeconds& seconds) {
  const Model& model = problem.model;
  std::vector<std::string> lines{memory_text(*problem.backend)};
  const double across = elements_across(model.mesh);
  for (std::size_t i = 0; i < model.stages.size(); ++i) {
    const Stage& stage = model.stages[i];
    const auto* thermal = std::get_if<ThermalSolve>(&stage.solve);
    const auto* fracture = std::get_if<FractureSolve>(&stage.solve);
    const bool coupled = std::holds_alternative<CoupledSolve>(stage.solve);
    double steps = static_cast<double>(plan[i].steps), step = 0, heat = 0;
    std::string words, after;
    if (coupled) {
      heat = march_over_heat * seconds.heat * steps;
      words = count_text(plan[i].steps) + " steps of heat of " + time_text(plan[i].time_step) + " and ";
      steps = 0;
    }
    if (steps > 0) {
      step = thermal ? march_over_heat * seconds.heat : motion_over_force * seconds.force;
      words = count_text(plan[i].steps) + " steps of " + time_text(plan[i].time_step);
    } else if (thermal) {
      steps = steady_steps * across * -std::log10(thermal->tolerance);
      step = steady_over_heat * seconds.heat;
      words = "about " + rounded(steps) + " iterations";
    } else {
      const Relaxation& relaxation = *relaxation_of(stage);
      const int increments = plan[i].increments;
      const bool searches = !fracture && relaxation.search;
      const double decades = 1 - std::log10(relaxation.tolerance);
      steps = decades * (searches   ? std::min(search_steps * across, most_search_steps)
                         : fracture ? event_steps * across
                                    : rest_steps * across);
      step = (searches ? search_over_force : relaxation_over_force) * seconds.force;
      words += "about " + rounded(steps) + " steps";
      if (coupled)
        words += text(" for each of %d balances", increments), steps *= increments;
      else if (std::holds_alternative<StrengthReduction>(stage.solve)) {
        const long most = relaxation.max_steps > 0 ? relaxation.max_steps : usual_trial_steps;
        step = relaxation_over_force * seconds.force;
        steps = static_cast<double>(most) * increments;
        words = "up to " + count_text(most) + " steps for each of " + std::to_string(increments) + " factors";
      } else if (fracture)
        after = text(", for each of %d increments and of the crack events", increments);
      else if (increments > 1)
        words += text(" for each of %d increments", increments), steps *= increments;
    }
    const double all = step * steps + heat;
    const std::string time = all < 1 ? "less than a second" : "about " + duration_text(all);
    lines.push_back("stage " + stage.name + ": " + words + ", " + time + after);
  }
  return lines;
}

}  // namespace ashlar
