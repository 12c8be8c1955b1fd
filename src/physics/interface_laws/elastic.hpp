#pragma once
#include "base/error.hpp"
#include "physics/interface_laws/spring.hpp"

namespace ashlar {

/// Interface that never opens or slides: linear springs in every direction (numerics 5).
struct ElasticInterface : StiffnessKeys {
  static constexpr const char* name = "elastic";
  static constexpr const char* doc = "Linear springs; never breaks.";
  static constexpr LawKey<ElasticInterface> keys[] = {
      normal_stiffness_key<ElasticInterface>,
      shear_stiffness_key<ElasticInterface>,
      stiffness_factor_key<ElasticInterface>,
  };
  SpringLaw<double> prepare(const Where&, const std::string&) const { return {.bonded = true, .breakable = false}; }
};

}  // namespace ashlar
