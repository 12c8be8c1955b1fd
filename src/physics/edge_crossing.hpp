#pragma once
#include "base/tensor.hpp"

namespace ashlar {

/// Where two sharp edges pass each other: the points of both lines that are nearest to each other.
template <class Real>
struct EdgeCrossing {
  bool parallel = false;    ///< nearly: nothing else is set
  Vec3<Real> normal;        ///< from the other body to the own one
  Real gap = 0;             ///< m, negative where the bodies lie in each other
  Real own = 0, other = 0;  ///< place along the edges, 0 to 1 from their first to their second node
  /// Largest sine by which a face of either body rises towards the other one: they touch where neither is positive.
  Real own_leans = -1, other_leans = -1;
};

/// Edges from a to b, a face on each side through c or d; `own` and `other`. Places from the other edge's a on, m.
/// Touching edges are a face of the Minkowski difference of both bodies: the plane through both leaves all four faces
/// behind. The gap's derivative by the places of the nodes is the normal times their weights, so it has a potential.
template <class Real>
ASHLAR_HD EdgeCrossing<Real> cross_edges(const Vec3<Real>& own_a, const Vec3<Real>& own_b, const Vec3<Real>& own_c,
                                         const Vec3<Real>& own_d, const Vec3<Real>& other_b, const Vec3<Real>& other_c,
                                         const Vec3<Real>& other_d) {
  constexpr Real least_sine = Real(0.01);
  const Vec3<Real> along = own_b - own_a, across = cross(along, other_b);
  const Real size = dot(across, across);
  EdgeCrossing<Real> crossing;
  crossing.parallel = !(size > least_sine * least_sine * dot(along, along) * dot(other_b, other_b));
  if (crossing.parallel) return crossing;
  crossing.own = dot(cross(other_b, own_a), across) / size;
  crossing.other = dot(cross(along, own_a), across) / size;
  crossing.normal = (Real(1) / norm(across)) * across;
  Real rise[4];
  const Vec3<Real> faces[4] = {own_c - own_a, own_d - own_a, other_c, other_d};
  Real outward = 0;
  for (int f = 0; f < 4; ++f) {
    rise[f] = dot(faces[f], crossing.normal) / norm(faces[f]);
    outward = f < 2 ? outward + rise[f] : outward - rise[f];
  }
  if (outward < Real(0)) crossing.normal = Real(-1) * crossing.normal;
  crossing.gap = dot(own_a, crossing.normal);
  for (int f = 0; f < 4; ++f) {
    const Real leans = (f < 2) == (outward < Real(0)) ? rise[f] : -rise[f];
    Real& most = f < 2 ? crossing.own_leans : crossing.other_leans;
    if (leans > most) most = leans;
  }
  return crossing;
}

}  // namespace ashlar
