#pragma once
#include <cmath>

#include "physics/laws/plastic.hpp"

namespace ashlar {

/// Rock with one set of joints so close that every point has one (ubiquitous joint), as a kernel sees it: elastic
/// between, slip where |shear| = cohesion - normal tan(friction) on the plane, opening where normal = tension. Normal
/// and shear traction on the plane change each by its own strain, so the return is in closed form: slip, opening or
/// both.
template <class Real>
struct JointPoint {
  static constexpr int history_size = PlasticHistory<Real>::size;
  static constexpr bool sized = false;
  static constexpr Measure measure = Measure::plastic_strain;
  static constexpr bool has_plane = false;
  Elastic::Point<Real> part;
  Vec3<Real> normal;
  Real cohesion, tan_friction, tan_dilation, tension;  ///< tension at most cohesion / tan_friction

  template <class V>
  using History = PlasticHistory<V>;
  ASHLAR_HD const Elastic::Point<Real>& elastic() const { return part; }

  template <class V>
  ASHLAR_HD Sym3<V> stress(const Sym3<V>& strain, PlasticHistory<V>& history) const {
    return plastic_stress(*this, strain, history);
  }

  template <class V>
  struct OnPlane {
    V normal;    ///< Pa
    V shear;     ///< Pa, its size
    Vec3<V> along;
  };
  template <class V>
  ASHLAR_HD OnPlane<V> test(const Sym3<V>& stress) const {
    const Vec3<V> n{V(normal.x), V(normal.y), V(normal.z)}, t = traction(stress, n);
    const V pulls = dot(t, n);
    const Vec3<V> along = t - pulls * n;
    return {pulls, norm(along), along};
  }
  template <class V>
  ASHLAR_HD bool yields(const OnPlane<V>& test, const PlasticHistory<V>&, int l) const {
    const Real pulls = lane(test.normal, l);
    return pulls > tension || lane(test.shear, l) > fma(-tan_friction, pulls, cohesion);
  }

  /// Trial stress and history to those after slip and opening.
  ASHLAR_HD_CALL void pull_back(Sym3<Real>& s, PlasticHistory<Real>& h) const {
    const OnPlane<Real> trial = test(s);
    const Real modulus = fma(Real(2), part.shear, part.lambda);
    const Real strength_open = fma(-tan_friction, tension, cohesion);
    Real pulls = trial.normal, shear = trial.shear;
    if (pulls > tension && shear <= strength_open) {
      pulls = tension;
    } else {
      const Real slip = (fma(tan_friction, pulls, shear) - cohesion) /
                        fma(modulus * tan_dilation, tan_friction, part.shear);
      pulls = fma(-modulus * tan_dilation, slip, pulls);
      shear = fma(-part.shear, slip, shear);
      if (pulls > tension) {
        pulls = tension;
        shear = strength_open;
      }
    }
    const Real opening = (trial.normal - pulls) / modulus;
    const Real kept = trial.shear > Real(0) ? shear / trial.shear : Real(0);
    const Vec3<Real> lost = (Real(1) - kept) * trial.along, slip = (Real(1) / part.shear) * lost, n = normal;
    take_from_plane(s, n, part, opening, lost);
    h.strain.xx += fma(opening * n.x, n.x, slip.x * n.x);
    h.strain.yy += fma(opening * n.y, n.y, slip.y * n.y);
    h.strain.zz += fma(opening * n.z, n.z, slip.z * n.z);
    const Real twice = opening + opening;
    h.strain.xy += fma(twice * n.x, n.y, fma(slip.x, n.y, slip.y * n.x));
    h.strain.yz += fma(twice * n.y, n.z, fma(slip.y, n.z, slip.z * n.y));
    h.strain.zx += fma(twice * n.z, n.x, fma(slip.z, n.x, slip.x * n.z));
    const Real slipped = norm(slip);
    h.equivalent += root(fma(opening * Real(4.0 / 9), opening, slipped * Real(1.0 / 3) * slipped));
    h.dissipation += fma(pulls, opening, shear * slipped);
  }
};

/// Jointed rock: see JointPoint.
struct Jointed : Elastic {
  double dip = 0, dip_direction = 0, cohesion = 0, friction = 0, dilation = 0, tensile_strength = 0;

  static constexpr const char* name = "jointed";
  static constexpr const char* doc =
      "Elastic rock with close parallel joints (ubiquitous joint): it slips and opens on one plane, everywhere.";
  static inline const LawKey<Jointed> keys[] = {
      young_key<Jointed>,
      poisson_key<Jointed>,
      expansion_key<Jointed>,
      {"dip", &Jointed::dip, dimension::none, Range{0, 1.5707963267948966}, {},
       "angle of the joints below the horizontal (rad, or *deg)"},
      {"dip_direction", &Jointed::dip_direction, dimension::none, Range{0, 6.2831853071795865}, {},
       "azimuth of the line of dip (rad, or *deg), from +y turning to +x: from north over east where y is north"},
      {"cohesion", &Jointed::cohesion, dimension::pressure, range::not_negative, {},
       "of the joints: shear strength without normal stress"},
      {"friction", &Jointed::friction, dimension::none, Range{0, 1.55}, {}, "of the joints (rad, or *deg)"},
      {"dilation", &Jointed::dilation, dimension::none, Range{0, 1.55}, 0.0,
       "of the joints (rad, or *deg), at most the friction angle: how much they open as they slip"},
      {"tensile_strength", &Jointed::tensile_strength, dimension::pressure, range::not_negative, 0.0,
       "of the joints, at most cohesion / tan(friction)"},
  };

  template <class Real>
  JointPoint<Real> prepare() const {
    return {Elastic::prepare<Real>(),
            {Real(std::sin(dip) * std::sin(dip_direction)), Real(std::sin(dip) * std::cos(dip_direction)),
             Real(std::cos(dip))},
            Real(cohesion),
            Real(std::tan(friction)),
            Real(std::tan(dilation)),
            Real(tensile_strength)};
  }
  std::vector<LawComplaint> complaints() const;
  Jointed weakened(double factor) const;
};

}  // namespace ashlar
