#pragma once
#include "base/tensor.hpp"
#include "model/view.hpp"
#include "physics/bbar.hpp"

/// Phase block_force: stress of every element, forces at its corners (paper, DoKernel steps 1-3, without a stiffness
/// matrix).
namespace ashlar {

/// Whether the element routine of a law has no form of its own for bodies without temperature, where warming is 0: laws
/// with memory read so much that it does not count.
template <class Point>
inline constexpr bool always_warm = Point::history_size > 0;

/// Length of an element across a plane, m, which laws that release energy on a crack ask for (crack band; Oliver 1989):
/// 2 / sum over corners of |normal . gradient|.
template <class Points>
struct LengthAcross {
  const Points& points;
  template <class Real>
  ASHLAR_HD Real operator()(int lane, const Vec3<Real>& normal) const {
    return points.length(lane, normal);
  }
};

/// Stress of a law with memory at Gauss point g; `strain` comes with heat. The history, 0 before, is what the point
/// would remember from now on; `remembers`: what it remembers now is not 0 throughout the element.
template <class V, class Point, class Points>
ASHLAR_HD_HOST_CALL Sym3<V> remembered_stress(const Point& law, const Points& points, bool remembers, int g,
                                              const Sym3<V>& strain, typename Point::template History<V>& history) {
  if (remembers) points.read_history(g, history);
  const Sym3<V> e = law.elastic().without_heat(strain, points.warming(g));
  if constexpr (Point::sized)
    return law.stress(e, history, LengthAcross<Points>{points});
  else
    return law.stress(e, history);
}

/// The law at the Gauss points of one element, as the element routine calls it. `points` knows the state of Gauss point
/// g: warming(g), asked for where Warm, remembers() and read_history(g, history), where the law remembers, and
/// length(lane, normal), where it is sized.
template <class Element, bool Warm, class V, class Point, class Points>
struct PointStress {
  const Point& law;
  const Points& points;
  static constexpr bool staged = Warm && Point::history_size == 0;
  V warming[staged ? Element::gauss_points : 1];
  bool remembers = false;

  ASHLAR_HD PointStress(const Point& l, const Points& p) : law(l), points(p) {
    if constexpr (Point::history_size > 0) remembers = p.remembers();
    if constexpr (staged)
      for (int g = 0; g < Element::gauss_points; ++g) warming[g] = p.warming(g);
  }
  ASHLAR_HD Sym3<V> operator()(int g, const Sym3<V>& strain) const {
    if constexpr (Point::history_size > 0) {
      typename Point::template History<V> history{};
      return remembered_stress(law, points, remembers, g, strain, history);
    } else if constexpr (staged) {
      return law.stress(law.without_heat(strain, warming[g]));
    } else {
      return law.stress(strain);
    }
  }
  /// See Tet4Averaged.
  ASHLAR_HD Sym3<V> averaged_stress(int g) const requires requires(const Points& p) { p.averaged_stress(0); }
  { return points.averaged_stress(g); }
  /// See gauss_point_force().
  ASHLAR_HD Sym3<V> weighted(int g, const Sym3<V>& strain, const V& det, const V& inverse, const V& weight) const
      requires(Point::history_size == 0) {
    if constexpr (staged)
      return law.weighted_stress(law.without_heat(strain, warming[g] * det), inverse, weight);
    else
      return law.weighted_stress(strain, inverse, weight);
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

/// Elastic stress at the Gauss points of one element that remembers nothing, and whether the law takes more than that.
template <class Element, class V, class Point, class Points>
struct QuietStress {
  const Point& law;
  const Points& points;
  bool yields = false;
  V warming[Element::gauss_points];

  ASHLAR_HD QuietStress(const Point& l, const Points& p) : law(l), points(p) {
    for (int g = 0; g < Element::gauss_points; ++g) warming[g] = p.warming(g);
  }
  ASHLAR_HD Sym3<V> operator()(int g, const Sym3<V>& strain) {
    const Sym3<V> s = law.elastic().stress(law.elastic().without_heat(strain, warming[g]));
    const auto test = law.test(s);
    const typename Point::template History<V> nothing{};
    for (int l = 0; l < lane_count<V>; ++l) yields |= law.yields(test, nothing, l);
    return s;
  }
};

/// element_force() as a call: `read(x, u)` reads the corners.
template <template <class> class Element, class V, class Point, class Points, class Read>
ASHLAR_HD_CALL void remembering_force(const Point& law, const Read& read, const Points& points,
                                      V (&f)[3][Element<V>::corners]) {
  V x[3][Element<V>::corners], u[3][Element<V>::corners];
  read(x, u);
  element_force<Element, true>(law, x, u, points, f);
}

/// Corner forces of one element whose corners `read(x, u)` reads. One that remembers nothing is taken for elastic
/// first, with few numbers at hand; where that is not so it begins again, and next time (until histories move on) with
/// that.
template <template <class> class Element, bool Warm, class V, class Point, class Points, class Read>
ASHLAR_HD void read_element_force(const Point& law, const Read& read, const Points& points,
                                  V (&f)[3][Element<V>::corners]) {
  constexpr int corners = Element<V>::corners;
  constexpr bool begins_quiet = Point::history_size > 0 && !is_averaged<Element>;
  V x[3][corners], u[3][corners];
  if constexpr (!begins_quiet) {
    read(x, u);
    element_force<Element, Warm>(law, x, u, points, f);
  } else {
    if (points.quiet()) {
      read(x, u);
      QuietStress<Element<V>, V, Point, Points> stress(law, points);
      Element<V>::force(x, u, f, stress);
      if (!stress.yields) return;
      points.expect_more();
    }
    V again[3][corners];  // what a call writes lies in memory: f need not
    remembering_force<Element>(law, read, points, again);
    for (int c = 0; c < 3; ++c)
      for (int k = 0; k < corners; ++k) f[c][k] = again[c][k];
  }
}

template <class Real>
ASHLAR_HD Real length_across(const BodyView<Real>& body, const BatchView& batch, int element,
                             const Vec3<Real>& normal) {
  Real sum = 0;
  for (int k = 0; k < batch.corners; ++k) {
    const Real* gradient = body.corner_gradient + 3 * batch.slot(element, batch.corners, k);
    const Real along = fma(normal.z, gradient[2], fma(normal.y, gradient[1], normal.x * gradient[0]));
    sum += along < Real(0) ? -along : along;
  }
  return Real(2) / sum;
}

/// One element -> whether its Gauss points remember anything.
template <class Real>
struct FindMemory {
  BodyView<Real> body;
  BatchView batch;
  int gauss_points, history_size;
  std::uint8_t* remembers;

  ASHLAR_HD void operator()(int i) const {
    bool any = false;
    for (int c = 0; c < history_size; ++c)
      for (int g = 0; g < gauss_points; ++g)
        any |= body.history[c * body.history_stride + batch.history(i, g)] != Real(0);
    remembers[batch.history(i, 0)] = any ? 1 : 0;
  }
};

/// Stress with `mean` as its mean.
template <class V>
ASHLAR_HD Sym3<V> with_mean(Sym3<V> s, const V& mean) {
  const V change = mean - V(Scalar<V>(1.0 / 3)) * (s.xx + s.yy + s.zz);
  for (int c = 0; c < 3; ++c) s[c] = s[c] + change;
  return s;
}

/// The Gauss points of one element in memory.
template <class Real>
struct StoredPoints {
  const BodyView<Real>& body;
  const BatchView& batch;
  int element;
  ASHLAR_HD Real length(int, const Vec3<Real>& normal) const { return length_across(body, batch, element, normal); }
  ASHLAR_HD Real warming(int g) const { return body.warming[batch.gauss(element, g)]; }
  ASHLAR_HD bool remembers() const { return body.remembers[batch.history(element, 0)] & 1; }
  ASHLAR_HD bool quiet() const { return body.remembers[batch.history(element, 0)] == 0; }
  ASHLAR_HD void expect_more() const { body.remembers[batch.history(element, 0)] = 2; }
  ASHLAR_HD Real averaged(int g) const { return body.averaged[batch.gauss(element, g)]; }
  ASHLAR_HD Sym3<Real> averaged_stress(int g) const {
    Sym3<Real> s;
    for (int c = 0; c < 6; ++c) s[c] = body.stress[6 * batch.gauss(element, g) + c];
    return with_mean(s, averaged(g));
  }
  /// For averaged_stress(): a stress, its mean to be averaged.
  ASHLAR_HD void keep(int g, const Sym3<Real>& s) const {
    for (int c = 0; c < 6; ++c) body.stress[6 * batch.gauss(element, g) + c] = s[c];
    body.averaged[batch.gauss(element, g)] = Real(1.0 / 3) * (s.xx + s.yy + s.zz);
  }
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

template <int corners, class Real>
struct ReadCorners {
  const BodyView<Real>& body;
  const BatchView& batch;
  int element;
  ASHLAR_HD void operator()(Real (&x)[3][corners], Real (&u)[3][corners]) const {
    read_corners(body, batch, element, x, u);
  }
};

/// One element -> its own corner slots.
template <template <class> class Element, class Point, class Real, bool Warm>
struct BlockForce {
  BodyView<Real> body;
  BatchView batch;
  Point law;

  ASHLAR_HD void operator()(int i) const {
    constexpr int corners = Element<Real>::corners;
    Real f[3][corners];
    read_element_force<Element, Warm, Real>(law, ReadCorners<corners, Real>{body, batch, i},
                                            StoredPoints<Real>{body, batch, i}, f);
    ASHLAR_UNROLL
    for (int k = 0; k < corners; ++k)
      for (int c = 0; c < 3; ++c) body.corner_force[3 * batch.slot(i, corners, k) + c] = f[c][k];
  }
};

/// One element -> strain at its Gauss points, where their stress will be.
template <template <class> class Element, class Real>
struct GaussStrain {
  BodyView<Real> body;
  BatchView batch;

  struct Keeper {
    const BodyView<Real>& body;
    const BatchView& batch;
    int element;
    ASHLAR_HD Real dilatation(int g) const { return body.averaged[batch.gauss(element, g)]; }
    ASHLAR_HD Sym3<Real> operator()(int g, const Sym3<Real>& strain) const {
      for (int c = 0; c < 6; ++c) body.stress[6 * batch.gauss(element, g) + c] = strain[c];
      return {};
    }
  };

  ASHLAR_HD void operator()(int i) const {
    constexpr int corners = Element<Real>::corners;
    Real x[3][corners], u[3][corners], f[3][corners];
    read_corners(body, batch, i, x, u);
    const Keeper keeper{body, batch, i};
    Element<Real>::force(x, u, f, keeper);
  }
};

/// One Gauss point -> its stress in place of its strain, by the law that the force routine takes. `moves_on`: the point
/// remembers what it went through.
template <class Point, class Real, bool moves_on>
struct GaussStress {
  BodyView<Real> body;
  BatchView batch;
  Point law;

  ASHLAR_HD void operator()(int i) const {
    const int element = i % batch.element_count, g = i / batch.element_count;
    Real* const at = body.stress + 6 * batch.gauss(element, g);
    const StoredPoints<Real> points{body, batch, element};
    Sym3<Real> s;
    for (int c = 0; c < 6; ++c) s[c] = at[c];
    if constexpr (Point::history_size > 0) {
      typename Point::template History<Real> history{};
      s = remembered_stress(law, points, points.remembers(), g, s, history);
      if constexpr (moves_on) points.write_history(g, history);
    } else {
      s = law.stress(law.without_heat(s, points.warming(g)));
    }
    for (int c = 0; c < 6; ++c) at[c] = s[c];
  }
};

/// One element -> its strain energy, J, of an elastic law and an element in large displacement.
template <template <class> class Element, class Point, class Real>
struct ElementEnergy {
  BodyView<Real> body;
  BatchView batch;
  Point law;

  struct Keeper {
    const Point& law;
    double density = 0, energy = 0;
    ASHLAR_HD Sym3<Real> operator()(int, const Sym3<Real>& strain) {
      const Sym3<Real> s = law.stress(strain);
      density = 0;
      for (int c = 0; c < 6; ++c) density = fma(0.5 * double(s[c]), double(strain[c]), density);
      return s;
    }
    ASHLAR_HD void volume(Real volume) { energy = fma(density, double(volume), energy); }
  };

  ASHLAR_HD void operator()(int i, double (&sum)[1]) const {
    constexpr int corners = Element<Real>::corners;
    Real x[3][corners], u[3][corners], f[3][corners];
    read_corners(body, batch, i, x, u);
    Keeper keeper{law};
    Element<Real>::force(x, u, f, keeper);
    sum[0] = keeper.energy;
  }
};

/// One element -> mean gradients of its shape functions, 1/m, in its corner slots: the corner forces of unit pressure
/// over the volume.
template <template <class> class Element, class Real>
struct CornerGradient {
  BodyView<Real> body;
  BatchView batch;

  struct UnitPressure {
    ASHLAR_HD Sym3<Real> operator()(int, const Sym3<Real>&) const { return {1, 1, 1, 0, 0, 0}; }
  };

  ASHLAR_HD void operator()(int i) const {
    constexpr int corners = Element<Real>::corners;
    Real x[3][corners], u[3][corners], f[3][corners], volume = 0;
    read_corners(body, batch, i, x, u);
    const UnitPressure pressure;
    Element<Real>::force(x, u, f, pressure);
    for (int k = 0; k < corners; ++k)
      for (int c = 0; c < 3; ++c) volume = fma(x[c][k] - x[c][0], f[c][k] * Real(1.0 / 3), volume);
    for (int k = 0; k < corners; ++k)
      for (int c = 0; c < 3; ++c) body.corner_gradient[3 * batch.slot(i, corners, k) + c] = f[c][k] / volume;
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
