#pragma once
#include <string>
#include <vector>

#include "physics/laws/laws.hpp"

/// One material point on the standard paths of a laboratory.
namespace ashlar {

struct MaterialState {
  double strain = 0;          ///< axial, or engineering shear
  double stress = 0;          ///< Pa, axial or shear
  double lateral_stress = 0;  ///< Pa
  double volume = 0;          ///< volumetric strain
  double plastic_strain = 0;  ///< equivalent; damage of laws that crack
};
struct MaterialCurve {
  std::string test;
  std::vector<MaterialState> states;  ///< from rest, or from the confined state
};

/// Compression and tension without confinement, compression under each of the pressures, oedometer, simple shear, and a
/// cycle of compression, tension and back. Tension positive.
/// @param confining Pa, positive
/// @param strain how far each goes; 0: four times the strain at first flow, 0.1 % without flow
/// @param size of the block, m, for laws that crack
std::vector<MaterialCurve> test_material(const BlockLaw& law, const std::vector<double>& confining, double strain,
                                         double size);

}  // namespace ashlar
