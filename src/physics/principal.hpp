#pragma once
#include "base/tensor.hpp"

namespace ashlar {

/// Principal values and directions of a symmetric tensor, largest value first.
template <class Real>
struct Principal {
  Real value[3];
  Vec3<Real> direction[3];
};

/// By cyclic Jacobi rotations, a fixed number of sweeps: only / and sqrt, so the same bits on every machine (numerics
/// 4). Convergence is quadratic: the sixth sweep finds nothing left to do in double precision.
template <class Real>
ASHLAR_HD_CALL Principal<Real> principal(const Sym3<Real>& s) {
  Real a[3][3] = {{s.xx, s.xy, s.zx}, {s.xy, s.yy, s.yz}, {s.zx, s.yz, s.zz}};
  Real v[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (int sweep = 0; sweep < 6; ++sweep)
    for (int pair = 0; pair < 3; ++pair) {
      const int p = pair == 2 ? 1 : 0, q = pair == 0 ? 1 : 2, r = 3 - p - q;
      if (a[p][q] == Real(0)) continue;
      const Real theta = (a[q][q] - a[p][p]) / (Real(2) * a[p][q]);
      const Real size = theta < Real(0) ? -theta : theta;
      const Real tangent = (theta < Real(0) ? Real(-1) : Real(1)) / (size + root(fma(theta, theta, Real(1))));
      const Real cosine = Real(1) / root(fma(tangent, tangent, Real(1))), sine = tangent * cosine;
      a[p][p] = fma(-tangent, a[p][q], a[p][p]);
      a[q][q] = fma(tangent, a[p][q], a[q][q]);
      a[p][q] = a[q][p] = Real(0);
      const Real rp = a[r][p], rq = a[r][q];
      a[r][p] = a[p][r] = fma(cosine, rp, -(sine * rq));
      a[r][q] = a[q][r] = fma(sine, rp, cosine * rq);
      for (int i = 0; i < 3; ++i) {
        const Real ip = v[i][p], iq = v[i][q];
        v[i][p] = fma(cosine, ip, -(sine * iq));
        v[i][q] = fma(sine, ip, cosine * iq);
      }
    }
  int order[3] = {0, 1, 2};
  const auto sort = [&](int i, int j) {
    if (a[order[i]][order[i]] >= a[order[j]][order[j]]) return;
    const int k = order[i];
    order[i] = order[j];
    order[j] = k;
  };
  sort(0, 1);
  sort(1, 2);
  sort(0, 1);
  Principal<Real> out;
  for (int i = 0; i < 3; ++i) {
    const int k = order[i];
    out.value[i] = a[k][k];
    out.direction[i] = {v[0][k], v[1][k], v[2][k]};
  }
  return out;
}

/// The tensor with these principal values.
template <class Real>
ASHLAR_HD Sym3<Real> from_principal(const Principal<Real>& p) {
  Sym3<Real> s;
  for (int i = 0; i < 3; ++i) {
    const Vec3<Real>& d = p.direction[i];
    const Vec3<Real> scaled = p.value[i] * d;
    s.xx = fma(scaled.x, d.x, s.xx);
    s.yy = fma(scaled.y, d.y, s.yy);
    s.zz = fma(scaled.z, d.z, s.zz);
    s.xy = fma(scaled.x, d.y, s.xy);
    s.yz = fma(scaled.y, d.z, s.yz);
    s.zx = fma(scaled.z, d.x, s.zx);
  }
  return s;
}

}  // namespace ashlar
