#pragma once
#include <cmath>

#include "physics/laws/cone.hpp"

namespace ashlar {

/// Yields where sqrt(3 J2) reaches the uniaxial yield stress, whatever the mean stress: steel, and undrained clay with
/// yield_stress = sqrt(3) times its shear strength.
struct VonMises : Elastic {
  double yield_stress = 0, hardening = 0, residual_stress = 0;

  static constexpr const char* name = "von_mises";
  static constexpr const char* doc =
      "Elastic, then plastic where sqrt(3 J2) reaches the yield stress: metals, undrained clay.";
  static inline const LawKey<VonMises> keys[] = {
      young_key<VonMises>,
      poisson_key<VonMises>,
      expansion_key<VonMises>,
      {"yield_stress", &VonMises::yield_stress, dimension::pressure, range::positive, {}, "uniaxial yield stress"},
      {"hardening", &VonMises::hardening, dimension::pressure, range::any, 0.0,
       "change of yield stress per equivalent plastic strain; negative softens, and then the answer depends on the "
       "mesh"},
      {"residual_stress", &VonMises::residual_stress, dimension::pressure, range::not_negative, 0.0,
       "yield stress that softening leaves"},
  };

  template <class Real>
  ConePoint<Real> prepare() const {
    constexpr double root3 = 1.7320508075688772935;
    const double k = yield_stress / root3, floor = hardening < 0 ? residual_stress / root3 : 0;
    return ConePoint<Real>::of(*this, 0, 0, k, hardening / 3, floor, std::numeric_limits<double>::infinity());
  }
  std::vector<LawComplaint> complaints() const;
  VonMises weakened(double factor) const;
};

}  // namespace ashlar
