#pragma once
#include "physics/shapes/jacobian.hpp"

/// Linear wedge, 3 x 2 Gauss: triangle points (1/6,1/6), (2/3,1/6), (1/6,2/3), weight 1/6 each, at zeta = -+1/sqrt(3).
/// The in-plane tangents depend on zeta only and the axial one on the triangle point only, so two and three vectors
/// give all six points. Gauss point g = triangle point + 3 * (upper level).
namespace ashlar {

template <class V>
struct Wedge6 {
  using S = Scalar<V>;
  static constexpr int corners = 6;
  static constexpr int gauss_points = 6;
  static constexpr double weight = 1.0 / 6.0;
  static constexpr double near = 0.78867513459481288225;  // (1 + 1/sqrt(3)) / 2
  static constexpr double far = 1 - near;

  /// Area coordinate i of triangle point t.
  ASHLAR_HD static constexpr double area_coordinate(int t, int i) { return i == t ? 2.0 / 3.0 : 1.0 / 6.0; }

  /// Parametric derivatives of one field: r, s at the two levels, zeta at the three triangle points.
  struct Table {
    V r[2], s[2], zeta[3];
  };

  ASHLAR_HD static Table derivatives(const V (&v)[6]) {
    Table t;
    const V n = V(S(near)), f = V(S(far));
    const V r0 = v[1] - v[0], r1 = v[4] - v[3], s0 = v[2] - v[0], s1 = v[5] - v[3];
    t.r[0] = fma(f, r1, n * r0);
    t.r[1] = fma(f, r0, n * r1);
    t.s[0] = fma(f, s1, n * s0);
    t.s[1] = fma(f, s0, n * s1);
    const V d0 = v[3] - v[0], d1 = v[4] - v[1], d2 = v[5] - v[2];
    for (int p = 0; p < 3; ++p)
      t.zeta[p] = fma(V(S(0.5 * area_coordinate(p, 2))), d2,
                      fma(V(S(0.5 * area_coordinate(p, 1))), d1, V(S(0.5 * area_coordinate(p, 0))) * d0));
    return t;
  }

  /// Transpose of derivatives().
  ASHLAR_HD static void gather(const Table& t, V (&f)[6]) {
    const V n = V(S(near)), w = V(S(far));
    const V r0 = fma(w, t.r[1], n * t.r[0]), r1 = fma(w, t.r[0], n * t.r[1]);
    const V s0 = fma(w, t.s[1], n * t.s[0]), s1 = fma(w, t.s[0], n * t.s[1]);
    V d[3];
    for (int i = 0; i < 3; ++i)
      d[i] = fma(V(S(0.5 * area_coordinate(2, i))), t.zeta[2],
                 fma(V(S(0.5 * area_coordinate(1, i))), t.zeta[1], V(S(0.5 * area_coordinate(0, i))) * t.zeta[0]));
    f[0] = -(r0 + s0 + d[0]);
    f[1] = r0 - d[1];
    f[2] = s0 - d[2];
    f[3] = d[0] - r1 - s1;
    f[4] = r1 + d[1];
    f[5] = s1 + d[2];
  }

  /// Corner forces, N; see Hex8::force.
  template <class Stress>
  ASHLAR_HD static void force(const V (&x)[3][6], const V (&u)[3][6], V (&f)[3][6], Stress& stress) {
    Table tx[3], tu[3], tp[3];
    for (int i = 0; i < 3; ++i) {
      tx[i] = derivatives(x[i]);
      tu[i] = derivatives(u[i]);
      tp[i].r[0] = tp[i].r[1] = tp[i].s[0] = tp[i].s[1] = V(S(0));
      tp[i].zeta[0] = tp[i].zeta[1] = tp[i].zeta[2] = V(S(0));
    }
    ASHLAR_UNROLL
    for (int g = 0; g < 6; ++g) {
      const int l = g / 3, p = g % 3;
      Vec3<V> pa{tp[0].r[l], tp[1].r[l], tp[2].r[l]};
      Vec3<V> pb{tp[0].s[l], tp[1].s[l], tp[2].s[l]};
      Vec3<V> pc{tp[0].zeta[p], tp[1].zeta[p], tp[2].zeta[p]};
      gauss_point_force<V>(g, V(S(weight)), {tx[0].r[l], tx[1].r[l], tx[2].r[l]}, {tx[0].s[l], tx[1].s[l], tx[2].s[l]},
                           {tx[0].zeta[p], tx[1].zeta[p], tx[2].zeta[p]}, {tu[0].r[l], tu[1].r[l], tu[2].r[l]},
                           {tu[0].s[l], tu[1].s[l], tu[2].s[l]}, {tu[0].zeta[p], tu[1].zeta[p], tu[2].zeta[p]}, stress,
                           pa, pb, pc);
      for (int i = 0; i < 3; ++i) {
        tp[i].r[l] = pa[i];
        tp[i].s[l] = pb[i];
        tp[i].zeta[p] = pc[i];
      }
    }
    for (int i = 0; i < 3; ++i) gather(tp[i], f[i]);
  }

  static constexpr double shape(int g, int k) {
    const bool upper = g >= 3;
    return area_coordinate(g % 3, k % 3) * ((k >= 3) == upper ? near : far);
  }
};

}  // namespace ashlar
