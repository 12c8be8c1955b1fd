#pragma once
#include <vector>

#include "model/model.hpp"

namespace ashlar {

/// The initial stress of the model as a field (numerics 4).
class InitialStressField {
 public:
  /// Throws DeckError: a region that does not exist or that two declarations name.
  explicit InitialStressField(const Model& model);
  bool any() const { return !model_.initial_stresses.empty(); }
  /// Stress at `p` in a mesh region, Pa; zero where none is given.
  Sym3<double> at(int region, const Vec3<double>& p) const;

 private:
  const Model& model_;
  std::vector<int> of_region_;   ///< [mesh regions] index into Model::initial_stresses, -1: none
  std::vector<double> density_;  ///< [mesh regions] kg/m^3
};

}  // namespace ashlar
