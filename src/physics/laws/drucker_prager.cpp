#include "physics/laws/drucker_prager.hpp"

#include <algorithm>
#include <cmath>

#include "physics/laws/wording.hpp"

namespace ashlar {

DruckerPrager::Cone DruckerPrager::cone() const {
  if (given(cone_slope)) return {cone_slope, given(cone_dilation) ? cone_dilation : 0, 1};
  constexpr double root3 = 1.7320508075688772935;
  const auto slope = [&](double angle) {
    const double s = std::sin(angle), t = std::tan(angle);
    if (match == 2) return t / std::sqrt(9 + 12 * t * t);
    return 2 * s / (root3 * (match == 0 ? 3 - s : 3 + s));
  };
  const double s = std::sin(friction), t = std::tan(friction);
  const double strength =
      match == 2 ? 3 / std::sqrt(9 + 12 * t * t) : 6 * std::cos(friction) / (root3 * (match == 0 ? 3 - s : 3 + s));
  return {slope(friction), slope(dilation), strength};
}

std::vector<LawComplaint> DruckerPrager::complaints() const {
  std::vector<LawComplaint> found;
  const auto complain = [&](const char* key, const std::string& message) { found.push_back({key, message}); };
  const bool direct = given(cone_slope) || given(cone_strength) || given(cone_dilation);
  if (direct) {
    if (given(cohesion) || given(friction) || dilation > 0)
      complain("cone_slope",
               "give cohesion, friction and dilation, or cone_slope, cone_strength and cone_dilation, not both");
    if (!given(cone_slope)) complain("", "missing 'cone_slope': it belongs to cone_strength and cone_dilation");
    if (!given(cone_strength)) complain("", "missing 'cone_strength' [Pa]: it belongs to cone_slope");
    if (given(cone_dilation) && cone_dilation > cone_slope)
      complain("cone_dilation", above("cone_dilation", cone_dilation, "cone_slope", cone_slope, "") +
                                    ": flow would make energy; give at most the slope");
  } else {
    if (!given(cohesion)) complain("", "missing 'cohesion' [Pa]: shear strength without normal stress");
    if (!given(friction)) complain("", "missing 'friction': friction angle, such as 35*deg");
    if (dilation > friction) complain("dilation", dilation_above(dilation, friction));
  }
  if (!found.empty()) return found;
  const auto point = prepare<double>();
  if (point.strength == 0 && point.slope == 0) complain("", "has no strength at all: cohesion and friction are both 0");
  if (point.slope > 0 && given(tension_cutoff) && point.cut_off > point.strength / point.slope)
    complain("tension_cutoff",
             above("tension_cutoff", tension_cutoff, "the tip of the cone", point.strength / point.slope / 3, " Pa") +
                 ": it never acts; leave it out or lower it");
  const double first = direct ? cone_strength : cohesion;
  if (residual > first)
    complain("residual", above("residual", residual, direct ? "cone_strength" : "cohesion", first, " Pa"));
  check_softening(point, hardening, found);
  return found;
}

DruckerPrager DruckerPrager::weakened(double factor) const {
  DruckerPrager law = *this;
  for (double* strength :
       {&law.cohesion, &law.cone_slope, &law.cone_strength, &law.tension_cutoff, &law.hardening, &law.residual})
    *strength /= factor;
  law.friction = std::atan(std::tan(friction) / factor);
  law.dilation = std::min(dilation, law.friction);
  law.cone_dilation = std::min(cone_dilation, law.cone_slope);
  return law;
}

}  // namespace ashlar
