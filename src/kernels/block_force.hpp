#pragma once
#include "base/tensor.hpp"
#include "model/view.hpp"

/// Phase block_force: stress of every element, forces at its corners (paper, DoKernel steps 1-3, without a stiffness
/// matrix).
namespace ashlar {

/// The law at the Gauss points of one element, as the element routine calls it: without and with temperature.
template <class Point, class V>
struct ColdStress {
  const Point& law;
  ASHLAR_HD Sym3<V> operator()(int, const Sym3<V>& strain) const { return law.stress(strain); }
};
template <class Point, class V, int gauss_points>
struct WarmStress {
  const Point& law;
  V warming[gauss_points];
  ASHLAR_HD Sym3<V> operator()(int g, const Sym3<V>& strain) const { return law.stress(strain, warming[g]); }
};

/// Corner forces of one element; x, u, f are [component][corner]. `warming(g)` is asked for where Warm.
template <template <class> class Element, bool Warm, class V, class Point, class Warming>
ASHLAR_HD void element_force(const Point& law, const V (&x)[3][Element<V>::corners],
                             const V (&u)[3][Element<V>::corners], const Warming& warming,
                             V (&f)[3][Element<V>::corners]) {
  if constexpr (Warm) {
    WarmStress<Point, V, Element<V>::gauss_points> stress{law, {}};
    for (int g = 0; g < Element<V>::gauss_points; ++g) stress.warming[g] = warming(g);
    Element<V>::force(x, u, f, stress);
  } else {
    ColdStress<Point, V> stress{law};
    Element<V>::force(x, u, f, stress);
  }
}

/// The Gauss-point warming of one element in memory.
template <class Real>
struct StoredWarming {
  const Real* warming;
  BatchView batch;
  int element;
  ASHLAR_HD Real operator()(int g) const { return warming[batch.gauss(element, g)]; }
};

/// Corner coordinates and displacements of one element.
template <int corners, class Real>
ASHLAR_HD void read_corners(const BodyView<Real>& body, const BatchView& batch, int i, Real (&x)[3][corners],
                            Real (&u)[3][corners]) {
  ASHLAR_UNROLL
  for (int k = 0; k < corners; ++k) {
    const int n = 3 * body.nodes.corner_node[batch.slot(i, corners, k)];
    for (int c = 0; c < 3; ++c) {
      x[c][k] = body.x[n + c];
      u[c][k] = body.u[n + c];
    }
  }
}

/// One element -> its own corner slots.
template <template <class> class Element, class Point, class Real, bool Warm>
struct BlockForce {
  BodyView<Real> body;
  BatchView batch;
  Point law;

  ASHLAR_HD void operator()(int i) const {
    constexpr int corners = Element<Real>::corners;
    Real x[3][corners], u[3][corners], f[3][corners];
    read_corners(body, batch, i, x, u);
    element_force<Element, Warm>(law, x, u, StoredWarming<Real>{body.warming, batch, i}, f);
    ASHLAR_UNROLL
    for (int k = 0; k < corners; ++k)
      for (int c = 0; c < 3; ++c) body.corner_force[3 * batch.slot(i, corners, k) + c] = f[c][k];
  }
};

/// One element -> stress at its Gauss points, for output and for laws' checks at converged states.
template <template <class> class Element, class Point, class Real, bool Warm>
struct BlockStress {
  BodyView<Real> body;
  BatchView batch;
  Point law;

  /// Evaluates the same law as the force routine and keeps what it returned.
  template <class Stress>
  struct Keeper {
    Stress& stress;
    Real* out;
    BatchView batch;
    int element;
    ASHLAR_HD Sym3<Real> operator()(int g, const Sym3<Real>& strain) const {
      const Sym3<Real> s = stress(g, strain);
      for (int c = 0; c < 6; ++c) out[6 * batch.gauss(element, g) + c] = s[c];
      return s;
    }
  };

  ASHLAR_HD void operator()(int i) const {
    constexpr int corners = Element<Real>::corners;
    Real x[3][corners], u[3][corners], f[3][corners];
    read_corners(body, batch, i, x, u);
    if constexpr (Warm) {
      WarmStress<Point, Real, Element<Real>::gauss_points> stress{law, {}};
      for (int g = 0; g < Element<Real>::gauss_points; ++g) stress.warming[g] = body.warming[batch.gauss(i, g)];
      Keeper<decltype(stress)> keeper{stress, body.stress, batch, i};
      Element<Real>::force(x, u, f, keeper);
    } else {
      ColdStress<Point, Real> stress{law};
      Keeper<decltype(stress)> keeper{stress, body.stress, batch, i};
      Element<Real>::force(x, u, f, keeper);
    }
  }
};

/// One element -> absolute row sums of its stiffness, in its corner slots (Gershgorin; numerics 3). The columns are the
/// forces of unit displacements through the same element routine, so every shape and law gets the right bound.
template <template <class> class Element, class Point, class Real>
struct StiffnessBound {
  BodyView<Real> body;
  BatchView batch;
  Point law;

  ASHLAR_HD void operator()(int i) const {
    constexpr int corners = Element<Real>::corners;
    Real x[3][corners], u[3][corners], f[3][corners], sum[3][corners];
    read_corners(body, batch, i, x, u);
    for (int k = 0; k < corners; ++k)
      for (int c = 0; c < 3; ++c) sum[c][k] = u[c][k] = Real(0);
    for (int k = 0; k < corners; ++k)
      for (int c = 0; c < 3; ++c) {
        u[c][k] = Real(1);
        element_force<Element, false>(law, x, u, 0, f);
        u[c][k] = Real(0);
        for (int q = 0; q < corners; ++q)
          for (int r = 0; r < 3; ++r) sum[r][q] += f[r][q] < Real(0) ? -f[r][q] : f[r][q];
      }
    for (int k = 0; k < corners; ++k)
      for (int c = 0; c < 3; ++c) body.corner_force[3 * batch.slot(i, corners, k) + c] = sum[c][k];
  }
};

}  // namespace ashlar
