#pragma once
#include "physics/gauss_table.hpp"

/// Elements that do not lock where volume hardly changes (plastic flow, Poisson's ratio near 0.5): B-bar, the change of
/// volume is that of the element's mean at every Gauss point (Hughes 1980), and so is the mean stress in its forces.
/// A linear tetrahedron is its own mean; there the mean goes over its neighbours.
namespace ashlar {

template <class Base, class V>
struct BBar : Base {
  using S = Scalar<V>;
  using Lines = GaussTable<Base>;
  static constexpr int corners = Base::corners;

  /// Corner forces, N; see Hex8::force.
  template <class Stress>
  ASHLAR_HD static void force(const V (&x)[3][corners], const V (&u)[3][corners], V (&f)[3][corners], Stress& stress) {
    const V zero = V(S(0)), third = V(S(1.0 / 3)), weight = V(S(Lines::factor));
    ElementGeometry<Base, V> geometry(x);
    typename Lines::Table moved[3], forces[3];
    for (int i = 0; i < 3; ++i) moved[i] = Lines::of(u[i]);
    V volume = zero, growth = zero;
    ASHLAR_UNROLL
    for (int g = 0; g < Base::gauss_points; ++g) {
      const Jacobian<V> j = geometry.jacobian_at(g);
      volume = volume + j.det;
      for (int i = 0; i < 3; ++i) {
        const Vec3<V> h = Lines::at(moved[i], g), side{j.bc[i], j.ca[i], j.ab[i]};
        growth = fma(h.z, side.z, fma(h.y, side.y, fma(h.x, side.x, growth)));
        Lines::put(forces[i], g, {zero, zero, zero});
      }
    }
    const V share = V(S(1)) / volume, dilatation = growth * share;
    V pressure = zero;
    geometry.forget();
    ASHLAR_UNROLL
    for (int g = 0; g < Base::gauss_points; ++g) {
      const Jacobian<V> j = geometry.jacobian_at(g);
      const Vec3<V> dx = Lines::at(moved[0], g), dy = Lines::at(moved[1], g), dz = Lines::at(moved[2], g);
      const V inverse = reciprocal(j.det);
      Sym3<V> strain =
          strain_times_det(j, Vec3<V>{dx.x, dy.x, dz.x}, Vec3<V>{dx.y, dy.y, dz.y}, Vec3<V>{dx.z, dy.z, dz.z});
      for (int i = 0; i < 6; ++i) strain[i] = strain[i] * inverse;
      const V correction = third * (dilatation - (strain.xx + strain.yy + strain.zz));
      for (int i = 0; i < 3; ++i) strain[i] = strain[i] + correction;
      Sym3<V> s = stress(g, strain);
      const V mean = third * (s.xx + s.yy + s.zz);
      pressure = fma(mean, j.det, pressure);
      for (int i = 0; i < 3; ++i) s[i] = s[i] - mean;
      Vec3<V> a{zero, zero, zero}, b = a, c = a;
      add_traction(s, j.bc, a);
      add_traction(s, j.ca, b);
      add_traction(s, j.ab, c);
      for (int i = 0; i < 3; ++i) Lines::put(forces[i], g, Lines::at(forces[i], g) + Vec3<V>{a[i], b[i], c[i]});
    }
    pressure = pressure * share;
    geometry.forget();
    ASHLAR_UNROLL
    for (int g = 0; g < Base::gauss_points; ++g) {
      const Jacobian<V> j = geometry.jacobian_at(g);
      for (int i = 0; i < 3; ++i) {
        const Vec3<V> force = Lines::at(forces[i], g);
        Lines::put(forces[i], g,
                   {fma(pressure, j.bc[i], force.x), fma(pressure, j.ca[i], force.y), fma(pressure, j.ab[i], force.z)});
      }
    }
    for (int i = 0; i < 3; ++i) {
      Lines::to_corners(forces[i], f[i]);
      for (int k = 0; k < corners; ++k) f[i][k] = weight * f[i][k];
    }
  }
};

template <class V>
struct Hex8BBar : BBar<Hex8<V>, V> {};
template <class V>
struct Wedge6BBar : BBar<Wedge6<V>, V> {};

/// The change of volume is the mean over the corners of what the elements around each corner have together (average nodal
/// volume; Bonet & Burton 1998), and the mean stress in the forces is the same mean of that of the elements. This mean is
/// its own transpose by volume and enlarges nothing: forces belong to an energy, never above that of Tet4, whose bound of
/// stiffness then holds.
template <class V>
struct Tet4Averaged : Tet4<V> {
  using S = Scalar<V>;

  template <class Stress>
  struct AtMeanDilatation {
    Stress& stress;
    ASHLAR_HD Sym3<V> operator()(int g, Sym3<V> strain) const {
      const V correction = V(S(1.0 / 3)) * (stress.dilatation(g) - (strain.xx + strain.yy + strain.zz));
      for (int i = 0; i < 3; ++i) strain[i] = strain[i] + correction;
      return stress(g, strain);
    }
  };
  template <class Stress>
  struct Averaged {
    Stress& stress;
    ASHLAR_HD Sym3<V> operator()(int g, const Sym3<V>&) const { return stress.averaged_stress(g); }
  };

  /// Corner forces, N; see Hex8::force. Of `stress.averaged_stress(gauss)`, where it knows the means, else of the strain
  /// with `stress.dilatation(gauss)`; one that knows no neighbours gets the element's own strain.
  template <class Stress>
  ASHLAR_HD static void force(const V (&x)[3][4], const V (&u)[3][4], V (&f)[3][4], Stress& stress) {
    if constexpr (requires { stress.averaged_stress(0); }) {
      Averaged<Stress> averaged{stress};
      Tet4<V>::force(x, u, f, averaged);
    } else if constexpr (requires { stress.dilatation(0); }) {
      AtMeanDilatation<Stress> at{stress};
      Tet4<V>::force(x, u, f, at);
    } else {
      Tet4<V>::force(x, u, f, stress);
    }
  }
};
/// Whether elements take means over their neighbourhood.
template <template <class> class Element>
inline constexpr bool is_averaged = false;
template <>
inline constexpr bool is_averaged<Tet4Averaged> = true;

template <class V>
struct GaussTable<Tet4Averaged<V>> : GaussTable<Tet4<V>> {};
template <class V>
struct GaussTable<Hex8BBar<V>> : GaussTable<Hex8<V>> {};
template <class V>
struct GaussTable<Wedge6BBar<V>> : GaussTable<Wedge6<V>> {};

}  // namespace ashlar
