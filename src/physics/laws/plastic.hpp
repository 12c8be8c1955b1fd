#pragma once
#include "physics/laws/elastic.hpp"

/// What laws with memory share: all remember first the strain that bears no stress (a plastic strain; or that of the
/// initial stress, with its sign turned), then one measure of how far the point is gone, then the energy that it lost.
/// The state of a point is what it went through; stress follows from strain and state, so
/// that a trial step that is taken back leaves nothing behind.
namespace ashlar {

template <class V>
struct PlasticHistory {
  static constexpr int size = 8;
  Sym3<V> strain;   ///< plastic strain, engineering shear
  V equivalent{};   ///< equivalent plastic strain: integral of sqrt(2/3 de:de), e the deviator of plastic strain
  V dissipation{};  ///< plastic work, J/m^3
  ASHLAR_HD V& operator[](int i) { return i < 6 ? strain[i] : i == 6 ? equivalent : dissipation; }
  ASHLAR_HD const V& operator[](int i) const { return i < 6 ? strain[i] : i == 6 ? equivalent : dissipation; }
};

/// A length of the element in lane l, see LengthAcross.
template <class Length>
struct InLane {
  const Length& length;
  int l;
  template <class Real>
  ASHLAR_HD Real operator()(const Vec3<Real>& normal) const {
    return length(l, normal);
  }
};

/// Stress of a strain without heat, elastic where `law.yields(trial stress, history)` says no; moves the history on.
/// Lanes that are more than elastic go one by one through `law.pull_back(stress, history)`, of sized laws with the
/// length of the element as well.
template <class Law, class V, class History, class... Length>
ASHLAR_HD Sym3<V> plastic_stress(const Law& law, const Sym3<V>& strain, History& history, const Length&... length) {
  Sym3<V> elastic_strain;
  for (int i = 0; i < 6; ++i) elastic_strain[i] = strain[i] - history.strain[i];
  Sym3<V> stress = law.elastic().stress(elastic_strain);
  const auto test = law.test(stress);
  for (int l = 0; l < lane_count<V>; ++l) {
    if (!law.yields(test, history, l)) continue;
    Sym3<Scalar<V>> s;
    typename Law::template History<Scalar<V>> h;
    for (int i = 0; i < 6; ++i) s[i] = lane(stress[i], l);
    for (int i = 0; i < h.size; ++i) h[i] = lane(history[i], l);
    law.pull_back(s, h, InLane<Length>{length, l}...);
    for (int i = 0; i < 6; ++i) set_lane(stress[i], l, s[i]);
    for (int i = 0; i < h.size; ++i) set_lane(history[i], l, h[i]);
  }
  return stress;
}

/// On a plane with this normal.
template <class T>
ASHLAR_HD Vec3<T> traction(const Sym3<T>& s, const Vec3<T>& n) {
  return {fma(s.zx, n.z, fma(s.xy, n.y, s.xx * n.x)), fma(s.yz, n.z, fma(s.yy, n.y, s.xy * n.x)),
          fma(s.zz, n.z, fma(s.yz, n.y, s.zx * n.x))};
}

/// Takes from a stress what the strain `opening` across a plane and the traction `along` it (both less than before)
/// bear; n is the plane's unit normal, `part` elastic.
template <class Real>
ASHLAR_HD void take_from_plane(Sym3<Real>& s, const Vec3<Real>& n, const Elastic::Point<Real>& part, Real opening,
                               const Vec3<Real>& along) {
  const Real side = opening * part.lambda, both = opening * (part.shear + part.shear);
  s.xx -= fma(both * n.x, n.x, side) + Real(2) * along.x * n.x;
  s.yy -= fma(both * n.y, n.y, side) + Real(2) * along.y * n.y;
  s.zz -= fma(both * n.z, n.z, side) + Real(2) * along.z * n.z;
  s.xy -= fma(both * n.x, n.y, fma(along.x, n.y, along.y * n.x));
  s.yz -= fma(both * n.y, n.z, fma(along.y, n.z, along.z * n.y));
  s.zx -= fma(both * n.z, n.x, fma(along.z, n.x, along.x * n.z));
}

/// The two invariants that cones are made of.
template <class V>
struct Invariants {
  V trace;  ///< I1
  V shear;  ///< sqrt(J2), never quite 0
};
template <class V>
ASHLAR_HD Sym3<V> deviator(const Sym3<V>& s, const V& trace) {
  const V mean = trace * V(Scalar<V>(1.0 / 3));
  return {s.xx - mean, s.yy - mean, s.zz - mean, s.xy, s.yz, s.zx};
}
template <class V>
ASHLAR_HD Invariants<V> invariants(const Sym3<V>& s) {
  const V trace = s.xx + s.yy + s.zz;
  const Sym3<V> d = deviator(s, trace);
  const V squares = fma(d.zz, d.zz, fma(d.yy, d.yy, d.xx * d.xx));
  const V shears = fma(d.zx, d.zx, fma(d.yz, d.yz, fma(d.xy, d.xy, V(least_square<Scalar<V>>))));
  return {trace, normal_root(fma(V(Scalar<V>(0.5)), squares, shears))};
}

/// A bound of the largest principal stress, as trace, and the demand on the cone inside a Mohr-Coulomb pyramid, as
/// shear.
template <class V>
ASHLAR_HD Invariants<V> pyramid_test(const Sym3<V>& stress, Scalar<V> cone_slope) {
  const Invariants<V> i = invariants(stress);
  using S = Scalar<V>;
  return {fma(V(S(1.0 / 3)), i.trace, V(S(1.1547005383792515290)) * i.shear), fma(V(cone_slope), i.trace, i.shear)};
}

}  // namespace ashlar
