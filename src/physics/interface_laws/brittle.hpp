#pragma once
#include <cmath>
#include <cstdio>
#include <string>

#include "base/error.hpp"
#include "physics/interface_laws/spring.hpp"

namespace ashlar {

/// Bonded interface that cracks at once (numerics 5): in tension at t_n = T, in shear at |t_s| = c - t_n tan(phi);
/// afterwards T = c = 0 and friction stays.
struct BrittleInterface : StiffnessKeys {
  double tensile_strength = 0, cohesion = 0, friction = 0;

  static constexpr const char* name = "brittle";
  static constexpr const char* doc =
      "Bonded until the tensile strength or the Mohr-Coulomb shear strength is reached; then only friction while "
      "closed.";
  static constexpr LawKey<BrittleInterface> keys[] = {
      {"tensile_strength",
       &BrittleInterface::tensile_strength,
       dimension::pressure,
       range::positive,
       {},
       "normal traction at which it opens"},
      {"cohesion",
       &BrittleInterface::cohesion,
       dimension::pressure,
       range::positive,
       {},
       "shear strength without normal traction; at least tensile_strength * tan(friction)"},
      {"friction",
       &BrittleInterface::friction,
       dimension::none,
       Range{0, 1.55},
       {},
       "friction angle of the bond and of the cracked interface (rad, or *deg)"},
      normal_stiffness_key<BrittleInterface>,
      shear_stiffness_key<BrittleInterface>,
      stiffness_factor_key<BrittleInterface>,
  };

  /// Throws DeckError where tension could never decide: T > c / tan(phi), beyond the tip of the Mohr-Coulomb line.
  SpringLaw<double> prepare(const Where& where, const std::string& what) const {
    const double tan_friction = std::tan(friction);
    if (tensile_strength * tan_friction > cohesion) {
      char text[240];
      std::snprintf(
          text, sizeof text,
          "tensile_strength = %.6g Pa is above cohesion / tan(friction) = %.6g Pa, where shear strength ends: "
          "lower tensile_strength, or raise cohesion to at least %.6g Pa",
          tensile_strength, cohesion / tan_friction, tensile_strength * tan_friction);
      throw DeckError(where, what + ": " + text);
    }
    return {tensile_strength, cohesion, tan_friction, true, true};
  }
};

}  // namespace ashlar
