#pragma once
#include "physics/laws/plastic.hpp"
#include "physics/principal.hpp"
#include "physics/softening.hpp"

namespace ashlar {

/// Isotropic damage for concrete as a kernel sees it (Oliver, Cervera, Oller & Lubliner 1990): stress is 1 - damage times
/// that of the undamaged point, and damage follows one measure of that stress s,
///   (t + (1 - t) / contrast) sqrt(young s : C^-1 : s) / tensile strength,
/// where t is the share of tension among the principal stresses and contrast = compressive over tensile strength. As it
/// measures energy, linear softening releases the energy of a crack in whatever state of stress.
template <class Real>
struct DamagePoint {
  static constexpr int history_size = 9;
  static constexpr bool sized = true;
  static constexpr Measure measure = Measure::damage;
  static constexpr bool has_plane = false;
  static constexpr double most = 0.99999;  ///< a block keeps this much less than 1 of its stiffness
  Elastic::Point<Real> part;
  Real strength, contrast;
  Real trace_share, shear_share;  ///< of I1^2 and J2 in young s : C^-1 : s
  Real open_length;               ///< m, softening_length()

  template <class V>
  struct History {
    static constexpr int size = history_size;
    Sym3<V> strain;   ///< that bears no stress, engineering shear
    V damage{};
    V dissipation{};  ///< J/m^3
    V length{};       ///< m, of the element across the first crack
    ASHLAR_HD V& operator[](int i) { return i < 6 ? strain[i] : i == 6 ? damage : i == 7 ? dissipation : length; }
    ASHLAR_HD const V& operator[](int i) const { return const_cast<History&>(*this)[i]; }
  };
  ASHLAR_HD const Elastic::Point<Real>& elastic() const { return part; }

  template <class V, class Length>
  ASHLAR_HD Sym3<V> stress(const Sym3<V>& strain, History<V>& history, const Length& length) const {
    return plastic_stress(*this, strain, history, length);
  }

  template <class V>
  ASHLAR_HD Invariants<V> test(const Sym3<V>& stress) const {
    return invariants(stress);
  }
  ASHLAR_HD Real size_of(Real trace, Real shear) const {
    return root(fma(trace_share * trace, trace, shear_share * shear * shear));
  }
  /// The share of tension is not known yet: 0 where the largest principal stress is surely below 0, at most 1.
  template <class V>
  ASHLAR_HD bool yields(const Invariants<V>& test, const History<V>& history, int l) const {
    const Real trace = lane(test.trace, l), shear = lane(test.shear, l), size = size_of(trace, shear);
    const bool tension = fma(Real(1.0 / 3), trace, Real(1.1547005383792515290) * shear) > Real(0);
    return lane(history.damage, l) > Real(0) || size > (tension ? strength : contrast * strength);
  }
  /// The measure, 1 where damage begins.
  ASHLAR_HD Real used(const Invariants<Real>& i, const Principal<Real>& p) const {
    Real tension = 0, all = 0;
    for (int k = 0; k < 3; ++k) {
      tension += larger(p.value[k], Real(0));
      all += larger(p.value[k], -p.value[k]);
    }
    const Real share = all > Real(0) ? tension / all : Real(0);
    return (share + (Real(1) - share) / contrast) * size_of(i.trace, i.shear) / strength;
  }

  /// Elastic stress to that of the damaged point; its history moves on.
  template <class Length>
  ASHLAR_HD_CALL void pull_back(Sym3<Real>& s, History<Real>& h, const Length& length) const {
    const Principal<Real> p = principal(s);
    const Invariants<Real> i = invariants(s);
    if (!(h.damage > Real(0))) h.length = length(p.direction[0]);
    const Softening<Real> softening(open_length / h.length);
    const Real now = used(i, p), damage = smaller(larger(h.damage, softening.damage(now)), Real(most));
    if (damage > h.damage) {
      const Real bulk = fma(Real(2.0 / 3), part.shear, part.lambda);
      const Real stored = fma(i.trace / (Real(9) * bulk), i.trace, i.shear / part.shear * i.shear);  // twice
      h.dissipation += stored / (now * now) * (softening.released(damage) - softening.released(h.damage));
      h.damage = damage;
    }
    for (int c = 0; c < 6; ++c) s[c] = (Real(1) - damage) * s[c];
  }
};

/// Isotropic damage with strength in tension and compression: see DamagePoint.
struct Damage : Elastic {
  double tensile_strength = 0, fracture_energy = 0, compressive_strength = not_given;

  static constexpr const char* name = "damage";
  static constexpr const char* doc =
      "Elastic with a stiffness that falls, the same in all directions, once strength in tension or compression is "
      "reached, and stays low: concrete under loads that do not turn round. Cracks that close again: breakage.";
  static inline const LawKey<Damage> keys[] = {
      young_key<Damage>,
      poisson_key<Damage>,
      expansion_key<Damage>,
      {"tensile_strength", &Damage::tensile_strength, dimension::pressure, range::positive, {},
       "uniaxial, where damage begins"},
      {"fracture_energy", &Damage::fracture_energy, dimension::fracture_energy, range::positive, {},
       "energy that a unit area of crack takes, whatever the size of the blocks; it limits that size"},
      {"compressive_strength", &Damage::compressive_strength, dimension::pressure, range::positive, not_given,
       "uniaxial; 10 times tensile_strength unless given"},
  };

  double contrast() const { return given(compressive_strength) ? compressive_strength / tensile_strength : 10; }
  template <class Real>
  DamagePoint<Real> prepare() const {
    return {Elastic::prepare<Real>(),
            Real(tensile_strength),
            Real(contrast()),
            Real((1 - 2 * poisson) / 3),
            Real(2 * (1 + poisson)),
            Real(largest_length())};
  }
  double largest_length() const { return softening_length(young, fracture_energy, tensile_strength); }
  std::vector<LawComplaint> complaints() const;
  Damage weakened(double factor) const;
};

}  // namespace ashlar
