#include "physics/laws/breakage.hpp"

#include <algorithm>
#include <cmath>

#include "physics/laws/wording.hpp"

namespace ashlar {

template <class Real>
CrackPoint<Real> Breakage::prepare() const {
  const double t = std::tan(friction), turn = 0.5 * std::acos(0.0) + 0.5 * friction, inside = std::sqrt(9 + 12 * t * t);
  const double open = softening_length(oedometric(), fracture_energy, tensile_strength);
  const double slide = given(shear_fracture_energy) ? softening_length(shear(), shear_fracture_energy, cohesion) : open;
  constexpr double within = 1 - 1e-5;  // rounding may leave a point on the edge of the cone on either side
  return {Elastic::prepare<Real>(),
          Real(tensile_strength),
          Real(cohesion),
          Real(t),
          Real(std::sin(friction)),
          Real(2 * cohesion * std::cos(friction)),
          Real(std::cos(turn)),
          Real(std::sin(turn)),
          Real(open),
          Real(slide),
          Real(t / inside),
          Real(within * 3 * cohesion / inside)};
}
template CrackPoint<double> Breakage::prepare() const;
template CrackPoint<float> Breakage::prepare() const;

/// Blocks longer than this unload on a crack by less than the crack gives way.
double Breakage::largest_length() const {
  const double open = softening_length(young, fracture_energy, tensile_strength);
  return given(shear_fracture_energy) ? std::min(open, softening_length(shear(), shear_fracture_energy, cohesion)) : open;
}

std::vector<LawComplaint> Breakage::complaints() const {
  std::vector<LawComplaint> found;
  check_tip(tensile_strength, cohesion, friction, found);
  return found;
}

Breakage Breakage::weakened(double factor) const {
  Breakage law = *this;
  for (double* strength : {&law.tensile_strength, &law.cohesion}) *strength /= factor;
  law.friction = std::atan(std::tan(friction) / factor);
  return law;
}

}  // namespace ashlar
