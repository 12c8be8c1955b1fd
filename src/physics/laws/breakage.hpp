#pragma once
#include <limits>

#include "physics/laws/plastic.hpp"
#include "physics/principal.hpp"
#include "physics/softening.hpp"

namespace ashlar {

/// The block breakage model of the paper as a kernel sees it. Elastic until the largest principal stress reaches the
/// tensile strength or Mohr-Coulomb is reached; from then on one plane through the point is cracked. One that slides
/// stays as it is. One that opens turns with the largest principal stress until half of its strength is lost, then it
/// stays too: a plane kept from the first stress on, which differs at every Gauss point, takes the shear of the crack
/// that they make together, and cracks spread sideways (Rots 1988 on rotating cracks).
/// With d the damaged share of the plane, its intact share carries traction as before; the damaged share carries
/// nothing where open, and where closed all of the pressure and friction (Alfano & Sacco 2006): secant unloading, full
/// stiffness on closing. d follows the traction that the plane would carry undamaged so that the energy per area is the
/// fracture energy whatever the block's size (numerics 4). As a turning plane bears no shear, turning takes no energy.
template <class Real>
struct CrackPoint {
  static constexpr int history_size = 15;
  static constexpr bool sized = true;
  static constexpr Measure measure = Measure::damage;
  static constexpr bool has_plane = true;
  static constexpr int held = -1;  ///< in place of the length: the point does not begin to open (solve/crack_paths.hpp)
  Elastic::Point<Real> part;
  Real tension, cohesion, tan_friction;
  Real sine, strength;                    ///< sin phi, 2 c cos phi
  Real plane_cosine, plane_sine;          ///< of the angle between the plane of sliding's normal and smallest stress
  Real open_length, slide_length;         ///< m, softening_ratio() times length
  Real cone_slope, cone_strength;         ///< of the cone inside: where it holds nothing breaks

  template <class V>
  struct History {
    static constexpr int size = history_size;
    Sym3<V> strain;   ///< that bears no stress, engineering shear
    V damage{};       ///< damaged share of the crack plane
    V dissipation{};  ///< energy released by cracking and friction, J/m^3
    Vec3<V> normal;   ///< of the crack plane; 0 before it cracks
    V length{};       ///< m, of the element across the plane; 0 while the plane turns, `held` where none may open
    Vec3<V> slip;     ///< of the damaged share, along the plane, engineering strain
    ASHLAR_HD V& operator[](int i) {
      if (i < 6) return strain[i];
      if (i < 8) return i == 6 ? damage : dissipation;
      return i < 11 ? normal[i - 8] : i == 11 ? length : slip[i - 12];
    }
    ASHLAR_HD const V& operator[](int i) const { return const_cast<History&>(*this)[i]; }
  };
  ASHLAR_HD const Elastic::Point<Real>& elastic() const { return part; }

  template <class V, class Length>
  ASHLAR_HD Sym3<V> stress(const Sym3<V>& strain, History<V>& history, const Length& length) const {
    return plastic_stress(*this, strain, history, length);
  }

  template <class V>
  ASHLAR_HD Invariants<V> test(const Sym3<V>& stress) const {
    return pyramid_test(stress, cone_slope);
  }
  /// Whether lane l may be more than elastic.
  template <class V>
  ASHLAR_HD bool yields(const Invariants<V>& test, const History<V>& history, int l) const {
    return lane(history.damage, l) > Real(0) || lane(test.shear, l) > cone_strength || lane(test.trace, l) > tension;
  }

  struct Plane {
    Vec3<Real> normal;  ///< 0: none
    bool slides;
  };
  /// The plane that the stress cracks, or opens further where it is damaged and may turn. `opens`: the point is not held.
  ASHLAR_HD_CALL Plane plane_of(const Sym3<Real>& s, const Principal<Real>& p, bool fresh, bool opens) const {
    if (opens && p.value[0] > tension) return {p.direction[0], false};
    if (fma(Real(1) + sine, p.value[0], (sine - Real(1)) * p.value[2]) > strength) {
      const Vec3<Real> n = plane_cosine * p.direction[2] + plane_sine * p.direction[0];
      const bool pressed = dot(traction(s, n), n) < Real(0);
      if ((fresh && opens) || pressed) return {n, true};  // an open one could store more than before
    }
    if (!fresh && p.value[0] > Real(0)) return {p.direction[0], false};
    return {};
  }

  /// Elastic stress to that of the cracked point; its history moves on.
  template <class Length>
  ASHLAR_HD_CALL void pull_back(Sym3<Real>& s, History<Real>& h, const Length& length) const {
    const bool turns = !(h.length > Real(0));
    const Real modulus = fma(Real(2), part.shear, part.lambda);
    Vec3<Real> n = h.normal;
    Real across = h.length, opened = 0;  // opened: twice the energy that the damaged share lacks so far
    bool fresh = false, stays = true;
    if (turns) {
      fresh = !(h.damage > Real(0));
      const Principal<Real> p = principal(s);
      const Plane plane = plane_of(s, p, fresh, !(h.length < Real(0)));
      if (dot(plane.normal, plane.normal) == Real(0)) return;
      n = plane.normal;
      across = length(n);
      stays = plane.slides;
      const Real pull = larger(p.value[0], Real(0));
      opened = pull * pull / modulus;
    }

    const Vec3<Real> t = traction(s, n);
    const Real normal = dot(t, n);
    const Vec3<Real> along = t - normal * n;
    const Real shear = norm(along);
    const bool open = normal > Real(0);
    const Real friction = open ? Real(0) : -normal * tan_friction;
    const Real opens = open ? normal / tension : Real(0), slides = larger(shear - friction, Real(0)) / cohesion;
    const Real used = open ? root(fma(opens, opens, slides * slides)) : slides;
    if (fresh && !(used > Real(1))) return;
    const Real share = used > Real(0) ? opens * opens / (used * used) : Real(1);  // of opening in the mode
    const Real ratio = fma(share, open_length, (Real(1) - share) * slide_length) / across;
    const Softening<Real> softening(ratio);
    const Real damage = larger(h.damage, softening.damage(used));

    Vec3<Real> slip_to = (Real(1) / part.shear) * along;  // an open plane slips freely
    Vec3<Real> rubbing{};
    if (!open) {
      const Vec3<Real> trial = along - part.shear * h.slip;
      const Real size = norm(trial), kept = size > friction ? friction / size : Real(1);
      rubbing = kept * trial;
      slip_to = h.slip + ((Real(1) - kept) / part.shear) * trial;
      h.dissipation += damage * dot(rubbing, slip_to - h.slip);
      if (turns) {  // what is damaged already loses its cohesion on the new plane at once
        const Vec3<Real> lost = along - rubbing;
        h.dissipation += Real(0.5) * h.damage * (dot(lost, lost) / part.shear - opened);
      }
    }
    const Real brittle = fma(share * tension, tension / modulus, (Real(1) - share) * cohesion * (cohesion / part.shear));
    h.dissipation += brittle * (softening.released(damage) - softening.released(h.damage));
    h.damage = damage;
    h.normal = n;
    if (stays || softening.strength(damage) < Real(0.5)) h.length = across;
    h.slip = slip_to;

    take_from_plane(s, n, part, open ? damage * normal / modulus : Real(0), damage * (along - rubbing));
  }
};

/// Breakage of blocks: see CrackPoint.
struct Breakage : Elastic {
  double tensile_strength = 0, fracture_energy = 0, cohesion = 0, friction = 0, shear_fracture_energy = not_given;
  double crack_spacing = 0;

  static constexpr const char* name = "breakage";
  static constexpr const char* doc =
      "Elastic until the largest principal stress or Mohr-Coulomb strength is reached; then the block breaks on a "
      "plane, across the largest tension until half of its strength is lost and fixed from then on: it opens and "
      "slides, closes again with full stiffness, and keeps its friction. Concrete and rock that crack.";
  static inline const LawKey<Breakage> keys[] = {
      young_key<Breakage>,
      poisson_key<Breakage>,
      expansion_key<Breakage>,
      {"tensile_strength", &Breakage::tensile_strength, dimension::pressure, range::positive, {},
       "largest principal stress, at most cohesion / tan(friction)"},
      {"fracture_energy", &Breakage::fracture_energy, dimension::fracture_energy, range::positive, {},
       "energy that a unit area of crack takes to open, whatever the size of the blocks; it limits that size"},
      {"cohesion", &Breakage::cohesion, dimension::pressure, range::positive, {},
       "shear strength without normal stress"},
      {"friction", &Breakage::friction, dimension::none, Range{0, 1.55}, {},
       "friction angle (rad, or *deg), of the unbroken block and on its crack"},
      {"shear_fracture_energy", &Breakage::shear_fracture_energy, dimension::fracture_energy, range::positive,
       not_given, "energy that a unit area takes to lose its cohesion by sliding, friction apart; as brittle as opening "
                  "unless given"},
      {"crack_spacing", &Breakage::crack_spacing, dimension::length, range::not_negative, 0.0,
       "least distance between two cracks: within it nothing opens but where a crack ends, which goes on along its own "
       "plane and not along the mesh; in static stages; some elements, or what the structure shows; 0: cracks anywhere"},
  };

  template <class Real>
  CrackPoint<Real> prepare() const;
  std::vector<LawComplaint> complaints() const;
  double largest_length() const;
  Breakage weakened(double factor) const;
};

}  // namespace ashlar
