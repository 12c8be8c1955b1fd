#include "physics/laws/mohr_coulomb.hpp"

#include <algorithm>
#include <cmath>

#include "physics/laws/wording.hpp"

namespace ashlar {

template <class Real>
PyramidPoint<Real> MohrCoulomb::prepare() const {
  const double s = std::sin(friction), t = std::tan(friction), tip = cohesion / t;
  const double cut = given(tensile_strength) ? std::min(tensile_strength, tip) : tip;
  const double inside = std::sqrt(9 + 12 * t * t);
  // A point on the edge of the cone is tried on the pyramid, where rounding may leave it on either side.
  constexpr double within = 1 - 1e-5;
  return {Elastic::prepare<Real>(),
          Real(s),
          Real(std::sin(dilation)),
          Real(2 * cohesion * std::cos(friction)),
          Real(cut),
          Real(t / inside),
          Real(within * 3 * cohesion / inside)};
}
template PyramidPoint<double> MohrCoulomb::prepare() const;
template PyramidPoint<float> MohrCoulomb::prepare() const;

std::vector<LawComplaint> MohrCoulomb::complaints() const {
  std::vector<LawComplaint> found;
  if (dilation > friction) found.push_back({"dilation", dilation_above(dilation, friction)});
  if (cohesion == 0 && friction == 0) found.push_back({"", "has no strength at all: cohesion and friction are both 0"});
  check_tip(tensile_strength, cohesion, friction, found);
  return found;
}

MohrCoulomb MohrCoulomb::weakened(double factor) const {
  MohrCoulomb law = *this;
  for (double* strength : {&law.cohesion, &law.tensile_strength}) *strength /= factor;
  law.friction = std::atan(std::tan(friction) / factor);
  law.dilation = std::min(dilation, law.friction);
  return law;
}

}  // namespace ashlar
