#include "solve/problem.hpp"

#include <omp.h>

#include <algorithm>

#include "physics/interface_laws/interface_laws.hpp"

namespace ashlar {

namespace {

std::vector<int> material_indices(const Model& model) {
  std::vector<int> indices;
  for (const Material* material : materials_by_region(model))
    indices.push_back(static_cast<int>(material - model.materials.data()));
  return indices;
}

/// Two lanes beside each other share the cores, unless told.
int threads_of_lane(const RunOptions& options) {
  return options.threads == 0 && options.heat_device ? std::max(1, omp_get_num_procs() / 2) : options.threads;
}

}  // namespace

Problem::Problem(const Model& m, const RunOptions& options)
    : model(m),
      blocks(split_blocks(m, find_faces(m.mesh))),
      contacts(place_contacts(m, blocks)),
      discretisation(
          discretise(m.mesh, blocks, material_indices(m), patch_slots(static_cast<int>(m.mesh.corners.size()), options.precision))),
      surface(has_large_displacement(m) ? contact_surface(m, blocks, discretisation) : ContactSurface{}),
      initial(initial_state(m, blocks, setup())),
      backend(make_backend(setup(), options.precision, options.device, threads_of_lane(options), options.memory)) {
  if (!initial.history.empty()) backend->write(Field::history, initial.history);
  for (const Stage& stage : m.stages)
    if (std::holds_alternative<CoupledSolve>(stage.solve) && !heat_lane)
      heat_lane = std::make_unique<Lane>(
          [&] {
            return make_backend(heat_setup(), options.precision, options.heat_device.value_or(options.device),
                                threads_of_lane(options), options.memory);
          },
          options.heat_device.has_value());
}

Setup Problem::setup() const {
  Setup setup{discretisation, contacts};
  for (const Material& m : model.materials) {
    setup.laws.push_back(make_block_law(m.law, m.values));
    setup.bbar.push_back(m.bbar ? (*m.bbar ? 2 : 0) : averages_tet4(m.law) ? 2 : is_plastic(m.law) ? 1 : 0);
    setup.conductivity.push_back(m.conductivity.value_or(0));
  }
  setup.surface = &surface;
  setup.reference_temperature = model.reference_temperature;
  for (const Stage& stage : model.stages)
    setup.motion = setup.motion || std::holds_alternative<DynamicSolve>(stage.solve);
  for (const Condition& c : model.conditions)
    setup.crack_water = setup.crack_water || std::holds_alternative<CrackWater>(c.kind);
  for (const Interface& i : model.interfaces) {
    const std::string what = std::string(i.crackable ? "crackable" : "joint") + " '" + i.name + "'";
    setup.interface_laws.push_back(interface_constants(i.law, i.values, i.where, what).law);
  }
  return setup;
}

Vec3<double> Problem::place_of_contact(int contact) const {
  if (contact < contacts.pair_count())
    return discretisation.block_points[discretisation.blocks.new_node[contacts.node_a[contact]]];
  Vec3<double> place;
  contacts.each_end(contact, [&](int node, double weight) {
    if (weight < 0) place = place - weight * model.mesh.points[blocks.mesh_node[node]];
  });
  return place;
}

Setup Problem::heat_setup() const {
  static const ContactPoints none;
  const Setup all = setup();
  return {.discretisation = discretisation,
          .contacts = none,
          .laws = all.laws,
          .bbar = all.bbar,
          .interface_laws = {},
          .conductivity = all.conductivity,
          .reference_temperature = all.reference_temperature,
          .heat_only = true,
          .motion = false,
          .crack_water = false,
          .surface = nullptr};
}

std::vector<double> Problem::to_machine(const std::vector<double>& block_order, int width) const {
  std::vector<double> machine(block_order.size());
  const std::vector<int>& new_node = discretisation.blocks.new_node;
  for (std::size_t n = 0; n < new_node.size(); ++n)
    for (int c = 0; c < width; ++c) machine[width * new_node[n] + c] = block_order[width * n + c];
  return machine;
}

std::vector<double> Problem::to_blocks(const std::vector<double>& machine_order, int width) const {
  std::vector<double> block(machine_order.size());
  const std::vector<int>& new_node = discretisation.blocks.new_node;
  for (std::size_t n = 0; n < new_node.size(); ++n)
    for (int c = 0; c < width; ++c) block[width * n + c] = machine_order[width * new_node[n] + c];
  return block;
}

}  // namespace ashlar
