#pragma once
#include <cstdint>

#include "base/key.hpp"
#include "base/tensor.hpp"
#include "physics/softening.hpp"

/// One spring of an interface, pointwise: traction from the relative displacement of its two sides, and how near it is
/// to cracking (numerics 5). Tension and opening are positive; the normal points from side a to side b; gap = u_b -
/// u_a.
namespace ashlar {

/// State of a contact point, as results show it. Softening: part of its bond is gone.
enum class ContactState : std::uint8_t { intact = 0, cracked_in_tension = 1, cracked_in_shear = 2, softening = 3 };
ASHLAR_HD bool is_cracked(ContactState s) {
  return s == ContactState::cracked_in_tension || s == ContactState::cracked_in_shear;
}

/// What an interface law is to a spring. All laws share this form:
/// elastic is bonded and cannot break, brittle is bonded and can, frictional was never bonded, softening loses its bond
/// bit by bit.
template <class Real>
struct SpringLaw {
  Real tensile_strength = 0;  ///< Pa
  Real cohesion = 0;          ///< Pa
  Real tan_friction = 0;      ///< of the bond's shear strength and of sliding after it has cracked
  bool bonded = false;        ///< intact contact points carry tension, and shear without sliding
  bool breakable = false;     ///< at once, at an equilibrium
  Real fracture_energy = 0;   ///< J/m^2 that opening takes; 0: it does not soften

  template <class Other>
  SpringLaw<Other> as() const {
    return {Other(tensile_strength), Other(cohesion), Other(tan_friction), bonded, breakable, Other(fracture_energy)};
  }
  /// The law with `share` of its strength, of the bond alone.
  ASHLAR_HD SpringLaw with_strength(Real share) const {
    SpringLaw law = *this;
    law.tensile_strength = share * tensile_strength;
    law.cohesion = share * cohesion;
    return law;
  }
  /// The law with its strength divided by `factor`.
  SpringLaw weakened(double factor) const {
    SpringLaw law = *this;
    law.tensile_strength = Real(tensile_strength / factor);
    law.cohesion = Real(cohesion / factor);
    law.tan_friction = Real(tan_friction / factor);
    return law;
  }
  ASHLAR_HD bool holds(ContactState state) const { return bonded && state == ContactState::intact; }
  ASHLAR_HD bool can_break(ContactState state) const { return breakable && state == ContactState::intact; }
  ASHLAR_HD bool softens() const { return fracture_energy > Real(0); }
  /// Whether its contact points can open or slide, at once or after they have cracked.
  ASHLAR_HD bool separates() const { return !bonded || breakable || softens(); }
};

/// Pa/m.
template <class Real>
struct SpringStiffness {
  Real normal = 0, shear = 0;
};

/// Vector split into its component along the normal and the rest.
template <class Real>
struct Split {
  Real normal;
  Vec3<Real> shear;
};
template <class Real>
ASHLAR_HD Split<Real> split(const Vec3<Real>& v, const Vec3<Real>& n) {
  const Real along = dot(v, n);
  return {along, {fma(-along, n.x, v.x), fma(-along, n.y, v.y), fma(-along, n.z, v.z)}};
}
template <class Real>
ASHLAR_HD Vec3<Real> joined(const Split<Real>& s, const Vec3<Real>& n) {
  return {fma(s.normal, n.x, s.shear.x), fma(s.normal, n.y, s.shear.y), fma(s.normal, n.z, s.shear.z)};
}

/// Traction that side b exerts on side a, Pa (side a gets +traction, side b the opposite), and the slip that goes with
/// it.
template <class Real>
struct SpringAnswer {
  Split<Real> traction;
  Vec3<Real> slip;  ///< m, tangential relative displacement without elastic part
  Real damage = 0;  ///< share without a bond
};

/// Energy that contact points have lost, J/m^2 or J: of their bond by opening and by shear, and by rubbing.
template <class Real>
struct Dissipation {
  Real opening = 0, shear = 0, friction = 0;
  Real sum() const { return opening + shear + friction; }
  Dissipation operator+(const Dissipation& other) const {
    return {opening + other.opening, shear + other.shear, friction + other.friction};
  }
};

/// The same of a softening spring; slip is that of its broken share.
template <class Real>
struct SofteningAnswer : SpringAnswer<Real> {
  Vec3<Real> rubbing;      ///< Pa, what friction on the broken share adds to the shear traction
  Dissipation<Real> lost;  ///< on the way here
  ContactState state = ContactState::intact;
};

/// Bonded: t_n = k_n g_n, t_s = k_s (g_s - slip). Otherwise an open contact carries nothing and forgets its shear (slip
/// follows the gap); a closed one carries compression with the full k_n and shear up to |t_s| = -t_n tan(phi) (Coulomb
/// return). Sliding depends on the path: `slip` is that of the state to go on from, the answer's slip that of the new
/// state, one straight step away.
template <class Real>
ASHLAR_HD SpringAnswer<Real> spring_traction(bool bonded, Real tan_friction, const SpringStiffness<Real>& stiffness,
                                             const Split<Real>& gap, const Vec3<Real>& slip) {
  const Real normal = stiffness.normal * gap.normal;
  if (!bonded && gap.normal > Real(0)) return {{Real(0), {}}, gap.shear, Real(1)};
  const Vec3<Real> trial = stiffness.shear * (gap.shear - slip);
  if (bonded) return {{normal, trial}, slip, Real(0)};
  const Real limit = -normal * tan_friction, size = norm(trial);
  if (size <= limit) return {{normal, trial}, slip, Real(1)};
  const Real keep = limit / size;  // size > limit >= 0
  const Real slid = (Real(1) - keep) / stiffness.shear;
  return {{normal, keep * trial}, slip + slid * trial, Real(1)};
}

/// Softening (numerics 5): the unbroken share carries k_n g_n and k_s g_s, the broken one nothing where open and
/// friction where closed, without slip when it breaks; pressure is carried in full (Alfano & Sacco 2006). With s^2 =
/// (t_n / T)^2 +
/// ((|t_s| - friction) / c)^2 of the unbroken share, traction falls linearly in s from s = 1 to s = R = 2 k_n G_I /
/// T^2, which costs G_I in opening and G_II = G_I (k_n / T^2) / (k_s / c^2) in shear, and their mean by share of s^2
/// between: R is the same for every mixture, so no path costs more or less (Turon et al. 2010). `damage`, `slip`,
/// `state`: of the last kept equilibrium, one straight step away.
template <class Real>
ASHLAR_HD SofteningAnswer<Real> softening_traction(const SpringLaw<Real>& law, const SpringStiffness<Real>& stiffness,
                                                   const Split<Real>& gap, const Vec3<Real>& slip, Real damage,
                                                   ContactState state) {
  const bool open = gap.normal > Real(0);
  const Real normal = stiffness.normal * gap.normal;
  const Vec3<Real> along = stiffness.shear * gap.shear;
  const Real friction = open ? Real(0) : -normal * law.tan_friction;
  const Real opens = open ? normal / law.tensile_strength : Real(0);
  const Real slides = larger(norm(along) - friction, Real(0)) / law.cohesion;
  const Real square = fma(opens, opens, slides * slides);
  const Softening<Real> softening(Real(2) * law.fracture_energy / law.tensile_strength *
                                  (stiffness.normal / law.tensile_strength));

  SofteningAnswer<Real> answer;
  answer.damage = larger(damage, softening.damage(root(square)));
  answer.state = state;
  if (answer.damage > Real(0) && !is_cracked(state))
    answer.state = answer.damage < Real(1) ? ContactState::softening
                   : opens < slides        ? ContactState::cracked_in_shear
                                           : ContactState::cracked_in_tension;
  const Real whole = Real(1) - answer.damage;
  answer.traction = {open ? whole * normal : normal, whole * along};
  answer.slip = gap.shear;
  if (!open) {
    const Vec3<Real> brought = answer.damage > Real(0) ? (damage / answer.damage) * slip : Vec3<Real>{};
    const Vec3<Real> trial = along - stiffness.shear * brought;
    const Real size = norm(trial), kept = size > friction ? friction / size : Real(1);
    answer.rubbing = (answer.damage * kept) * trial;
    answer.slip = brought + ((Real(1) - kept) / stiffness.shear) * trial;
    answer.traction.shear = answer.traction.shear + answer.rubbing;
    answer.lost.friction = dot(answer.rubbing, answer.slip - brought);
  }
  if (answer.damage > damage) {
    const Real gone = (softening.released(answer.damage) - softening.released(damage)) / square;
    answer.lost.opening = gone * opens * opens * law.tensile_strength * (law.tensile_strength / stiffness.normal);
    answer.lost.shear = gone * slides * slides * law.cohesion * (law.cohesion / stiffness.shear);
  }
  return answer;
}

/// How much of the strength a bonded contact uses; it cracks at 1.
/// Tension: t_n / T. Shear: (|t_s| + t_n tan(phi)) / c, which is 1 on |t_s| = c - t_n tan(phi).
template <class Real>
struct Utilisation {
  Real tension, shear;
  ASHLAR_HD Real largest() const { return tension < shear ? shear : tension; }
  ASHLAR_HD ContactState mode() const {
    return tension < shear ? ContactState::cracked_in_shear : ContactState::cracked_in_tension;
  }
};
template <class Real>
ASHLAR_HD Utilisation<Real> utilisation(const SpringLaw<Real>& law, const Split<Real>& traction) {
  return {traction.normal / law.tensile_strength,
          fma(traction.normal, law.tan_friction, norm(traction.shear)) / law.cohesion};
}

/// Where between two states a bonded contact first uses its whole strength, if its traction changes linearly from
/// `before` to `after`: a fraction in [0, 1], or above 1 if it stays below.
template <class Real>
ASHLAR_HD Real first_crossing(const SpringLaw<Real>& law, const Split<Real>& before, const Split<Real>& after) {
  const Real never = Real(2);
  Real first = never;
  const Real rise = after.normal - before.normal;
  if (after.normal >= law.tensile_strength)
    first = before.normal >= law.tensile_strength ? Real(0) : (law.tensile_strength - before.normal) / rise;
  // |s0 + x ds| = p + x q, squared: a x^2 + 2 b x + c = 0 with c < 0 while inside the cone.
  const Vec3<Real> turn = after.shear - before.shear;
  const Real p = fma(-law.tan_friction, before.normal, law.cohesion), q = -law.tan_friction * rise;
  const Real a = fma(-q, q, dot(turn, turn)), b = fma(-p, q, dot(before.shear, turn));
  const Real c = fma(-p, p, dot(before.shear, before.shear));
  if (p <= Real(0) || c >= Real(0)) return Real(0);
  const Real square = fma(b, b, -(a * c));
  if (square < Real(0)) return first;
  const Real below = b + root(square);
  if (below <= Real(0)) return first;
  return smaller(first, -c / below);
}

/// The stiffness keys that every interface law has.
struct StiffnessKeys {
  double normal_stiffness = 0, shear_stiffness = 0, stiffness_factor = 100;
};
template <class Law>
constexpr LawKey<Law> normal_stiffness_key{
    "normal_stiffness",
    &Law::normal_stiffness,
    dimension::stiffness_per_area,
    range::not_negative,
    0.0,
    "spring stiffness across the interface; 0: stiffness_factor * (lambda + 2 mu) / (half heights of both elements)"};
template <class Law>
constexpr LawKey<Law> shear_stiffness_key{
    "shear_stiffness",
    &Law::shear_stiffness,
    dimension::stiffness_per_area,
    range::not_negative,
    0.0,
    "spring stiffness along the interface; 0: stiffness_factor * mu / (half heights of both elements)"};
template <class Law>
constexpr LawKey<Law> stiffness_factor_key{"stiffness_factor",
                                           &Law::stiffness_factor,
                                           dimension::none,
                                           range::positive,
                                           100.0,
                                           "stiffness of a spring over that of the weaker element beside it: 100 adds "
                                           "about 1 % to displacements; steps grow with its root"};

}  // namespace ashlar
