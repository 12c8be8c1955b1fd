#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "backend/device.hpp"
#include "model/blocks.hpp"
#include "model/conditions.hpp"
#include "model/discretisation.hpp"
#include "model/model.hpp"
#include "solve/initial_state.hpp"
#include "solve/lane.hpp"

/// A model made ready to run: blocks split, springs placed, everything in the machine's order.
namespace ashlar {

struct RunOptions {
  Precision precision = Precision::double_precision;
  int threads = 0;  ///< of the CPU; 0: all cores
  DeviceChoice device{DeviceChoice::cpu};      ///< of the stress lane and all that is not coupled
  std::optional<DeviceChoice> heat_device{};  ///< of a heat lane beside it; none: in turns on `device`
  std::size_t memory = 0;  ///< bytes that the machine's arrays may take; 0: what is free
};

struct Problem {
  const Model& model;
  Blocks blocks;
  ContactPoints contacts;
  Discretisation discretisation;
  ContactSurface surface;  ///< empty in models without large displacement
  InitialState initial;
  std::unique_ptr<Backend> backend;
  std::unique_ptr<Lane> heat_lane;  ///< none in models without coupled stages

  /// `model` has its mesh and outlives the problem. Throws DeckError.
  Problem(const Model& model, const RunOptions& options);

  /// Where a contact point lies on its side a, m.
  Vec3<double> place_of_contact(int contact) const;

  /// What any machine's backend is built from, and one of heat alone.
  Setup setup() const;
  Setup heat_setup() const;

  /// Vectors of `width` numbers per block node, between the order of Blocks and the machine's.
  std::vector<double> to_machine(const std::vector<double>& block_order, int width) const;
  std::vector<double> to_blocks(const std::vector<double>& machine_order, int width) const;
};

}  // namespace ashlar
