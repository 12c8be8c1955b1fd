#pragma once
#include <limits>

#include "base/key.hpp"
#include "base/tensor.hpp"

namespace ashlar {

/// What laws with memory count, see plastic.hpp.
enum class Measure { none, plastic_strain, damage };

/// The keys of the elastic part, which every block law has.
template <class Law>
constexpr LawKey<Law> young_key{"young", &Law::young, dimension::pressure, range::positive, {}, "Young's modulus"};
template <class Law>
constexpr LawKey<Law> poisson_key{"poisson", &Law::poisson,    dimension::none, Range{-0.99, 0.4999},
                                  {},        "Poisson's ratio"};
template <class Law>
constexpr LawKey<Law> expansion_key{"expansion",
                                    &Law::expansion,
                                    dimension::expansion,
                                    range::not_negative,
                                    0.0,
                                    "coefficient of linear thermal expansion"};

/// Linear isotropic elasticity with thermal strain (paper (3); numerics 4):
/// sigma = lambda tr(eps - eps_T) I + 2 mu (eps - eps_T), eps_T = expansion (T - T_reference) I, T at the Gauss point.
struct Elastic {
  double young = 0, poisson = 0, expansion = 0;

  static constexpr const char* name = "elastic";
  static constexpr const char* doc = "Linear isotropic elasticity with thermal strain; never fails.";
  static constexpr LawKey<Elastic> keys[] = {young_key<Elastic>, poisson_key<Elastic>, expansion_key<Elastic>};

  double lambda() const { return young * poisson / ((1 + poisson) * (1 - 2 * poisson)); }
  double shear() const { return young / (2 * (1 + poisson)); }
  double oedometric() const { return lambda() + 2 * shear(); }

  /// Constants of one material as kernels use them.
  template <class Real>
  struct Point {
    static constexpr int history_size = 0;  ///< numbers that a point remembers
    static constexpr bool sized = false;    ///< stress depends on the size of the element
    static constexpr Measure measure = Measure::none;
    static constexpr bool has_plane = false;  ///< remembers a crack plane
    Real lambda, shear, expansion;
    ASHLAR_HD const Point& elastic() const { return *this; }
    /// Strain less that of warming = T - T_reference, K.
    template <class V>
    ASHLAR_HD Sym3<V> without_heat(const Sym3<V>& strain, const V& warming) const {
      const V free = V(expansion) * warming;
      return {strain.xx - free, strain.yy - free, strain.zz - free, strain.xy, strain.yz, strain.zx};
    }
    /// Stress, Pa, from strain without heat (engineering shear).
    template <class V>
    ASHLAR_HD Sym3<V> stress(const Sym3<V>& e) const {
      return hooke(e, V(lambda), V(shear));
    }
    /// weight * stress of the strain e * inverse.
    template <class V>
    ASHLAR_HD Sym3<V> weighted_stress(const Sym3<V>& e, const V& inverse, const V& weight) const {
      return hooke(e, weight * V(lambda) * inverse, weight * V(shear) * inverse);
    }
    template <class V>
    ASHLAR_HD static Sym3<V> hooke(const Sym3<V>& e, const V& lambda, const V& mu) {
      const V pressure = lambda * (e.xx + e.yy + e.zz), twice = mu + mu;
      return {fma(twice, e.xx, pressure),
              fma(twice, e.yy, pressure),
              fma(twice, e.zz, pressure),
              mu * e.xy,
              mu * e.yz,
              mu * e.zx};
    }
  };
  template <class Real>
  Point<Real> prepare() const {
    return {Real(lambda()), Real(shear()), Real(expansion)};
  }
  std::vector<LawComplaint> complaints() const { return {}; }
  /// Of an element across a crack, m: larger ones would snap back.
  double largest_length() const { return std::numeric_limits<double>::infinity(); }
  /// The law with its strength divided by `factor`; an angle by its tangent.
  Elastic weakened(double) const { return *this; }
};

}  // namespace ashlar
