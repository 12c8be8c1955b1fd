#pragma once
#include "physics/shapes/jacobian.hpp"

/// Linear tetrahedron, one Gauss point at the centroid, weight 1/6.
namespace ashlar {

template <class V>
struct Tet4 {
  using S = Scalar<V>;
  static constexpr int corners = 4;
  static constexpr int gauss_points = 1;
  static constexpr double weight = 1.0 / 6.0;

  struct Table {
    V r, s, t;
  };
  ASHLAR_HD static Table derivatives(const V (&v)[4]) { return {v[1] - v[0], v[2] - v[0], v[3] - v[0]}; }

  /// Transpose of derivatives().
  ASHLAR_HD static void gather(const Table& t, V (&f)[4]) {
    f[1] = t.r;
    f[2] = t.s;
    f[3] = t.t;
    f[0] = -(f[1] + f[2] + f[3]);
  }

  /// Corner forces, N; see Hex8::force.
  template <class Stress>
  ASHLAR_HD static void force(const V (&x)[3][4], const V (&u)[3][4], V (&f)[3][4], Stress& stress) {
    Table tx[3], tu[3];
    for (int i = 0; i < 3; ++i) {
      tx[i] = derivatives(x[i]);
      tu[i] = derivatives(u[i]);
    }
    const V zero = V(S(0));
    Vec3<V> pa{zero, zero, zero}, pb{zero, zero, zero}, pc{zero, zero, zero};
    gauss_point_force<V>(0, V(S(weight)), {tx[0].r, tx[1].r, tx[2].r}, {tx[0].s, tx[1].s, tx[2].s},
                         {tx[0].t, tx[1].t, tx[2].t}, {tu[0].r, tu[1].r, tu[2].r}, {tu[0].s, tu[1].s, tu[2].s},
                         {tu[0].t, tu[1].t, tu[2].t}, stress, pa, pb, pc);
    for (int i = 0; i < 3; ++i) gather({pa[i], pb[i], pc[i]}, f[i]);
  }

  static constexpr double shape(int, int) { return 0.25; }
};

}  // namespace ashlar
