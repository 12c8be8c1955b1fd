#include "solve/thermal.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/loads.hpp"
#include "solve/contact_states.hpp"
#include "solve/time_parts.hpp"

namespace ashlar {

namespace {

constexpr double least_steps = 200;     // of a transient stage
constexpr double steps_of_period = 50;  // of what changes in time
constexpr long steps_between_looks = 10;

std::vector<double> to_machine(const Problem& problem, const std::vector<double>& mesh_order) {
  const std::vector<int>& new_node = problem.discretisation.heat.new_node;
  std::vector<double> machine(mesh_order.size());
  for (std::size_t n = 0; n < new_node.size(); ++n) machine[new_node[n]] = mesh_order[n];
  return machine;
}

void check_materials(const Model& model, const Stage& stage, bool transient) {
  Complaints complaints;
  const std::string needed_by = ", needed by stage '" + stage.name + "'";
  for (const Material* m : materials_by_region(model)) {
    if (!m->conductivity)
      complaints.add(m->where, "material '" + m->name + "': missing 'conductivity' [W/(m K)]" + needed_by);
    if (transient && !m->heat_capacity)
      complaints.add(m->where, "material '" + m->name + "': missing 'heat_capacity' [J/(kg K)]" + needed_by);
  }
  complaints.raise();
}

/// Loads the boundary of the stage into the backend; held nodes take their temperature at once.
/// Returns [mesh nodes, the machine's order] 1 where held.
/// @param open see heat_links
std::vector<double> set_boundary(const Problem& problem, Backend& backend, const ThermalBoundary& boundary,
                                 const std::vector<double>& open) {
  const std::vector<int>& new_node = problem.discretisation.heat.new_node;
  std::vector<double> temperature = backend.read(Field::temperature), held(new_node.size(), 0);
  for (std::size_t i = 0; i < boundary.fixed_nodes.size(); ++i) {
    const int n = new_node[boundary.fixed_nodes[i]];
    held[n] = 1;
    temperature[n] = boundary.fixed_temperature[i];
  }
  backend.write(Field::held, held);
  backend.write(Field::temperature, temperature);
  backend.write(Field::heat, to_machine(problem, boundary.heat));
  backend.write_films(
      film_matrix(boundary.films, heat_links(problem.model, problem.blocks, problem.contacts, open), new_node));
  backend.run(Phase::heat_bound);
  return held;
}

/// Size of the rounding errors in the heat balance of the nodes, W: below it a residual says nothing.
double rounding_of_balance(Backend& backend) {
  const std::vector<double> bound = backend.read(Field::heat_bound), temperature = backend.read(Field::temperature);
  double largest = 0, sum = 0;
  for (const double t : temperature) largest = std::max(largest, std::abs(t));
  for (std::size_t n = 0; n < temperature.size(); ++n) sum += bound[2 * n + 1] * bound[2 * n + 1];
  return backend.rounding() * largest * std::sqrt(sum);
}

ThermalResult solve_steady(Problem& problem, const ThermalSolve& solve, const ThermalWatch& watch) {
  Backend& backend = *problem.backend;
  const long limit = 1000 + 2L * problem.discretisation.heat.node_count;
  const double rounding = rounding_of_balance(backend);
  ThermalResult result;
  double start = 0, last = std::numeric_limits<double>::infinity();
  // The residual that conjugate gradients carry along drifts from the true one: begin again from the true one until
  // that meets the tolerance or rounding keeps it from falling.
  for (;;) {
    backend.run(Phase::heat_flow);
    backend.run(Phase::start_search);
    HeatMeasure m = backend.heat_sums();
    if (result.steps == 0) start = m.residual;
    result.ratio = start > 0 ? m.residual / start : 0;
    if (!std::isfinite(m.residual)) {
      result.stop_reason = "not finite";
      return result;
    }
    const double goal = std::max(solve.tolerance * start, rounding);
    if (m.residual <= goal) {
      result.converged = true;
      result.stop_reason = "converged";
      return result;
    }
    if (m.residual > 0.5 * last) {
      result.stop_reason = "precision limit";
      return result;
    }
    last = m.residual;
    while (m.residual > goal) {
      if (result.steps >= limit) {
        result.stop_reason = "step limit";
        return result;
      }
      Controls controls;
      backend.run(Phase::search_flow);
      const double along = backend.heat_sums().along;
      if (!(along > 0)) break;  // the direction vanished in rounding, or is not finite
      const double before = m.preconditioned;
      controls.search_length = before / along;
      backend.run(Phase::advance_search, controls);
      m = backend.heat_sums();
      controls.search_keep = m.preconditioned / before;
      backend.run(Phase::turn_search, controls);
      result.ratio = m.residual / start;
      ++result.steps;
      const double done = std::log(std::max(result.ratio, solve.tolerance)) / std::log(solve.tolerance);
      if (watch && watch({result.steps, std::clamp(done, 0.0, 1.0), 0, result.ratio})) {
        result.interrupted = true;
        result.stop_reason = "interrupted";
        return result;
      }
    }
  }
}

/// Half the stability limit of forward Euler, from Gershgorin's bound of the fastest rate: no step makes a new
/// extremum.
double largest_step(Backend& backend, const std::vector<double>& held, const std::vector<double>& capacity) {
  const std::vector<double> bound = backend.read(Field::heat_bound);
  double step = std::numeric_limits<double>::infinity();
  for (std::size_t n = 0; n < held.size(); ++n)
    if (held[n] == 0 && bound[2 * n + 1] > 0) step = std::min(step, capacity[n] / bound[2 * n + 1]);
  return step;
}

ThermalBoundary boundary_of(const Problem& problem, const std::vector<ActingCondition>& acting) {
  const Mesh& mesh = problem.model.mesh;
  return thermal_boundary(mesh, mesh.corners, mesh.node_count(), acting);
}

/// The boundary of a stage at its beginning; films at their largest, for the step that they allow.
ThermalBoundary first_boundary(const Problem& problem, int stage) {
  const StageTimes times = stage_times(problem.model)[stage];
  return boundary_of(problem, acting_conditions(problem.model, stage, [&](const InTime& number) {
    return number.key == "film" ? largest(number.table, times) : number.table.at(times.begin);
  }));
}

}  // namespace

/// What the boundary gives and takes as time goes on.
struct HeatMarch::BoundaryInTime {
  TimeParts heat, film, given;
  double begin;  ///< s, of the stage

  BoundaryInTime(const Problem& problem, Backend& backend, int stage, const std::vector<double>& open)
      : heat(problem.model, stage, backend, Field::heat,
             [&](const auto& acting) { return to_machine(problem, boundary_of(problem, acting).heat); }),
        film(problem.model, stage, backend, Field::film,
             [&, links = heat_links(problem.model, problem.blocks, problem.contacts, open)](const auto& acting) {
               const std::vector<int>& new_node = problem.discretisation.heat.new_node;
               return film_matrix(boundary_of(problem, acting).films, links, new_node).value;
             }),
        given(problem.model, stage, backend, Field::given_temperature,
              [&](const auto& acting) {
                const ThermalBoundary boundary = boundary_of(problem, acting);
                std::vector<double> temperature(problem.model.mesh.node_count(), 0.0);
                for (std::size_t i = 0; i < boundary.fixed_nodes.size(); ++i)
                  temperature[boundary.fixed_nodes[i]] = boundary.fixed_temperature[i];
                return to_machine(problem, temperature);
              }),
        begin(stage_times(problem.model)[stage].begin) {}

  bool changing() const { return heat.changing() || film.changing() || given.changing(); }
  /// For the step from `time` to `time + step`, s since the stage began.
  void set(double time, double step) {
    heat.set(begin + time + step / 2);
    film.set(begin + time + step / 2);
    given.set(begin + time + step);
  }
};

HeatMarch::HeatMarch(const Problem& problem, Backend& backend, int stage)
    : problem_(problem), backend_(backend), stage_(stage) {
  const Model& model = problem.model;
  check_materials(model, model.stages[stage], true);
  const std::vector<double> held = set_boundary(problem, backend, first_boundary(problem, stage), {});
  const Mesh& mesh = model.mesh;
  std::vector<double> capacity = to_machine(problem, lumped_capacity(model, mesh.corners, mesh.node_count()));
  longest_ = std::min({largest_step(backend, held, capacity), duration_of(model.stages[stage]) / least_steps,
                       shortest_period(model, stage) / steps_of_period});
  for (double& c : capacity) c = 1 / c;
  backend.write(Field::inverse_capacity, capacity);
  open_joints(open_to_heat(problem));
}

void HeatMarch::open_joints(const std::vector<double>& open) {
  if (boundary_ && open == open_) return;
  open_ = open;
  boundary_.reset();  // which takes its parts from the machine
  const std::vector<HeatLink> links = heat_links(problem_.model, problem_.blocks, problem_.contacts, open);
  backend_.write(
      Field::film,
      film_matrix(first_boundary(problem_, stage_).films, links, problem_.discretisation.heat.new_node).value);
  boundary_ = std::make_unique<BoundaryInTime>(problem_, backend_, stage_, open);
}

HeatMarch::~HeatMarch() = default;

ThermalSteps HeatMarch::steps(double from, double to) const {
  const long count = static_cast<long>(std::ceil((to - from) / longest_));
  return {count, (to - from) / static_cast<double>(count)};
}

ThermalResult HeatMarch::march(double from, double to, const ThermalWatch& watch, long done) {
  const ThermalSteps steps = this->steps(from, to);
  ThermalResult result;
  result.steps = done;
  Controls controls;
  controls.time_step = result.time_step = steps.length;
  while (result.steps < steps.count) {
    boundary_->set(from + static_cast<double>(result.steps) * steps.length, steps.length);
    const int together =
        boundary_->changing() ? 1 : static_cast<int>(std::min(steps_between_looks, steps.count - result.steps));
    backend_.march_heat(controls, together);
    result.steps += together;
    const double fraction = static_cast<double>(result.steps) / static_cast<double>(steps.count);
    if (watch && watch({result.steps, fraction, from + fraction * (to - from), 0})) {
      result.interrupted = true;
      result.stop_reason = "interrupted";
      return result;
    }
  }
  for (const double t : backend_.read(Field::temperature))
    if (!std::isfinite(t)) {
      result.stop_reason = "not finite";
      return result;
    }
  result.converged = true;
  result.stop_reason = "converged";
  return result;
}

void prescribe_temperature(const Model& model, int stage, std::vector<double>& temperature) {
  const Mesh& mesh = model.mesh;
  const double time = stage_times(model)[stage].begin;
  for (const ActingCondition& a : acting_conditions(model, stage)) {
    const Condition now = with_numbers(*a.condition, [&](const InTime& number) { return number.table.at(time); });
    if (const auto* field = std::get_if<TemperatureField>(&now.kind))
      for (int n = 0; n < mesh.node_count(); ++n) temperature[n] = field->value(mesh.points[n]);
    const auto* initial = std::get_if<InitialTemperature>(&a.condition->kind);
    if (!initial || !first_acts(model, stage, *a.condition)) continue;
    std::vector<char> chosen(mesh.node_count(), initial->regions.empty());
    for (const std::string& region : initial->regions) {
      const int r = mesh.find_region(region);
      if (r < 0) throw DeckError(a.condition->where, a.condition->noun + ": there is no region '" + region + "'");
      for (int e = 0; e < mesh.element_count(); ++e)
        if (mesh.regions[e] == r)
          for (const int n : mesh.element(e)) chosen[n] = 1;
    }
    for (int n = 0; n < mesh.node_count(); ++n)
      if (chosen[n]) temperature[n] = initial->value(mesh.points[n]);
  }
}

std::vector<double> read_temperature(const Problem& problem) {
  const std::vector<int>& new_node = problem.discretisation.heat.new_node;
  const std::vector<double> machine = problem.backend->read(Field::temperature);
  std::vector<double> mesh_order(machine.size());
  for (std::size_t n = 0; n < new_node.size(); ++n) mesh_order[n] = machine[new_node[n]];
  return mesh_order;
}

void write_temperature(const Problem& problem, Backend& backend, const std::vector<double>& temperature) {
  backend.write(Field::temperature, to_machine(problem, temperature));
}

namespace {

/// Throws DeckError: nothing ties the steady stage to a temperature.
void set_up_steady(Problem& problem, int stage_index) {
  const Stage& stage = problem.model.stages[stage_index];
  check_materials(problem.model, stage, false);
  const ThermalBoundary boundary = first_boundary(problem, stage_index);
  if (boundary.fixed_nodes.empty() && boundary.films.empty())
    throw DeckError(stage.where, "stage '" + stage.name +
                                     "': a steady temperature needs a fixed_temperature or a convection somewhere; "
                                     "without one every level of temperature is in balance");
  set_boundary(problem, *problem.backend, boundary, open_to_heat(problem));
}

}  // namespace

ThermalSteps thermal_steps(Problem& problem, int stage) {
  const auto& solve = std::get<ThermalSolve>(problem.model.stages[stage].solve);
  if (!solve.steady) return HeatMarch(problem, *problem.backend, stage).steps(0, solve.duration);
  set_up_steady(problem, stage);
  return {};
}

ThermalResult solve_thermal(Problem& problem, int stage, const ThermalWatch& watch, const ThermalResume& resume) {
  const auto& solve = std::get<ThermalSolve>(problem.model.stages[stage].solve);
  if (!solve.steady) {
    HeatMarch heat(problem, *problem.backend, stage);
    return heat.march(0, solve.duration, watch, resume ? resume() : 0);
  }
  set_up_steady(problem, stage);
  if (resume) resume();
  return solve_steady(problem, solve, watch);
}

}  // namespace ashlar
