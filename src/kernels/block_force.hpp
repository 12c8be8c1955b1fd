#pragma once
#include "base/tensor.hpp"
#include "model/view.hpp"

/// Phase block_force: stress of every element, forces at its corners (paper, DoKernel steps 1-3, without a stiffness
/// matrix).
namespace ashlar {

/// The law at the Gauss points of one element, as the element routine calls it. `points` knows the state of Gauss point
/// g: warming(g), asked for where Warm, and read_history(g, history), where the law remembers.
template <class Element, bool Warm, class V, class Point, class Points>
struct PointStress {
  const Point& law;
  const Points& points;
  V warming[Warm ? Element::gauss_points : 1];

  ASHLAR_HD PointStress(const Point& l, const Points& p) : law(l), points(p) {
    if constexpr (Warm)
      for (int g = 0; g < Element::gauss_points; ++g) warming[g] = p.warming(g);
  }
  ASHLAR_HD Sym3<V> without_heat(int g, const Sym3<V>& strain) const {
    if constexpr (Warm)
      return law.elastic().without_heat(strain, warming[g]);
    else
      return strain;
  }
  ASHLAR_HD Sym3<V> operator()(int g, const Sym3<V>& strain) const {
    if constexpr (Point::history_size == 0) {
      return law.stress(without_heat(g, strain));
    } else {
      typename Point::template History<V> history;
      points.read_history(g, history);
      return law.stress(without_heat(g, strain), history);
    }
  }
};

/// Corner forces of one element; x, u, f are [component][corner]. See PointStress for `points`.
template <template <class> class Element, bool Warm, class V, class Point, class Points>
ASHLAR_HD void element_force(const Point& law, const V (&x)[3][Element<V>::corners],
                             const V (&u)[3][Element<V>::corners], const Points& points,
                             V (&f)[3][Element<V>::corners]) {
  PointStress<Element<V>, Warm, V, Point, Points> stress(law, points);
  Element<V>::force(x, u, f, stress);
}

/// The Gauss points of one element in memory.
template <class Real>
struct StoredPoints {
  const BodyView<Real>& body;
  const BatchView& batch;
  int element;
  ASHLAR_HD Real warming(int g) const { return body.warming[batch.gauss(element, g)]; }
  template <class History>
  ASHLAR_HD void read_history(int g, History& h) const {
    for (int c = 0; c < h.size; ++c) h[c] = body.history[c * body.history_stride + batch.history(element, g)];
  }
  template <class History>
  ASHLAR_HD void write_history(int g, const History& h) const {
    for (int c = 0; c < h.size; ++c) body.history[c * body.history_stride + batch.history(element, g)] = h[c];
  }
};
/// For laws without memory in a body without temperature.
struct NoPoints {};

/// Corner coordinates (from the origin of its patch) and displacements of one element; see relative() for the latter.
template <int corners, class Real>
ASHLAR_HD void read_corners(const BodyView<Real>& body, const BatchView& batch, int i, Real (&x)[3][corners],
                            Real (&u)[3][corners]) {
  const int first = batch.first_entry(body.nodes, i);
  const int base = 3 * body.nodes.entry_node[first + body.nodes.corner_entry[batch.slot(i, corners, 0)]];
  ASHLAR_UNROLL
  for (int k = 0; k < corners; ++k) {
    const int entry = first + body.nodes.corner_entry[batch.slot(i, corners, k)];
    const int n = 3 * body.nodes.entry_node[entry];
    for (int c = 0; c < 3; ++c) {
      x[c][k] = body.x[3 * entry + c];
      u[c][k] = relative(body.u[n + c], body.u[base + c]);
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
    element_force<Element, Warm>(law, x, u, StoredPoints<Real>{body, batch, i}, f);
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
    const StoredPoints<Real> points{body, batch, i};
    PointStress<Element<Real>, Warm, Real, Point, StoredPoints<Real>> stress(law, points);
    Keeper<decltype(stress)> keeper{stress, body.stress, batch, i};
    Element<Real>::force(x, u, f, keeper);
  }
};

/// One element -> the history of its Gauss points moved on to the present displacement.
template <template <class> class Element, class Point, class Real, bool Warm>
struct AdvanceHistory {
  BodyView<Real> body;
  BatchView batch;
  Point law;

  template <class Stress>
  struct Mover {
    const Stress& stress;
    ASHLAR_HD Sym3<Real> operator()(int g, const Sym3<Real>& strain) const {
      typename Point::template History<Real> history;
      stress.points.read_history(g, history);
      const Sym3<Real> s = stress.law.stress(stress.without_heat(g, strain), history);
      stress.points.write_history(g, history);
      return s;
    }
  };

  ASHLAR_HD void operator()(int i) const {
    constexpr int corners = Element<Real>::corners;
    Real x[3][corners], u[3][corners], f[3][corners];
    read_corners(body, batch, i, x, u);
    const StoredPoints<Real> points{body, batch, i};
    const PointStress<Element<Real>, Warm, Real, Point, StoredPoints<Real>> stress(law, points);
    Mover<PointStress<Element<Real>, Warm, Real, Point, StoredPoints<Real>>> mover{stress};
    Element<Real>::force(x, u, f, mover);
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
        element_force<Element, false>(law, x, u, NoPoints{}, f);
        u[c][k] = Real(0);
        for (int q = 0; q < corners; ++q)
          for (int r = 0; r < 3; ++r) sum[r][q] += f[r][q] < Real(0) ? -f[r][q] : f[r][q];
      }
    for (int k = 0; k < corners; ++k)
      for (int c = 0; c < 3; ++c) body.corner_force[3 * batch.slot(i, corners, k) + c] = sum[c][k];
  }
};

}  // namespace ashlar
