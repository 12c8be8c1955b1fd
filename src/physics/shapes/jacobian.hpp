#pragma once
#include "base/tensor.hpp"

/// What every isoparametric element shares at one Gauss point, written once for float, double and vector packs.
/// a, b, c are the tangents dx/dxi, dx/deta, dx/dzeta; gradients follow from the cofactors b x c, c x a, a x b over
/// det.
namespace ashlar {

template <class V>
struct Jacobian {
  Vec3<V> bc, ca, ab;  ///< cofactors: grad xi = bc / det, grad eta = ca / det, grad zeta = ab / det
  V det;
};

template <class V>
ASHLAR_HD Jacobian<V> jacobian(const Vec3<V>& a, const Vec3<V>& b, const Vec3<V>& c) {
  const Vec3<V> bc = cross(b, c);
  return {bc, cross(c, a), cross(a, b), dot(a, bc)};
}

/// Strain times det from the parametric derivatives ha, hb, hc of the displacement. Engineering shear.
template <class V>
ASHLAR_HD Sym3<V> strain_times_det(const Jacobian<V>& j, const Vec3<V>& ha, const Vec3<V>& hb, const Vec3<V>& hc) {
  Sym3<V> e;
  e.xx = fma(hc.x, j.ab.x, fma(hb.x, j.ca.x, ha.x * j.bc.x));
  e.yy = fma(hc.y, j.ab.y, fma(hb.y, j.ca.y, ha.y * j.bc.y));
  e.zz = fma(hc.z, j.ab.z, fma(hb.z, j.ca.z, ha.z * j.bc.z));
  e.xy = fma(hc.y, j.ab.x, fma(hb.y, j.ca.x, fma(ha.y, j.bc.x, fma(hc.x, j.ab.y, fma(hb.x, j.ca.y, ha.x * j.bc.y)))));
  e.yz = fma(hc.z, j.ab.y, fma(hb.z, j.ca.y, fma(ha.z, j.bc.y, fma(hc.y, j.ab.z, fma(hb.y, j.ca.z, ha.y * j.bc.z)))));
  e.zx = fma(hc.x, j.ab.z, fma(hb.x, j.ca.z, fma(ha.x, j.bc.z, fma(hc.z, j.ab.x, fma(hb.z, j.ca.x, ha.z * j.bc.x)))));
  return e;
}

/// p += sigma n: the force through one cofactor vector.
template <class V>
ASHLAR_HD void add_traction(const Sym3<V>& s, const Vec3<V>& n, Vec3<V>& p) {
  p.x = fma(s.zx, n.z, fma(s.xy, n.y, fma(s.xx, n.x, p.x)));
  p.y = fma(s.yz, n.z, fma(s.yy, n.y, fma(s.xy, n.x, p.y)));
  p.z = fma(s.zz, n.z, fma(s.yz, n.y, fma(s.zx, n.x, p.z)));
}

/// p += F sigma n, where F is 1 and the displacement's derivatives along x, y and z.
template <class V>
ASHLAR_HD void add_turned_traction(const Sym3<V>& s, const Vec3<V>& n, const Vec3<V> (&along)[3], Vec3<V>& p) {
  Vec3<V> t{V(Scalar<V>(0)), V(Scalar<V>(0)), V(Scalar<V>(0))};
  add_traction(s, n, t);
  for (int i = 0; i < 3; ++i)
    p[i] = fma(along[2][i], t.z, fma(along[1][i], t.y, fma(along[0][i], t.x, p[i] + t[i])));
}

/// The force of one Gauss point where the element turns and moves far: `stress` takes Green's strain and gives the
/// second Piola-Kirchhoff stress, both in axes that turn with the element, and the force goes through the deformation
/// gradient. `stress` may have `stress.volume(volume of the point)`, called after its stress.
template <class V, class Stress>
ASHLAR_HD void turning_point_force(int gauss, const V& weight, const Jacobian<V>& j, const Vec3<V>& ha,
                                   const Vec3<V>& hb, const Vec3<V>& hc, Stress& stress, Vec3<V>& pa, Vec3<V>& pb,
                                   Vec3<V>& pc) {
  const V inverse = reciprocal(j.det), half = V(Scalar<V>(0.5));
  Vec3<V> along[3];  // du / dx, du / dy, du / dz
  for (int k = 0; k < 3; ++k)
    for (int i = 0; i < 3; ++i) along[k][i] = inverse * fma(hc[i], j.ab[k], fma(hb[i], j.ca[k], ha[i] * j.bc[k]));
  Sym3<V> strain;
  for (int k = 0; k < 3; ++k) strain[k] = fma(half, dot(along[k], along[k]), along[k][k]);
  strain.xy = along[0].y + along[1].x + dot(along[0], along[1]);
  strain.yz = along[1].z + along[2].y + dot(along[1], along[2]);
  strain.zx = along[2].x + along[0].z + dot(along[2], along[0]);
  Sym3<V> s = stress(gauss, strain);
  if constexpr (requires { stress.volume(j.det); }) stress.volume(j.det * weight);
  for (int i = 0; i < 6; ++i) s[i] = s[i] * weight;
  add_turned_traction(s, j.bc, along, pa);
  add_turned_traction(s, j.ca, along, pb);
  add_turned_traction(s, j.ab, along, pc);
}

/// One Gauss point of the element force: strain, law, traction through the three parametric directions.
/// `stress(gauss, strain)` returns the stress, Pa. One that is linear in the strain may have instead
/// `stress.weighted(gauss, strain times det, det, inverse of det, weight)`, weight times the stress: then only its
/// constants are multiplied.
template <class V, class Stress>
ASHLAR_HD void gauss_point_force(int gauss, const V& weight, const Vec3<V>& a, const Vec3<V>& b, const Vec3<V>& c,
                                 const Vec3<V>& ha, const Vec3<V>& hb, const Vec3<V>& hc, Stress& stress, Vec3<V>& pa,
                                 Vec3<V>& pb, Vec3<V>& pc) {
  const Jacobian<V> j = jacobian(a, b, c);
  if constexpr (requires { Stress::turning; })
    return turning_point_force(gauss, weight, j, ha, hb, hc, stress, pa, pb, pc);
  const V inverse = reciprocal(j.det);
  Sym3<V> strain = strain_times_det(j, ha, hb, hc), s;
  if constexpr (requires { stress.weighted(gauss, strain, j.det, inverse, weight); }) {
    s = stress.weighted(gauss, strain, j.det, inverse, weight);
  } else {
    for (int i = 0; i < 6; ++i) strain[i] = strain[i] * inverse;
    s = stress(gauss, strain);
    for (int i = 0; i < 6; ++i) s[i] = s[i] * weight;
  }
  add_traction(s, j.bc, pa);
  add_traction(s, j.ca, pb);
  add_traction(s, j.ab, pc);
}

}  // namespace ashlar
