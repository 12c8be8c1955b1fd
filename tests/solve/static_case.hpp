#pragma once
#include <memory>

#include "model/conditions.hpp"
#include "model/loads.hpp"
#include "solve/fracture.hpp"
#include "solve/virtual_mass.hpp"

/// One static or fracture stage on a model built by hand, without the deck and the staging around it.
namespace ashlar::test {

class StaticCase {
 public:
  explicit StaticCase(const Model& model, Relaxation relaxation)
      : model_(model),
        problem_(model, {.threads = 1}),
        relaxation_(relaxation),
        fixed_(problem_.blocks.node_count()),
        load_(3 * problem_.blocks.node_count()) {
  }

  Problem& problem() { return problem_; }
  const std::vector<double>& load() const { return load_; }

  /// Holds components (bits 0 1 2: x y z) of the nodes of a surface.
  void fix(const std::string& surface, int components) {
    for (const int n : surface_nodes(model_.mesh, problem_.blocks.corners, *model_.mesh.find_surface(surface)))
      fixed_[n] = static_cast<int>(fixed_[n]) | components;
    problem_.backend->write(Field::fixed, problem_.to_machine(fixed_, 1));
  }
  void gravity(const Vec3<double>& g) {
    add_gravity(model_, problem_.blocks.corners, g, load_);
    write_load(1);
  }
  void pressure(const std::string& surface, const Vec3<double>& traction) {
    Traction t;
    t.x.constant = traction.x, t.y.constant = traction.y, t.z.constant = traction.z;
    add_traction(model_.mesh, problem_.blocks.corners, *model_.mesh.find_surface(surface), t, load_);
    write_load(1);
  }
  void write_load(double factor) {
    auto scaled = load_;
    for (double& f : scaled) f *= factor;
    problem_.backend->write(Field::load, problem_.to_machine(scaled, 3));
  }
  /// The same temperature above the reference everywhere, K.
  void warm(double warming) {
    problem_.backend->use_warming(true);
    problem_.backend->write(Field::warming, std::vector<double>(problem_.backend->size(Field::warming), warming));
  }

  FractureLinks links() {
    FractureLinks links;
    links.relax = [this](const RelaxationWatch& watch) {
      set_virtual_mass(problem_, *problem_.backend, relaxation_);
      return relax(*problem_.backend, relaxation_, thermal_load_norm(*problem_.backend), watch);
    };
    return links;
  }
  /// [3 * block nodes] in the order of Blocks, m.
  std::vector<double> displacement() { return problem_.to_blocks(problem_.backend->read(Field::displacement), 3); }
  /// Mean over the copies of a mesh node.
  Vec3<double> displacement_of(int mesh_node) {
    const auto u = displacement();
    Vec3<double> sum;
    const int first = problem_.blocks.first_copy[mesh_node], last = problem_.blocks.first_copy[mesh_node + 1];
    for (int copy = first; copy < last; ++copy) sum = sum + Vec3<double>{u[3 * copy], u[3 * copy + 1], u[3 * copy + 2]};
    return (1.0 / (last - first)) * sum;
  }

 private:
  const Model& model_;
  Problem problem_;
  Relaxation relaxation_;
  std::vector<double> fixed_, load_;
};

}  // namespace ashlar::test
