#pragma once
#include "base/key.hpp"
#include "base/tensor.hpp"

namespace ashlar {

/// Linear isotropic elasticity with thermal strain (paper (3); numerics 4):
/// sigma = lambda tr(eps - eps_T) I + 2 mu (eps - eps_T), eps_T = expansion (T - T_reference) I, T at the Gauss point.
struct Elastic {
  double young = 0, poisson = 0, expansion = 0;

  static constexpr const char* name = "elastic";
  static constexpr const char* doc = "Linear isotropic elasticity with thermal strain; never fails.";
  static constexpr LawKey<Elastic> keys[] = {
      {"young", &Elastic::young, dimension::pressure, range::positive, {}, "Young's modulus"},
      {"poisson", &Elastic::poisson, dimension::none, Range{-0.99, 0.4999}, {}, "Poisson's ratio"},
      {"expansion", &Elastic::expansion, dimension::expansion, range::not_negative, 0.0,
       "coefficient of linear thermal expansion"},
  };

  double lambda() const { return young * poisson / ((1 + poisson) * (1 - 2 * poisson)); }
  double shear() const { return young / (2 * (1 + poisson)); }
  double oedometric() const { return lambda() + 2 * shear(); }

  /// Constants of one material as kernels use them.
  template <class Real>
  struct Point {
    Real lambda, shear, expansion;
    /// Stress, Pa, from strain (engineering shear) and warming = T - T_reference, K.
    template <class V>
    ASHLAR_HD Sym3<V> stress(const Sym3<V>& strain, const V& warming) const {
      const V free = V(expansion) * warming;
      return stress(Sym3<V>{strain.xx - free, strain.yy - free, strain.zz - free, strain.xy, strain.yz, strain.zx});
    }
    template <class V>
    ASHLAR_HD Sym3<V> stress(const Sym3<V>& e) const {
      const V pressure = V(lambda) * (e.xx + e.yy + e.zz);
      const V twice = V(shear + shear), mu = V(shear);
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
};

}  // namespace ashlar
