#pragma once
#include "physics/laws/cone.hpp"

namespace ashlar {

/// Drucker-Prager cone, sqrt(J2) + a I1 = k, tension positive (numerics 4). a and k come from cohesion and friction by
/// a named match with Mohr-Coulomb (cases 4), or are given.
struct DruckerPrager : Elastic {
  double cohesion = not_given, friction = not_given, match = 2, dilation = 0;
  double cone_slope = not_given, cone_strength = not_given, cone_dilation = not_given;
  double tension_cutoff = not_given, hardening = 0, residual = 0;

  static constexpr const char* matches[] = {"outer", "inner", "plane_strain"};
  static constexpr const char* name = "drucker_prager";
  static constexpr const char* doc =
      "Elastic, then plastic on a cone of shear strength that grows with pressure: rock, concrete and soil near "
      "failure. "
      "Give cohesion and friction, or cone_slope and cone_strength.";
  static inline const LawKey<DruckerPrager> keys[] = {
      young_key<DruckerPrager>,
      poisson_key<DruckerPrager>,
      expansion_key<DruckerPrager>,
      {"cohesion", &DruckerPrager::cohesion, dimension::pressure, range::not_negative, not_given,
       "shear strength without normal stress"},
      {"friction", &DruckerPrager::friction, dimension::none, Range{0, 1.55}, not_given,
       "friction angle (rad, or *deg)"},
      {"match", &DruckerPrager::match, dimension::none, range::any, 2.0,
       "where the cone meets the Mohr-Coulomb pyramid: outer: triaxial compression, the strongest cone; inner: "
       "triaxial extension; plane_strain: collapse loads in plane strain, inside the pyramid",
       matches},
      {"dilation", &DruckerPrager::dilation, dimension::none, Range{0, 1.55}, 0.0,
       "dilation angle (rad, or *deg), at most the friction angle: how much volume grows as it shears"},
      {"cone_slope", &DruckerPrager::cone_slope, dimension::none, Range{0, 0.57}, not_given,
       "a of sqrt(J2) + a I1 = k, instead of friction"},
      {"cone_strength", &DruckerPrager::cone_strength, dimension::pressure, range::not_negative, not_given,
       "k of sqrt(J2) + a I1 = k, instead of cohesion"},
      {"cone_dilation", &DruckerPrager::cone_dilation, dimension::none, Range{0, 0.57}, not_given,
       "slope of the flow potential, at most cone_slope; 0 unless given"},
      {"tension_cutoff", &DruckerPrager::tension_cutoff, dimension::pressure, range::not_negative, not_given,
       "largest mean stress (a third of the trace); the tip of the cone unless given"},
      {"hardening", &DruckerPrager::hardening, dimension::pressure, range::any, 0.0,
       "change of cohesion (or cone_strength) per equivalent plastic strain; negative softens, and then the answer "
       "depends on the mesh"},
      {"residual", &DruckerPrager::residual, dimension::pressure, range::not_negative, 0.0,
       "cohesion (or cone_strength) that softening leaves"},
  };

  /// a, b and k / cohesion of the cone.
  struct Cone {
    double slope, dilation, strength;
  };
  Cone cone() const;
  template <class Real>
  ConePoint<Real> prepare() const {
    constexpr double root3 = 1.7320508075688772935;
    const Cone c = cone();
    const double k = given(cone_strength) ? cone_strength : c.strength * cohesion;
    const double floor = hardening < 0 ? c.strength * residual : 0;
    return ConePoint<Real>::of(*this, c.slope, c.dilation, k, c.strength * hardening / root3, floor,
                               given(tension_cutoff) ? 3 * tension_cutoff : std::numeric_limits<double>::infinity());
  }
  std::vector<LawComplaint> complaints() const;
  DruckerPrager weakened(double factor) const;
};

}  // namespace ashlar
