#pragma once
#include "physics/laws/plastic.hpp"
#include "physics/principal.hpp"

namespace ashlar {

/// The Mohr-Coulomb pyramid with a tension cut-off, in principal stresses s1 >= s2 >= s3, tension positive:
/// (1 + sin phi) s1 - (1 - sin phi) s3 <= 2 c cos phi and s1 <= T. All faces are planes, so the stress after flow is
/// that of the one set of planes whose multipliers are not negative and which leaves no other plane behind (Koiter
/// 1953; Clausen et al. 2006): a face, an edge or a vertex, each in closed form.
template <class Real>
struct PyramidPoint {
  static constexpr int history_size = PlasticHistory<Real>::size;
  static constexpr bool sized = false;
  static constexpr Measure measure = Measure::plastic_strain;
  static constexpr bool has_plane = false;
  Elastic::Point<Real> part;
  Real sine, dilation, strength;   ///< sin phi, sin psi, 2 c cos phi
  Real tension;                    ///< T, at most c / tan(phi)
  Real cone_slope, cone_strength;  ///< of the cone inside: where it holds nothing yields

  template <class V>
  using History = PlasticHistory<V>;
  ASHLAR_HD const Elastic::Point<Real>& elastic() const { return part; }

  template <class V>
  ASHLAR_HD Sym3<V> stress(const Sym3<V>& strain, PlasticHistory<V>& history) const {
    return plastic_stress(*this, strain, history);
  }

  /// Demand on the inner cone, and a bound of the largest principal stress.
  template <class V>
  ASHLAR_HD Invariants<V> test(const Sym3<V>& stress) const {
    return pyramid_test(stress, cone_slope);
  }
  template <class V>
  ASHLAR_HD bool yields(const Invariants<V>& test, const PlasticHistory<V>&, int l) const {
    return lane(test.shear, l) > cone_strength || lane(test.trace, l) > tension;
  }

  /// One plane in principal stresses: normal . s = limit, and its direction of flow.
  struct Plane {
    Real normal[3], flow[3], limit;
  };
  ASHLAR_HD Plane shear_plane(int i, int j) const {
    Plane p{{0, 0, 0}, {0, 0, 0}, strength};
    p.normal[i] = Real(1) + sine;
    p.normal[j] = sine - Real(1);
    p.flow[i] = Real(1) + dilation;
    p.flow[j] = dilation - Real(1);
    return p;
  }
  ASHLAR_HD Plane tension_plane(int i) const {
    Plane p{{0, 0, 0}, {0, 0, 0}, tension};
    p.normal[i] = p.flow[i] = Real(1);
    return p;
  }
  ASHLAR_HD static Real along(const Real (&a)[3], const Real (&b)[3]) {
    return fma(a[2], b[2], fma(a[1], b[1], a[0] * b[0]));
  }
  /// How far the farthest plane is overstepped, Pa.
  ASHLAR_HD Real overstep(const Real (&s)[3]) const {
    const Real high = larger(larger(s[0], s[1]), s[2]), low = smaller(smaller(s[0], s[1]), s[2]);
    return larger(fma(Real(1) + sine, high, (sine - Real(1)) * low) - strength, high - tension);
  }

  /// Stress after flow on `count` planes; false where a multiplier is negative or another plane is overstepped.
  ASHLAR_HD_CALL bool return_to(const Plane (&planes)[3], int count, const Real (&trial)[3], Real slack,
                                Real (&s)[3]) const {
    Real m[3][4] = {};
    Real pull[3][3] = {};  // stress that flow of size 1 takes away
    for (int k = 0; k < count; ++k) {
      const Real volume = part.lambda * (planes[k].flow[0] + planes[k].flow[1] + planes[k].flow[2]);
      for (int i = 0; i < 3; ++i) pull[k][i] = fma(part.shear + part.shear, planes[k].flow[i], volume);
    }
    for (int k = 0; k < count; ++k) {
      for (int l = 0; l < count; ++l) m[k][l] = along(planes[k].normal, pull[l]);
      m[k][3] = along(planes[k].normal, trial) - planes[k].limit;
    }
    for (int k = 0; k < count; ++k) {
      const Real pivot = m[k][k], size = pivot < Real(0) ? -pivot : pivot;
      if (size <= Real(1e-6) * part.shear) return false;
      for (int l = k + 1; l < count; ++l) {
        const Real share = m[l][k] / pivot;
        for (int c = k; c < 4; ++c) m[l][c] = fma(-share, m[k][c], m[l][c]);
      }
    }
    for (int i = 0; i < 3; ++i) s[i] = trial[i];
    for (int k = count - 1; k >= 0; --k) {
      Real right = m[k][3];
      for (int l = k + 1; l < count; ++l) right = fma(-m[k][l], m[l][3], right);
      const Real flow = m[k][3] = right / m[k][k];
      if (flow < -slack / part.shear) return false;
      for (int i = 0; i < 3; ++i) s[i] = fma(-flow, pull[k][i], s[i]);
    }
    return overstep(s) <= slack;
  }

  /// Principal stresses after flow.
  ASHLAR_HD_CALL void find(const Real (&trial)[3], Real (&s)[3]) const {
    const Real reach = larger(trial[0] < Real(0) ? -trial[0] : trial[0], trial[2] < Real(0) ? -trial[2] : trial[2]);
    const Real rounding = (sizeof(Real) == 4 ? Real(3e-6) : Real(1e-12)) * larger(reach, strength);
    const Plane main = shear_plane(0, 2), low_edge = shear_plane(0, 1), high_edge = shear_plane(1, 2);
    const Plane cut = tension_plane(0), cut_2 = tension_plane(1), cut_3 = tension_plane(2);
    const Plane sets[10][3] = {{main},
                               {cut},
                               {main, low_edge},
                               {main, high_edge},
                               {main, cut},
                               {cut, cut_2},
                               {main, low_edge, cut},
                               {main, high_edge, cut},
                               {main, cut, cut_2},
                               {cut, cut_2, cut_3}};
    constexpr int counts[10] = {1, 1, 2, 2, 2, 2, 3, 3, 3, 3};
    // Where rounding leaves no set standing, as on a stress that has flowed before, a coarser look finds the one.
    for (Real slack = rounding; slack <= Real(1000) * rounding; slack *= Real(31))
      for (int k = 0; k < 10; ++k)
        if (return_to(sets[k], counts[k], trial, slack, s)) return;
    for (int i = 0; i < 3; ++i) s[i] = tension;  // the tip
  }

  /// Trial stress and history to those after flow, if the pyramid itself is overstepped.
  ASHLAR_HD_CALL void pull_back(Sym3<Real>& s, PlasticHistory<Real>& h) const {
    Principal<Real> p = principal(s);
    if (overstep(p.value) <= Real(0)) return;
    Real after[3];
    find(p.value, after);
    const Real mu = part.shear, bulk = fma(Real(2.0 / 3), mu, part.lambda);
    Real lost[3], sum = 0;
    for (int i = 0; i < 3; ++i) {
      lost[i] = p.value[i] - after[i];
      sum += lost[i];
    }
    Real turn = 0, work = 0;
    for (int i = 0; i < 3; ++i) {
      const Real deviator = (lost[i] - sum * Real(1.0 / 3)) / (mu + mu);
      turn = fma(deviator, deviator, turn);
      lost[i] = deviator + sum / (Real(9) * bulk);  // plastic strain now
      work = fma(after[i], lost[i], work);
    }
    Principal<Real> flow = p;
    for (int i = 0; i < 3; ++i) {
      p.value[i] = after[i];
      flow.value[i] = lost[i];
    }
    s = from_principal(p);
    const Sym3<Real> strain = from_principal(flow);
    for (int i = 0; i < 6; ++i) h.strain[i] += i < 3 ? strain[i] : strain[i] + strain[i];
    h.equivalent += root(turn * Real(2.0 / 3));
    h.dissipation += work;
  }
};

/// Mohr-Coulomb with a tension cut-off on principal stresses, perfectly plastic.
struct MohrCoulomb : Elastic {
  double cohesion = 0, friction = 0, dilation = 0, tensile_strength = not_given;

  static constexpr const char* name = "mohr_coulomb";
  static constexpr const char* doc =
      "Elastic, then plastic where shear strength cohesion - normal stress * tan(friction) is reached on any plane: "
      "rock, rockfill, soil.";
  static inline const LawKey<MohrCoulomb> keys[] = {
      young_key<MohrCoulomb>,
      poisson_key<MohrCoulomb>,
      expansion_key<MohrCoulomb>,
      {"cohesion",
       &MohrCoulomb::cohesion,
       dimension::pressure,
       range::not_negative,
       {},
       "shear strength without normal stress"},
      {"friction", &MohrCoulomb::friction, dimension::none, Range{0, 1.55}, {}, "friction angle (rad, or *deg)"},
      {"dilation", &MohrCoulomb::dilation, dimension::none, Range{0, 1.55}, 0.0,
       "dilation angle (rad, or *deg), at most the friction angle: how much volume grows as it shears"},
      {"tensile_strength", &MohrCoulomb::tensile_strength, dimension::pressure, range::not_negative, not_given,
       "largest principal stress, at most cohesion / tan(friction), which it is unless given"},
  };

  template <class Real>
  PyramidPoint<Real> prepare() const;
  std::vector<LawComplaint> complaints() const;
  MohrCoulomb weakened(double factor) const;
};

}  // namespace ashlar
