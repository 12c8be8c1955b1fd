#pragma once
#include "physics/shapes/jacobian.hpp"

/// Trilinear hexahedron, 2x2x2 Gauss, sum-factorised: a derivative along one parametric direction depends on the other
/// two only, so the four edge differences of each direction give all eight Gauss points (design in ARCHITECTURE.md,
/// "Elements"). Corners come in VTK order and are used in bit order (xi + 2 eta + 4 zeta); Gauss point g lies at bits
/// (xi, eta, zeta) of g. Tables are scaled: dx/dxi = scale * table; the scale cancels in strains and enters forces as
/// scale^3.
namespace ashlar {

template <class V>
struct Hex8 {
  using S = Scalar<V>;
  static constexpr int corners = 8;
  static constexpr int gauss_points = 8;
  static constexpr double near_far = 0.26794919243112270647;     // (1 - g) / (1 + g), g = 1/sqrt(3): 2 - sqrt(3)
  static constexpr double near_weight = 0.78867513459481288225;  // (1 + g) / 2
  static constexpr double scale = 0.5 * near_weight * near_weight;
  static constexpr double force_scale = scale * scale * scale;

  ASHLAR_HD static constexpr int bit_order(int corner) {
    return (corner & 4) | ((corner & 2) ? (3 - (corner & 1)) : (corner & 1));
  }

  /// Scaled derivatives of one field: entry of a direction is indexed by the bits of the other two, lower one first.
  struct Table {
    V xi[4], eta[4], zeta[4];
  };

  /// Four corner-line values to four Gauss-line values (both scaled by 1/near_weight^2).
  ASHLAR_HD static void to_gauss(const V& d0, const V& d1, const V& d2, const V& d3, V (&out)[4]) {
    const V r = V(S(near_far));
    const V t0 = fma(r, d1, d0), t1 = fma(r, d0, d1), t2 = fma(r, d3, d2), t3 = fma(r, d2, d3);
    out[0] = fma(r, t2, t0);
    out[1] = fma(r, t3, t1);
    out[2] = fma(r, t0, t2);
    out[3] = fma(r, t1, t3);
  }

  /// Derivative table of a field given at the corners in bit order.
  ASHLAR_HD static Table derivatives(const V (&v)[8]) {
    Table t;
    to_gauss(v[1] - v[0], v[3] - v[2], v[5] - v[4], v[7] - v[6], t.xi);
    to_gauss(v[2] - v[0], v[3] - v[1], v[6] - v[4], v[7] - v[5], t.eta);
    to_gauss(v[4] - v[0], v[5] - v[1], v[6] - v[2], v[7] - v[3], t.zeta);
    return t;
  }

  /// Transpose of derivatives(): corner values in bit order.
  ASHLAR_HD static void gather(const Table& t, V (&f)[8]) {
    V e[4], h[4], k[4];
    to_gauss(t.xi[0], t.xi[1], t.xi[2], t.xi[3], e);
    to_gauss(t.eta[0], t.eta[1], t.eta[2], t.eta[3], h);
    to_gauss(t.zeta[0], t.zeta[1], t.zeta[2], t.zeta[3], k);
    f[0] = -(e[0] + h[0] + k[0]);
    f[1] = e[0] - h[1] - k[1];
    f[2] = h[0] - e[1] - k[2];
    f[3] = e[1] + h[1] - k[3];
    f[4] = k[0] - e[2] - h[2];
    f[5] = e[2] - h[3] + k[1];
    f[6] = h[2] - e[3] + k[2];
    f[7] = e[3] + h[3] + k[3];
  }

  ASHLAR_HD static int xi_line(int gauss) { return gauss >> 1; }                         // eta + 2 zeta
  ASHLAR_HD static int eta_line(int gauss) { return (gauss & 1) | ((gauss >> 1) & 2); }  // xi + 2 zeta
  ASHLAR_HD static int zeta_line(int gauss) { return gauss & 3; }                        // xi + 2 eta

  ASHLAR_HD static void to_bit_order(const V (&v)[8], V (&w)[8]) {
    for (int k = 0; k < 8; ++k) w[bit_order(k)] = v[k];
  }

  /// Corner forces f [component][corner, VTK order], N, of the stress field `stress(gauss, strain)`; x in m, u in m.
  template <class Stress>
  ASHLAR_HD static void force(const V (&x)[3][8], const V (&u)[3][8], V (&f)[3][8], Stress& stress) {
    Table tx[3], tu[3], tp[3];
    for (int i = 0; i < 3; ++i) {
      V w[8];
      to_bit_order(x[i], w);
      tx[i] = derivatives(w);
      to_bit_order(u[i], w);
      tu[i] = derivatives(w);
      for (int j = 0; j < 4; ++j) tp[i].xi[j] = tp[i].eta[j] = tp[i].zeta[j] = V(S(0));
    }
    ASHLAR_UNROLL
    for (int g = 0; g < 8; ++g) {
      const int p = xi_line(g), q = eta_line(g), r = zeta_line(g);
      Vec3<V> pa{tp[0].xi[p], tp[1].xi[p], tp[2].xi[p]};
      Vec3<V> pb{tp[0].eta[q], tp[1].eta[q], tp[2].eta[q]};
      Vec3<V> pc{tp[0].zeta[r], tp[1].zeta[r], tp[2].zeta[r]};
      gauss_point_force<V>(g, V(S(force_scale)), {tx[0].xi[p], tx[1].xi[p], tx[2].xi[p]},
                           {tx[0].eta[q], tx[1].eta[q], tx[2].eta[q]}, {tx[0].zeta[r], tx[1].zeta[r], tx[2].zeta[r]},
                           {tu[0].xi[p], tu[1].xi[p], tu[2].xi[p]}, {tu[0].eta[q], tu[1].eta[q], tu[2].eta[q]},
                           {tu[0].zeta[r], tu[1].zeta[r], tu[2].zeta[r]}, stress, pa, pb, pc);
      for (int i = 0; i < 3; ++i) {
        tp[i].xi[p] = pa[i];
        tp[i].eta[q] = pb[i];
        tp[i].zeta[r] = pc[i];
      }
    }
    for (int i = 0; i < 3; ++i) {
      V w[8];
      gather(tp[i], w);
      for (int k = 0; k < 8; ++k) f[i][k] = w[bit_order(k)];
    }
  }

  /// Shape functions at Gauss point g, corner k in VTK order.
  static constexpr double shape(int g, int k) {
    const int b = bit_order(k);
    double n = 1;
    for (int axis = 0; axis < 3; ++axis) n *= ((g >> axis) & 1) == ((b >> axis) & 1) ? near_weight : 1 - near_weight;
    return n;
  }
};

}  // namespace ashlar
