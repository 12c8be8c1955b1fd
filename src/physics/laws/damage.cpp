#include "physics/laws/damage.hpp"

#include "physics/laws/wording.hpp"

namespace ashlar {

std::vector<LawComplaint> Damage::complaints() const {
  std::vector<LawComplaint> found;
  if (compressive_strength < tensile_strength)
    found.push_back({"compressive_strength", above("tensile_strength", tensile_strength, "compressive_strength",
                                                   compressive_strength, " Pa")});
  return found;
}

Damage Damage::weakened(double factor) const {
  Damage law = *this;
  for (double* strength : {&law.tensile_strength, &law.compressive_strength}) *strength /= factor;
  return law;
}

}  // namespace ashlar
