#include "physics/laws/von_mises.hpp"

#include "physics/laws/wording.hpp"

namespace ashlar {

std::vector<LawComplaint> VonMises::complaints() const {
  std::vector<LawComplaint> found;
  if (residual_stress > yield_stress)
    found.push_back(
        {"residual_stress", above("residual_stress", residual_stress, "yield_stress", yield_stress, " Pa")});
  check_softening(prepare<double>(), hardening, found);
  return found;
}

VonMises VonMises::weakened(double factor) const {
  VonMises law = *this;
  for (double* strength : {&law.yield_stress, &law.hardening, &law.residual_stress}) *strength /= factor;
  return law;
}

}  // namespace ashlar
