#include "physics/laws/mohr_coulomb.hpp"

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
  const double tip = cohesion / std::tan(friction);
  if (given(tensile_strength) && tensile_strength > tip)
    found.push_back(
        {"tensile_strength", above("tensile_strength", tensile_strength, "cohesion / tan(friction)", tip, " Pa") +
                                 ", where shear strength ends; lower it"});
  return found;
}

}  // namespace ashlar
