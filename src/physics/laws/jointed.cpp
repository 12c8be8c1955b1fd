#include "physics/laws/jointed.hpp"

#include <algorithm>

#include "physics/laws/wording.hpp"

namespace ashlar {

std::vector<LawComplaint> Jointed::complaints() const {
  std::vector<LawComplaint> found;
  if (dilation > friction) found.push_back({"dilation", dilation_above(dilation, friction)});
  check_tip(tensile_strength, cohesion, friction, found);
  return found;
}

Jointed Jointed::weakened(double factor) const {
  Jointed law = *this;
  for (double* strength : {&law.cohesion, &law.tensile_strength}) *strength /= factor;
  law.friction = std::atan(std::tan(friction) / factor);
  law.dilation = std::min(dilation, law.friction);
  return law;
}

}  // namespace ashlar
