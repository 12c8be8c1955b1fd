#pragma once
#include <cmath>
#include <cstdio>
#include <string>

#include "base/error.hpp"
#include "physics/interface_laws/spring.hpp"

namespace ashlar {

/// Bonded interface that loses its strength bit by bit (numerics 5): see softening_traction.
struct SofteningInterface : StiffnessKeys {
  double tensile_strength = 0, cohesion = 0, friction = 0, fracture_energy = 0, shear_fracture_energy = not_given;

  static constexpr const char* name = "softening";
  static constexpr const char* doc =
      "Bonded; beyond its strength it softens linearly while it opens and slides, and takes the fracture energy of "
      "each "
      "mode. Unloads to the origin, closes with full stiffness, keeps its friction.";
  static inline const LawKey<SofteningInterface> keys[] = {
      {"tensile_strength",
       &SofteningInterface::tensile_strength,
       dimension::pressure,
       range::positive,
       {},
       "normal traction at which it begins to soften"},
      {"cohesion",
       &SofteningInterface::cohesion,
       dimension::pressure,
       range::positive,
       {},
       "shear traction beyond friction at which it begins to soften"},
      {"friction", &SofteningInterface::friction, dimension::none, Range{0, 1.55}, 0.0,
       "friction angle where it is pressed together (rad, or *deg)"},
      {"fracture_energy",
       &SofteningInterface::fracture_energy,
       dimension::fracture_energy,
       range::positive,
       {},
       "energy that a unit area takes to open, the elastic rise included"},
      {"shear_fracture_energy", &SofteningInterface::shear_fracture_energy, dimension::fracture_energy, range::positive,
       not_given,
       "energy that a unit area takes to lose its cohesion by sliding, friction apart; it sets shear_stiffness. As "
       "brittle as opening unless given"},
      normal_stiffness_key<SofteningInterface>,
      shear_stiffness_key<SofteningInterface>,
      stiffness_factor_key<SofteningInterface>,
  };

  /// Throws DeckError: energies and stiffnesses that cannot go together.
  SpringLaw<double> prepare(const Where& where, const std::string& what) const {
    const SpringLaw<double> law{tensile_strength, cohesion, std::tan(friction), true, false, fracture_energy};
    if (given(shear_fracture_energy) && shear_stiffness > 0)
      throw DeckError(where,
                      what +
                          ": shear_fracture_energy and shear_stiffness say the same: the spring along the interface is "
                          "normal_stiffness * (cohesion / tensile_strength)^2 * fracture_energy / "
                          "shear_fracture_energy, so that every mixture of modes takes its share; leave one out");
    if (normal_stiffness > 0) refuse_snap_back(law, normal_stiffness, where, what);
    return law;
  }
  /// k_s / k_n that goes with the energies; 0: they leave it open.
  double stiffness_ratio() const {
    const double strengths = cohesion / tensile_strength;
    return given(shear_fracture_energy) ? strengths * strengths * fracture_energy / shear_fracture_energy : 0;
  }
  /// Throws DeckError if a spring of this stiffness, Pa/m, holds more energy at its strength than cracking may take.
  static void refuse_snap_back(const SpringLaw<double>& law, double normal_stiffness, const Where& where,
                               const std::string& what) {
    const double least = law.tensile_strength * law.tensile_strength / (2 * law.fracture_energy);
    if (normal_stiffness > least * Softening<double>::least_ratio) return;
    char text[320];
    std::snprintf(text, sizeof text,
                  "fracture_energy = %.6g J/m^2 is less than the %.6g J/m^2 that a spring of %.6g Pa/m holds at its "
                  "tensile strength of %.6g Pa: it would snap back; give normal_stiffness above %.6g Pa/m (or a larger "
                  "stiffness_factor), or more fracture_energy",
                  law.fracture_energy, law.tensile_strength * law.tensile_strength / (2 * normal_stiffness),
                  normal_stiffness, law.tensile_strength, least);
    throw DeckError(where, what + ": " + text);
  }
};

}  // namespace ashlar
