#pragma once
#include "kernels/block_force.hpp"
#include "physics/bbar.hpp"

/// What elements share with their neighbours (Tet4Averaged): dilatation from elements to corners and back, stress, then
/// its mean the same way.
namespace ashlar {

/// The corners of averaged elements; those of one batch are its own, so that no mean crosses a change of material.
template <class Real>
struct AveragingView {
  int corner_count = 0;
  const int* first = nullptr;   ///< [corners + 1] into around
  const int* around = nullptr;  ///< Gauss points of the elements around a corner
  const Real* share = nullptr;  ///< of each in the volume around the corner
  Real* value = nullptr;        ///< [corners]
};

/// One element -> its own dilatation.
template <class Real>
struct OwnDilatation {
  BodyView<Real> body;
  BatchView batch;

  struct Keeper {
    Real& out;
    ASHLAR_HD Sym3<Real> operator()(int, const Sym3<Real>& strain) const {
      out = strain.xx + strain.yy + strain.zz;
      return {};
    }
  };

  ASHLAR_HD void operator()(int i) const {
    Real x[3][4], u[3][4], f[3][4];
    read_corners(body, batch, i, x, u);
    const Keeper keeper{body.averaged[batch.gauss(i, 0)]};
    Tet4<Real>::force(x, u, f, keeper);
  }
};

/// One corner -> mean over the elements around it.
template <class Real>
struct CornerMean {
  AveragingView<Real> corners;
  const Real* of;  ///< [Gauss points]

  ASHLAR_HD void operator()(int k) const {
    Real sum = 0;
    for (int j = corners.first[k]; j < corners.first[k + 1]; ++j)
      sum = fma(corners.share[j], of[corners.around[j]], sum);
    corners.value[k] = sum;
  }
};

/// One element -> mean over its corners.
template <class Real>
struct ElementMean {
  AveragingView<Real> corners;
  BatchView batch;
  const int* corner;  ///< [corners of the batch's elements]
  Real* out;          ///< [Gauss points]

  ASHLAR_HD void operator()(int i) const {
    const int* const c = corner + 4 * i;
    const Real* const v = corners.value;
    out[batch.gauss(i, 0)] = Real(0.25) * (v[c[0]] + v[c[1]] + v[c[2]] + v[c[3]]);
  }
};

/// One element -> stress at the dilatation of its neighbourhood, and the mean of it for its neighbours.
template <template <class> class Element, bool Warm, class Point, class Real>
struct AveragedStress {
  BodyView<Real> body;
  BatchView batch;
  Point law;

  struct Keeper {
    const PointStress<Element<Real>, Warm, Real, Point, StoredPoints<Real>>& stress;
    ASHLAR_HD Real dilatation(int g) const { return stress.points.averaged(g); }
    ASHLAR_HD Sym3<Real> operator()(int g, const Sym3<Real>& strain) const {
      const Sym3<Real> s = stress(g, strain);
      stress.points.keep(g, s);
      return {};
    }
  };

  ASHLAR_HD void operator()(int i) const {
    Real x[3][4], u[3][4], f[3][4];
    read_corners(body, batch, i, x, u);
    const StoredPoints<Real> points{body, batch, i};
    const PointStress<Element<Real>, Warm, Real, Point, StoredPoints<Real>> stress(law, points);
    const Keeper keeper{stress};
    Element<Real>::force(x, u, f, keeper);
  }
};

/// One element -> its stress with the mean of its neighbourhood: what its corner forces are made of.
template <class Real>
struct BalancedStress {
  BodyView<Real> body;
  BatchView batch;

  ASHLAR_HD void operator()(int i) const {
    const StoredPoints<Real> points{body, batch, i};
    const Sym3<Real> s = points.averaged_stress(0);
    for (int c = 0; c < 6; ++c) body.stress[6 * batch.gauss(i, 0) + c] = s[c];
  }
};

}  // namespace ashlar
