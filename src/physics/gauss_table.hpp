#pragma once
#include "physics/shapes/hex8.hpp"
#include "physics/shapes/tet4.hpp"
#include "physics/shapes/wedge6.hpp"

/// The derivative tables of the three shapes under one name, for scalar fields: heat and volumes are written once over
/// them.
namespace ashlar {

/// Specialised per shape. `factor` is the quadrature weight with the scale of the table in it: the sum over Gauss
/// points of factor * det is the volume, and what goes back to corners is to be multiplied by it.
template <class Element>
struct GaussTable;

template <class V>
struct GaussTable<Hex8<V>> {
  using Table = typename Hex8<V>::Table;
  static constexpr double factor = Hex8<V>::force_scale;

  /// Corner values in VTK order.
  ASHLAR_HD static Table of(const V (&values)[8]) {
    V ordered[8];
    Hex8<V>::to_bit_order(values, ordered);
    return Hex8<V>::derivatives(ordered);
  }
  /// Derivatives along the three parametric directions at Gauss point g.
  ASHLAR_HD static Vec3<V> at(const Table& t, int g) {
    return {t.xi[Hex8<V>::xi_line(g)], t.eta[Hex8<V>::eta_line(g)], t.zeta[Hex8<V>::zeta_line(g)]};
  }
  ASHLAR_HD static void put(Table& t, int g, const Vec3<V>& d) {
    t.xi[Hex8<V>::xi_line(g)] = d.x;
    t.eta[Hex8<V>::eta_line(g)] = d.y;
    t.zeta[Hex8<V>::zeta_line(g)] = d.z;
  }
  /// Transpose of of().
  ASHLAR_HD static void to_corners(const Table& t, V (&values)[8]) {
    V ordered[8];
    Hex8<V>::gather(t, ordered);
    for (int k = 0; k < 8; ++k) values[k] = ordered[Hex8<V>::bit_order(k)];
  }
};

template <class V>
struct GaussTable<Wedge6<V>> {
  using Table = typename Wedge6<V>::Table;
  static constexpr double factor = Wedge6<V>::weight;

  ASHLAR_HD static Table of(const V (&values)[6]) { return Wedge6<V>::derivatives(values); }
  ASHLAR_HD static Vec3<V> at(const Table& t, int g) { return {t.r[g / 3], t.s[g / 3], t.zeta[g % 3]}; }
  ASHLAR_HD static void put(Table& t, int g, const Vec3<V>& d) {
    t.r[g / 3] = d.x;
    t.s[g / 3] = d.y;
    t.zeta[g % 3] = d.z;
  }
  ASHLAR_HD static void to_corners(const Table& t, V (&values)[6]) { Wedge6<V>::gather(t, values); }
};

template <class V>
struct GaussTable<Tet4<V>> {
  using Table = typename Tet4<V>::Table;
  static constexpr double factor = Tet4<V>::weight;

  ASHLAR_HD static Table of(const V (&values)[4]) { return Tet4<V>::derivatives(values); }
  ASHLAR_HD static Vec3<V> at(const Table& t, int) { return {t.r, t.s, t.t}; }
  ASHLAR_HD static void put(Table& t, int, const Vec3<V>& d) { t = {d.x, d.y, d.z}; }
  ASHLAR_HD static void to_corners(const Table& t, V (&values)[4]) { Tet4<V>::gather(t, values); }
};

/// Tables of the three coordinates and the Jacobian they give at one Gauss point.
template <class Element, class V>
struct ElementGeometry {
  typename GaussTable<Element>::Table x, y, z;

  ASHLAR_HD explicit ElementGeometry(const V (&points)[3][Element::corners])
      : x(GaussTable<Element>::of(points[0])),
        y(GaussTable<Element>::of(points[1])),
        z(GaussTable<Element>::of(points[2])) {}

  /// What was worked out from the tables is worked out again from here on, see ashlar::forget().
  ASHLAR_HD void forget() {
    for (int g = 0; g < Element::gauss_points; ++g)
      for (auto* t : {&x, &y, &z}) {
        Vec3<V> d = GaussTable<Element>::at(*t, g);
        for (int i = 0; i < 3; ++i) ashlar::forget(d[i]);
        GaussTable<Element>::put(*t, g, d);
      }
  }

  ASHLAR_HD Jacobian<V> jacobian_at(int g) const {
    const Vec3<V> dx = GaussTable<Element>::at(x, g), dy = GaussTable<Element>::at(y, g),
                  dz = GaussTable<Element>::at(z, g);
    return jacobian(Vec3<V>{dx.x, dy.x, dz.x}, Vec3<V>{dx.y, dy.y, dz.y}, Vec3<V>{dx.z, dy.z, dz.z});
  }
};

/// Integral of N_k dV of every corner, m^3; x [component][corner, VTK order], m. Same Gauss points as stress and heat.
template <class Element, class V>
ASHLAR_HD void corner_volumes(const V (&x)[3][Element::corners], V (&volumes)[Element::corners]) {
  using S = Scalar<V>;
  const ElementGeometry<Element, V> geometry(x);
  for (int k = 0; k < Element::corners; ++k) volumes[k] = V(S(0));
  ASHLAR_UNROLL
  for (int g = 0; g < Element::gauss_points; ++g) {
    const V volume = V(S(GaussTable<Element>::factor)) * geometry.jacobian_at(g).det;
    for (int k = 0; k < Element::corners; ++k) volumes[k] = fma(V(S(Element::shape(g, k))), volume, volumes[k]);
  }
}

}  // namespace ashlar
