#pragma once
#include <optional>
#include <string>
#include <vector>

#include "io/grid_file.hpp"
#include "model/blocks.hpp"
#include "solve/observer.hpp"

namespace ashlar {

/// What `record` of an output may name, and the arrays that each name writes:
///   displacement      results: displacement [m] per node;  interfaces: displacement [m] per corner, mean of both sides
///   temperature       results: temperature [degC] per node; the reference temperature until a stage has computed one
///   stress            results: stress [Pa] per element and nodal_stress [Pa] per node, components xx yy zz xy yz zx
///   plastic_strain    results: equivalent plastic strain per element
///   principal_stress  results: principal_stress [Pa] per element, most tensile first
///   opening, slip     interfaces: [m] per corner
///   traction          interfaces: normal_traction (tension positive) and shear_traction (magnitude) [Pa] per corner
///   broken            interfaces: state per corner, 0 intact, 1 cracked in tension, 2 cracked in shear
const std::vector<std::string>& recordable_names();

/// Every name that the model's outputs record, each once. A model without an output records everything.
std::vector<std::string> recorded_names(const Model& model);

/// The fields of a run: results.vtkhdf and .xdmf with the block nodes and the mesh's elements (cell arrays region and
/// block), and, if the model has interfaces and a field of theirs is recorded, interfaces.vtkhdf and .xdmf with one
/// polygon for every entry of Blocks::faces (cell array interface). Polygons share no points: point i is contact point
/// i.
class ResultFile {
 public:
  /// Creates the files in `folder`, or goes on with those that are there behind their first `keep` outputs. `program`
  /// ("ashlar 0.1.0") is written into them. Model and contacts outlive it.
  ResultFile(const std::string& folder, const std::string& program, const Model& model, const Blocks& blocks,
             const ContactPoints& contacts, std::size_t keep = 0);

  /// The files' time axis is the snapshot's time: stages done, with the fraction of the present one.
  /// Before the first mechanical stage (a snapshot without displacement) mechanical fields are zero; in a state that is
  /// not finite, fields that the solver left out are not-a-number. Throws std::logic_error if another recorded field is
  /// missing in the snapshot or has the wrong size.
  void append(const Snapshot& snapshot);

  std::size_t count() const { return results_.steps().size(); }
  std::vector<std::string> file_names() const;

 private:
  const Model& model_;
  const ContactPoints& contacts_;
  std::size_t node_count_;
  std::vector<std::string> result_arrays_, interface_arrays_;
  GridFile results_;
  std::optional<GridFile> interfaces_;
  double last_time_ = -1;
};

}  // namespace ashlar
