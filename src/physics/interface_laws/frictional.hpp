#pragma once
#include <cmath>

#include "base/error.hpp"
#include "physics/interface_laws/spring.hpp"

namespace ashlar {

/// Interface without any bond: no tension ever, Coulomb friction while closed (numerics 5).
struct FrictionalInterface : StiffnessKeys {
  double friction = 0;

  static constexpr const char* name = "frictional";
  static constexpr const char* doc = "No tension ever; Coulomb friction while closed. Opens, slides and closes again.";
  static constexpr LawKey<FrictionalInterface> keys[] = {
      {"friction",
       &FrictionalInterface::friction,
       dimension::none,
       Range{0, 1.55},
       {},
       "friction angle (rad, or *deg)"},
      normal_stiffness_key<FrictionalInterface>,
      shear_stiffness_key<FrictionalInterface>,
      stiffness_factor_key<FrictionalInterface>,
  };
  SpringLaw<double> prepare(const Where&, const std::string&) const {
    return {.tan_friction = std::tan(friction), .bonded = false, .breakable = false};
  }
};

}  // namespace ashlar
