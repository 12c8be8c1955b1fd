#include "io/result_file.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <map>
#include <stdexcept>

#include "physics/interface_laws/softening.hpp"
#include "physics/laws/laws.hpp"

namespace ashlar {

namespace {

const std::vector<std::string> tensor{"xx", "yy", "zz", "xy", "yz", "zx"};

/// An array of the result files: the name that records it, and where the snapshot has it.
struct Field {
  std::string record;
  GridArray array;
  std::vector<double> Snapshot::*values;
};

using Type = GridArray::Type;
const std::vector<Field> result_fields{
    {"displacement", {"displacement", true, 3, Type::real, "m", {"x", "y", "z"}}, &Snapshot::displacement},
    {"temperature", {"temperature", true, 1, Type::real, "degC"}, &Snapshot::temperature},
    {"stress", {"nodal_stress", true, 6, Type::real, "Pa", tensor}, &Snapshot::nodal_stress},
    {"stress", {"stress", false, 6, Type::real, "Pa", tensor}, &Snapshot::stress},
    {"principal_stress",
     {"principal_stress", false, 3, Type::real, "Pa", {"largest", "middle", "smallest"}},
     &Snapshot::principal_stress},
    {"plastic_strain", {"plastic_strain", false, 1, Type::real, ""}, &Snapshot::plastic_strain},
    {"damage", {"damage", false, 1, Type::real, ""}, &Snapshot::damage},
    {"crack_normal", {"crack_normal", false, 3, Type::real, "", {"x", "y", "z"}}, &Snapshot::crack_normal},
};
const std::vector<Field> interface_fields{
    {"displacement", {"displacement", true, 3, Type::real, "m", {"x", "y", "z"}}, &Snapshot::displacement},
    {"opening", {"opening", true, 1, Type::real, "m"}, &Snapshot::opening},
    {"slip", {"slip", true, 1, Type::real, "m"}, &Snapshot::slip},
    {"traction", {"normal_traction", true, 1, Type::real, "Pa"}, &Snapshot::normal_traction},
    {"traction", {"shear_traction", true, 1, Type::real, "Pa"}, &Snapshot::shear_traction},
    {"broken", {"damage", true, 1, Type::real, ""}, &Snapshot::contact_damage},
};
const Field state_field{
    "broken",
    {"state", true, 1, Type::byte, "", {"intact", "cracked in tension", "cracked in shear", "softening"}},
    nullptr};

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::vector<GridArray> arrays_of(const std::vector<Field>& fields, const std::vector<std::string>& recorded) {
  std::vector<GridArray> arrays;
  for (const auto& field : fields)
    if (contains(recorded, field.record)) arrays.push_back(field.array);
  return arrays;
}

std::vector<GridArray> interface_arrays(const Model& model) {
  const auto recorded = recorded_names(model);
  auto arrays = arrays_of(interface_fields, recorded);
  const bool softens = std::any_of(model.interfaces.begin(), model.interfaces.end(),
                                   [](const Interface& i) { return i.law == SofteningInterface::name; });
  if (!softens) std::erase_if(arrays, [](const GridArray& a) { return a.name == "damage"; });
  if (contains(recorded, state_field.record)) arrays.push_back(state_field.array);
  return arrays;
}

std::vector<std::pair<std::string, std::string>> attributes_of(const std::string& program, const Model& model,
                                                               const char* order) {
  return {{"program", program},
          {"model", model.name},
          {"units", "SI, temperatures in degC, tension and opening positive"},
          {"order", order}};
}

Grid body_grid(const Mesh& mesh, const Blocks& blocks) {
  Grid grid;
  grid.points.reserve(3 * blocks.mesh_node.size());
  for (const int n : blocks.mesh_node)
    grid.points.insert(grid.points.end(), {mesh.points[n].x, mesh.points[n].y, mesh.points[n].z});
  grid.connectivity.assign(blocks.corners.begin(), blocks.corners.end());
  grid.offsets.assign(mesh.first_corner.begin(), mesh.first_corner.end());
  for (const Shape shape : mesh.shapes) grid.types.push_back(static_cast<std::uint8_t>(vtk_cell_type(shape)));
  return grid;
}

/// First contact point of every cell, and their number: a coincident face, a triangle of an overlap.
std::vector<int> cells_of(const ContactPoints& contacts) {
  std::vector<int> first;
  for (int i = 0; i < contacts.count(); ++i) {
    const int overlap_point = i - contacts.pair_count();
    if (overlap_point < 0 ? i == 0 || contacts.face[i] != contacts.face[i - 1] : overlap_point % 3 == 0)
      first.push_back(i);
  }
  first.push_back(contacts.count());
  return first;
}

Grid face_grid(const Mesh& mesh, const Blocks& blocks, const ContactPoints& contacts, const std::vector<int>& cells) {
  Grid grid;
  for (int i = 0; i < contacts.count(); ++i) {
    const bool pair = i < contacts.pair_count();
    const auto& p =
        pair ? mesh.points[blocks.mesh_node[contacts.node_a[i]]] : contacts.corner[i - contacts.pair_count()];
    grid.points.insert(grid.points.end(), {p.x, p.y, p.z});
    grid.connectivity.push_back(i);
  }
  for (std::size_t cell = 0; cell + 1 < cells.size(); ++cell) {
    grid.offsets.push_back(cells[cell + 1]);
    grid.types.push_back(cells[cell + 1] - cells[cell] == 3 ? 5 : 9);
  }
  return grid;
}

GridFile make_results(const std::string& folder, const std::string& program, const Model& model, const Blocks& blocks,
                      std::size_t keep) {
  const Mesh& mesh = model.mesh;
  const GridArray region{"region", false, 1, Type::integer, "", mesh.region_names};
  const GridArray block{"block", false, 1, Type::integer, ""};
  return GridFile(folder, "results", body_grid(mesh, blocks),
                  attributes_of(program, model, "points: nodes of the blocks; cells: elements of the mesh"),
                  {{region, mesh.regions}, {block, blocks.block_of_element}},
                  arrays_of(result_fields, recorded_names(model)), keep);
}

GridFile make_interfaces(const std::string& folder, const std::string& program, const Model& model,
                         const Blocks& blocks, const ContactPoints& contacts, std::size_t keep) {
  GridArray interface { "interface", false, 1, Type::integer, "" };
  for (const auto& declared : model.interfaces) interface.labels.push_back(declared.name);
  const std::vector<int> cells = cells_of(contacts);
  std::vector<int> numbers;
  for (std::size_t cell = 0; cell + 1 < cells.size(); ++cell) numbers.push_back(contacts.interface[cells[cell]]);
  return GridFile(
      folder, "interfaces", face_grid(model.mesh, blocks, contacts, cells),
      attributes_of(
          program, model,
          "cells: coincident faces, then triangles of overlaps; points: their contact points, cell after cell"),
      {{interface, numbers}}, interface_arrays(model), keep);
}

std::vector<std::string> names_of(const std::vector<GridArray>& arrays) {
  std::vector<std::string> names;
  for (const auto& array : arrays) names.push_back(array.name);
  return names;
}

bool finite(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}

/// The values of a snapshot, or what ResultFile::append promises for a field that no stage has computed yet:
/// temperature of a model without heat, everything else before the first mechanical stage.
class Values {
 public:
  explicit Values(const Snapshot& snapshot, double reference_temperature)
      : snapshot_(snapshot), reference_temperature_(reference_temperature) {}

  const std::vector<double>& operator()(const Field& field, std::size_t size) {
    const auto& values = snapshot_.*field.values;
    const bool is_temperature = field.values == &Snapshot::temperature;
    if (values.empty() && (is_temperature || snapshot_.displacement.empty()))
      return filled_.emplace_back(size, is_temperature ? reference_temperature_ : 0.0);
    if (values.empty() && !finite(snapshot_.displacement))
      return filled_.emplace_back(size, std::numeric_limits<double>::quiet_NaN());
    if (values.size() != size)
      throw std::logic_error("output of field '" + field.array.name + "': " + std::to_string(values.size()) +
                             " values in the snapshot, expected " + std::to_string(size));
    return values;
  }

 private:
  const Snapshot& snapshot_;
  double reference_temperature_;
  std::deque<std::vector<double>> filled_;
};

}  // namespace

const std::vector<std::string>& recordable_names() {
  static const std::vector<std::string> names{"displacement",   "temperature", "stress", "principal_stress",
                                              "plastic_strain", "damage",      "crack_normal", "opening",
                                              "slip",           "traction",    "broken"};
  return names;
}

std::vector<std::string> recorded_names(const Model& model) {
  std::vector<std::string> names;
  if (model.outputs.empty()) {
    std::map<std::string, bool> some{{"plastic_strain", false}, {"damage", false}, {"crack_normal", false}};
    for (const auto& material : model.materials) {
      some["plastic_strain"] |= is_plastic(material.law);
      some["damage"] |= measure(material.law) == Measure::damage;
      some["crack_normal"] |= has_crack_plane(material.law);
    }
    for (const auto& name : recordable_names())
      if (!some.contains(name) || some[name]) names.push_back(name);
  }
  for (const auto& output : model.outputs)
    for (const auto& name : output.record) {
      if (!contains(recordable_names(), name))
        throw DeckError(output.where, "output '" + output.name + "': there is no field '" + name + "'");
      if (!contains(names, name)) names.push_back(name);
    }
  return names;
}

ResultFile::ResultFile(const std::string& folder, const std::string& program, const Model& model, const Blocks& blocks,
                       const ContactPoints& contacts, std::size_t keep)
    : model_(model),
      contacts_(contacts),
      node_count_(blocks.mesh_node.size()),
      result_arrays_(names_of(arrays_of(result_fields, recorded_names(model)))),
      interface_arrays_(names_of(interface_arrays(model))),
      results_(make_results(folder, program, model, blocks, keep)) {
  const bool beside_displacement = interface_arrays_.size() > contains(interface_arrays_, "displacement");
  if (!blocks.faces.empty() && beside_displacement)
    interfaces_.emplace(make_interfaces(folder, program, model, blocks, contacts, keep));
  if (count() > 0) last_time_ = results_.steps().back().time;
}

void ResultFile::append(const Snapshot& snapshot) {
  // Two outputs of one time (the last increment and the end of its stage) stay apart and in order.
  last_time_ = snapshot.time > last_time_ ? snapshot.time : last_time_ + 1e-6;
  const GridStep step{last_time_, snapshot.stage, snapshot.stage_number, snapshot.load_factor, snapshot.stage_end,
                      snapshot.balanced};

  Values values(snapshot, model_.reference_temperature);
  std::vector<const void*> data;
  for (const auto& field : result_fields)
    if (contains(result_arrays_, field.array.name)) {
      const std::size_t rows = field.array.on_points ? node_count_ : model_.mesh.shapes.size();
      data.push_back(values(field, rows * field.array.components).data());
    }
  results_.append(step, data);
  if (!interfaces_) return;

  const std::size_t contact_count = contacts_.count();
  std::vector<double> displacement;
  data.clear();
  for (const auto& field : interface_fields) {
    if (!contains(interface_arrays_, field.array.name)) continue;
    if (field.values != &Snapshot::displacement) {
      data.push_back(values(field, contact_count).data());
      continue;
    }
    const auto& u = values(field, 3 * node_count_);
    displacement.assign(3 * contact_count, 0.0);
    for (int i = 0; i < contacts_.count(); ++i)
      contacts_.each_end(i, [&](int node, double weight) {
        for (int c = 0; c < 3; ++c) displacement[3 * i + c] += std::abs(weight) * u[3 * node + c] / 2;
      });
    data.push_back(displacement.data());
  }
  std::vector<std::uint8_t> state = snapshot.contact_state;
  if (state.empty() && snapshot.displacement.empty()) state.assign(contact_count, 0);
  if (contains(interface_arrays_, state_field.array.name)) {
    if (state.size() != contact_count)
      throw std::logic_error("output of field 'state': wrong number of contact points");
    data.push_back(state.data());
  }
  interfaces_->append(step, data);
}

std::vector<std::string> ResultFile::file_names() const {
  auto names = results_.file_names();
  if (interfaces_)
    for (const auto& name : interfaces_->file_names()) names.push_back(name);
  return names;
}

}  // namespace ashlar
