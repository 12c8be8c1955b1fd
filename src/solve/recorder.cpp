#include "solve/recorder.hpp"

#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "model/in_time.hpp"
#include "model/loads.hpp"
#include "solve/block_state.hpp"
#include "solve/contact_states.hpp"
#include "solve/crack_events.hpp"
#include "solve/stress_output.hpp"

namespace ashlar {

namespace {

constexpr const char* stress_components[6] = {"xx", "yy", "zz", "xy", "yz", "zx"};
constexpr const char* dissipation_parts[] = {"plastic", "fracture", "opening", "shear", "friction"};
constexpr const char* energy_parts[5] = {"kinetic", "strain", "dissipated", "external_work", "error"};
constexpr const char* axes[3] = {"x", "y", "z"};

Location point_of(const Mesh& mesh, const History& history) {
  const auto found = locate(mesh, *history.at);
  if (found) return *found;
  const Vec3<double> near = mesh.points[nearest_node(mesh, *history.at)];
  char text[200];
  std::snprintf(text, sizeof text,
                "history '%s': (%.6g, %.6g, %.6g) is outside the body; the nearest node is at (%.9g, %.9g, %.9g)",
                history.name.c_str(), history.at->x, history.at->y, history.at->z, near.x, near.y, near.z);
  throw DeckError(history.where, text);
}

bool finite(const std::vector<double>& values) {
  for (const double v : values)
    if (!std::isfinite(v)) return false;
  return true;
}

}  // namespace

Recorder::Recorder(const Problem& problem, Observer& observer) : problem_(problem), observer_(observer) {
  reference_displacement_.assign(3 * static_cast<std::size_t>(problem.blocks.node_count()), 0);
  surface_load_ = reference_displacement_;
  for (const StageTimes& times : stage_times(problem.model)) timed_ = timed_ || times.end > times.begin;
  for (const History& h : problem.model.histories) {
    Probe probe{&h, {}, {}};
    if (h.at) {
      probe.location = point_of(problem.model.mesh, h);
    } else if (!h.surface.empty()) {
      const Surface* surface = problem.model.mesh.find_surface(h.surface);
      if (!surface) throw DeckError(h.where, "history '" + h.name + "': no surface is called '" + h.surface + "'");
      probe.nodes = surface_nodes(problem.model.mesh, problem.blocks.corners, *surface);
    }
    HistoryTable table;
    table.name = h.name;
    if (timed_) {
      table.columns.push_back("seconds");
      table.units.push_back("s");
    }
    add_columns(probe, table);
    tables_.push_back(std::move(table));
    probes_.push_back(std::move(probe));
  }
}

void Recorder::add_columns(const Probe& probe, HistoryTable& table) const {
  const auto vector = [&](const std::string& name, const char* unit) {
    for (const char* axis : axes) {
      table.columns.push_back(name + "." + axis);
      table.units.push_back(unit);
    }
  };
  for (const std::string& record : probe.history->record) {
    const bool at_point = probe.history->at.has_value();
    const bool on_surface = !at_point && !probe.history->surface.empty();
    if (at_point && record == "displacement") {
      vector(record, "m");
    } else if (at_point && record == "velocity") {
      vector(record, "m/s");
    } else if (!at_point && !on_surface && record == "energy") {
      for (const char* part : energy_parts) {
        table.columns.push_back(record + "." + part);
        table.units.push_back("J");
      }
    } else if (!at_point && !on_surface && record == "dissipation") {
      for (const char* part : dissipation_parts) {
        table.columns.push_back(record + "." + part);
        table.units.push_back("J");
      }
    } else if (!at_point && !on_surface && record == "cracked_area") {
      table.columns.push_back(record);
      table.units.push_back("m^2");
    } else if (at_point && record == "temperature") {
      table.columns.push_back(record);
      table.units.push_back("degC");
    } else if (at_point && (record == "stress" || record == "nodal_stress")) {
      for (const char* c : stress_components) {
        table.columns.push_back(record + "." + c);
        table.units.push_back("Pa");
      }
    } else if (at_point && (record == "plastic_strain" || record == "damage")) {
      table.columns.push_back(record);
      table.units.push_back("1");
    } else if (on_surface && (record == "reaction" || record == "load")) {
      vector(record, "N");
    } else if (on_surface && record == "load_moment") {
      vector(record, "N m");
    } else {
      throw DeckError(probe.history->where,
                      "history '" + probe.history->name + "': cannot record '" + record + "' " +
                          (at_point     ? "at a point; valid: displacement, velocity, temperature, stress, "
                                          "nodal_stress, plastic_strain, damage"
                           : on_surface ? "on a surface; valid: reaction, load, load_moment"
                                        : "of the whole model; valid: energy, dissipation, cracked_area"));
    }
  }
}

std::vector<double> Recorder::displacement() const {
  return problem_.to_blocks(problem_.backend->read(Field::displacement), 3);
}

void Recorder::exchange(Exchange& e) {
  e("recorder.reference_displacement", reference_displacement_);
  e("recorder.surface_load", surface_load_);
  e("recorder.temperature", temperature_);
  e("recorder.velocity", velocity_);
  e("recorder.energy", energy_);
  for (HistoryTable& table : tables_) e("history", table.rows);
}

void Recorder::reset_displacement() { reference_displacement_ = displacement(); }

/// Mean over the copies of a node, or interpolated in an element. `field` [components * block nodes], Blocks order.
std::vector<double> Recorder::at_point(const Probe& probe, const std::vector<double>& field, int components) const {
  const Blocks& blocks = problem_.blocks;
  std::vector<double> value(components);
  const auto add = [&](double weight, int n) {
    for (int c = 0; c < components; ++c) value[c] += weight * field[static_cast<std::size_t>(components) * n + c];
  };
  if (const int n = probe.location.node; n >= 0) {
    const int copies = blocks.first_copy[n + 1] - blocks.first_copy[n];
    for (int copy = blocks.first_copy[n]; copy < blocks.first_copy[n + 1]; ++copy) add(1.0 / copies, copy);
  } else {
    for (std::size_t k = 0; k < probe.location.weights.size(); ++k)
      add(probe.location.weights[k], blocks.corners[problem_.model.mesh.first_corner[probe.location.element] + k]);
  }
  return value;
}

void Recorder::add_values(const Probe& probe, std::vector<double>& row) {
  const Mesh& mesh = problem_.model.mesh;
  const Blocks& blocks = problem_.blocks;
  Backend& backend = *problem_.backend;
  for (const std::string& record : probe.history->record) {
    if (record == "displacement") {
      std::vector<double> u = displacement();
      for (std::size_t i = 0; i < u.size(); ++i) u[i] -= reference_displacement_[i];
      const std::vector<double> value = at_point(probe, u, 3);
      row.insert(row.end(), value.begin(), value.end());
    } else if (record == "velocity") {
      const std::vector<double> value = velocity_.empty() ? std::vector<double>(3) : at_point(probe, velocity_, 3);
      row.insert(row.end(), value.begin(), value.end());
    } else if (record == "energy") {
      row.insert(row.end(),
                 {energy_.kinetic, energy_.strain, energy_.dissipated, energy_.external_work, energy_.error});
    } else if (record == "temperature") {
      double value = temperature_.empty() ? problem_.model.reference_temperature : 0;
      if (!temperature_.empty())
        for (std::size_t k = 0; k < probe.location.weights.size(); ++k)
          value += probe.location.weights[k] * temperature_[mesh.element(probe.location.element)[k]];
      row.push_back(value);
    } else if (record == "stress") {
      const std::vector<double> stress = element_stress(problem_, gauss_stress(problem_));
      for (int c = 0; c < 6; ++c) row.push_back(stress[6 * static_cast<std::size_t>(probe.location.element) + c]);
    } else if (record == "nodal_stress") {
      const std::vector<double> value = at_point(probe, nodal_stress(problem_, gauss_stress(problem_)), 6);
      row.insert(row.end(), value.begin(), value.end());
    } else if (record == "plastic_strain") {
      row.push_back(element_measure(problem_, Measure::plastic_strain)[probe.location.element]);
    } else if (record == "damage") {
      row.push_back(element_measure(problem_, Measure::damage)[probe.location.element]);
    } else if (record == "dissipation") {
      const BlockWork work = block_work(problem_);
      const Dissipation<double>& lost = lost_by_contacts_;
      row.insert(row.end(), {work.plastic, work.fracture, lost.opening, lost.shear, lost.friction});
    } else if (record == "cracked_area") {
      StageResult now;
      CrackEvents(problem_).fill_areas(now);
      row.push_back(now.cracked_area);
    } else if (record == "reaction") {
      // What the supports hold: internal force less load on held components.
      std::vector<double> support = problem_.to_blocks(backend.read(Field::force), 3);
      const std::vector<double> load = problem_.to_blocks(backend.read(Field::load), 3);
      const std::vector<double> fixed = problem_.to_blocks(backend.read(Field::fixed), 1);
      Vec3<double> sum;
      for (const int n : probe.nodes)
        for (int c = 0; c < 3; ++c)
          if ((static_cast<unsigned>(fixed[n]) >> c) & 1u) sum[c] += support[3 * n + c] - load[3 * n + c];
      for (int c = 0; c < 3; ++c) row.push_back(sum[c]);
    } else {
      std::vector<Vec3<double>> points;
      for (const int m : blocks.mesh_node) points.push_back(mesh.points[m]);
      const Resultant r = resultant(points, surface_load_, probe.nodes);
      const Vec3<double>& v = record == "load" ? r.force : r.moment;
      for (int c = 0; c < 3; ++c) row.push_back(v[c]);
    }
  }
}

void Recorder::history_rows(const Moment& moment) {
  for (std::size_t h = 0; h < probes_.size(); ++h) {
    HistoryTable::Row row{problem_.model.stages[moment.stage].name, moment.time, moment.load_factor, {}, moment.balanced};
    if (timed_) row.values.push_back(moment.seconds);
    add_values(probes_[h], row.values);
    tables_[h].rows.push_back(std::move(row));
    observer_.history_row(tables_[h]);
  }
}

void Recorder::snapshot(const Moment& moment) {
  Snapshot s;
  s.stage = problem_.model.stages[moment.stage].name;
  s.stage_number = moment.stage + 1;
  s.time = moment.time;
  s.load_factor = moment.load_factor;
  s.stage_end = moment.stage_end;
  s.balanced = moment.balanced;
  s.displacement = displacement();
  for (std::size_t i = 0; i < s.displacement.size(); ++i) s.displacement[i] -= reference_displacement_[i];
  if (!temperature_.empty())
    for (const int n : problem_.blocks.mesh_node) s.temperature.push_back(temperature_[n]);
  if (finite(s.displacement)) {
    const std::vector<double> gauss = gauss_stress(problem_);
    s.stress = element_stress(problem_, gauss);
    s.nodal_stress = nodal_stress(problem_, gauss);
    s.principal_stress = principal_stress(s.stress);
    s.plastic_strain = element_measure(problem_, Measure::plastic_strain);
    s.damage = element_measure(problem_, Measure::damage);
    s.crack_normal = element_crack_normal(problem_);
  }
  if (problem_.contacts.count() > 0) {
    // Blocks that move far leave the contact points behind, which then bear nothing.
    const auto* motion = std::get_if<DynamicSolve>(&problem_.model.stages[moment.stage].solve);
    const std::vector<ContactPoint> points = motion && motion->large_displacement
                                                 ? std::vector<ContactPoint>(problem_.contacts.count())
                                                 : ContactReader(problem_).read();
    fill_contact_fields(points, problem_.contacts.opening, s);
  }
  observer_.output(s);
}

std::string HistoryTable::not_in_balance(const std::string& stage) const {
  return "history '" + name + "': the end of stage '" + stage + "' is not in balance, for the stage failed";
}

std::size_t HistoryTable::index_of(const std::string& column) const {
  std::size_t index = 0;
  while (index < columns.size() && columns[index] != column) ++index;
  if (index == columns.size()) {
    std::string valid;
    for (const auto& c : columns) valid += (valid.empty() ? "" : ", ") + c;
    throw std::out_of_range("history '" + name + "' has no column '" + column + "'; it has " + valid);
  }
  return index;
}

double HistoryTable::at(const std::string& column, const std::string& stage) const {
  const std::size_t index = index_of(column);
  for (auto row = rows.rbegin(); row != rows.rend(); ++row)
    if (stage.empty() || row->stage == stage) {
      if (!row->balanced) throw std::out_of_range(not_in_balance(row->stage));
      return row->values[index];
    }
  throw std::out_of_range("history '" + name + "' has no row of stage '" + stage + "'");
}

std::vector<double> HistoryTable::values(const std::string& column, const std::string& stage) const {
  const std::size_t index = index_of(column);
  std::vector<double> values;
  bool failed = false;
  for (const Row& row : rows) {
    if (!stage.empty() && row.stage != stage) continue;
    if (row.balanced) values.push_back(row.values[index]);
    failed = failed || !row.balanced;
  }
  if (values.empty())
    throw std::out_of_range(failed ? not_in_balance(stage) : "history '" + name + "' has no row of stage '" + stage + "'");
  return values;
}

}  // namespace ashlar
