#pragma once
#include "physics/laws/plastic.hpp"

namespace ashlar {

/// Plasticity on a cone about the hydrostatic axis, sqrt(J2) + slope I1 = strength, with a cut-off I1 = cut_off: what
/// Drucker-Prager and von Mises (slope 0) materials are to a kernel. Flow follows sqrt(J2) + dilation I1 on the cone
/// and I1 on the cut-off. Strength changes linearly with equivalent plastic strain, never below `residual`. The return
/// is in closed form: to the cone, to its tip or its edge with the cut-off, or to the cut-off.
template <class Real>
struct ConePoint {
  static constexpr int history_size = PlasticHistory<Real>::size;
  static constexpr bool sized = false;
  static constexpr Measure measure = Measure::plastic_strain;
  static constexpr bool has_plane = false;
  Elastic::Point<Real> part;
  Real slope;
  Real trace_per_flow;                 ///< Pa, that flow on the cone takes: 9 bulk modulus times dilation
  Real strength, hardening, residual;  ///< Pa; hardening per engineering shear strain of flow
  Real cut_off;                        ///< Pa, of I1
  Real shear_ease, bulk_ease;          ///< 1 / shear modulus, 1 / 9 bulk modulus, 1/Pa
  Real slope_inverse;
  /// Flow per demand, 1/Pa, where strength changes and where it has become residual (and the flow that residual
  /// strength takes from it): on the cone and where it meets the cut-off.
  struct Ease {
    Real changing, residual, less;
  } on_cone, at_cut_off;

  static ConePoint of(const Elastic& material, double slope, double dilation, double strength, double hardening,
                      double residual, double cut_off) {
    const double mu = material.shear(), bulk = material.lambda() + 2 * mu / 3;
    const double resistance = 9 * bulk * slope * dilation + mu;
    return {.part = material.template prepare<Real>(),
            .slope = Real(slope),
            .trace_per_flow = Real(9 * bulk * dilation),
            .strength = Real(strength),
            .hardening = Real(hardening),
            .residual = Real(residual),
            .cut_off = Real(cut_off),
            .shear_ease = Real(1 / mu),
            .bulk_ease = Real(1 / (9 * bulk)),
            .slope_inverse = Real(1 / slope),
            .on_cone = {Real(1 / (resistance + hardening)), Real(1 / resistance), Real(-residual / resistance)},
            .at_cut_off = {Real(1 / (mu + hardening)), Real(1 / mu), Real(-residual / mu)}};
  }

  template <class V>
  using History = PlasticHistory<V>;
  ASHLAR_HD const Elastic::Point<Real>& elastic() const { return part; }

  template <class V>
  ASHLAR_HD Invariants<V> test(const Sym3<V>& stress) const {
    const Invariants<V> i = invariants(stress);
    return {i.trace, fma(V(slope), i.trace, i.shear)};
  }
  template <class V>
  ASHLAR_HD bool yields(const Invariants<V>& test, const PlasticHistory<V>& history, int l) const {
    return lane(test.shear, l) > strength_at(flow_of(lane(history.equivalent, l))) || lane(test.trace, l) > cut_off;
  }

  /// Engineering shear strain of flow, sqrt(2 de:de) in sum: sqrt(3) times the equivalent plastic strain.
  template <class V>
  ASHLAR_HD static V flow_of(const V& equivalent) {
    return V(Real(1.7320508075688772935)) * equivalent;
  }
  template <class V>
  ASHLAR_HD V strength_at(const V& flow) const {
    return larger(V(residual), fma(V(hardening), flow, V(strength)));
  }

  /// Further flow x with demand - resistance x = strength_at(flow + x); 0 where there is none. Strength is the larger
  /// of two lines, so x is the smaller of what they give.
  template <class V>
  ASHLAR_HD V further_flow(const V& demand, const Ease& ease, const V& flow) const {
    const V start = fma(V(hardening), flow, V(strength));
    const V x = smaller((demand - start) * V(ease.changing), fma(demand, V(ease.residual), V(ease.less)));
    return larger(x, V(Real(0)));
  }

  /// All cases are worked out and the right one taken, so that lanes, and the Gauss points of an element, go together.
  template <class V>
  ASHLAR_HD Sym3<V> stress(const Sym3<V>& strain, PlasticHistory<V>& h) const {
    const V zero = V(Real(0)), mu = V(part.shear), cut = V(cut_off);
    Sym3<V> elastic_strain;
    for (int i = 0; i < 6; ++i) elastic_strain[i] = strain[i] - h.strain[i];
    Sym3<V> s = part.stress(elastic_strain);
    const auto [trace, shear] = invariants(s);
    const V flowed = flow_of(h.equivalent);

    const V most = shear * V(shear_ease), tip = strength_at(flowed + most) * V(slope_inverse);
    const V on_shear = further_flow(fma(V(slope), trace, shear), on_cone, flowed);
    V flow = smaller(on_shear, most);
    V new_trace = if_less(most, on_shear, smaller(trace, tip), fma(V(-trace_per_flow), flow, trace));
    const V at_cut = further_flow(fma(V(slope), cut, shear), at_cut_off, flowed);
    const V trace_there = if_less(most, at_cut, smaller(cut, tip), cut);
    flow = if_less(cut, new_trace, smaller(at_cut, most), flow);
    new_trace = if_less(cut, new_trace, trace_there, new_trace);

    // Exactly nothing where nothing flows.
    const V lost = mu * flow, less = lost * reciprocal(shear), turn = less * V(shear_ease);
    const V stretch = (trace - new_trace) * V(bulk_ease), drop = (trace - new_trace) * V(Real(1.0 / 3));
    const Sym3<V> d = deviator(s, trace);
    for (int i = 0; i < 3; ++i) {
      s[i] = fma(-less, d[i], s[i] - drop);
      s[i + 3] = fma(-less, d[i + 3], s[i + 3]);
      h.strain[i] = h.strain[i] + fma(V(Real(0.5)) * turn, d[i], stretch);
      h.strain[i + 3] = fma(turn, d[i + 3], h.strain[i + 3]);
    }
    h.equivalent = fma(V(Real(0.57735026918962576451)), flow, h.equivalent);
    h.dissipation = h.dissipation + fma(new_trace, stretch, larger(shear - lost, zero) * (lost * V(shear_ease)));
    return s;
  }
};

}  // namespace ashlar
