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
  Real slope, dilation;
  Real strength, hardening, residual;  ///< Pa; hardening per engineering shear strain of flow
  Real cut_off;                        ///< Pa, of I1

  template <class V>
  using History = PlasticHistory<V>;
  ASHLAR_HD const Elastic::Point<Real>& elastic() const { return part; }

  template <class V>
  ASHLAR_HD Sym3<V> stress(const Sym3<V>& strain, PlasticHistory<V>& history) const {
    return plastic_stress(*this, strain, history);
  }

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
  ASHLAR_HD static Real flow_of(Real equivalent) { return Real(1.7320508075688772935) * equivalent; }
  ASHLAR_HD Real strength_at(Real flow) const { return larger(residual, fma(hardening, flow, strength)); }

  /// Further flow x with demand - resistance x = strength_at(flow + x).
  ASHLAR_HD Real further_flow(Real demand, Real resistance, Real flow) const {
    const Real start = fma(hardening, flow, strength), x = (demand - start) / (resistance + hardening);
    return fma(hardening, x, start) < residual ? (demand - residual) / resistance : x;
  }

  /// Trial stress and history to those after flow.
  ASHLAR_HD_CALL void pull_back(Sym3<Real>& s, PlasticHistory<Real>& h) const {
    const Real mu = part.shear, bulk = fma(Real(2.0 / 3), mu, part.lambda);
    const auto [trace, shear] = invariants(s);
    const Real flowed = flow_of(h.equivalent);
    Real new_trace = trace, new_shear = shear, flow = 0;
    const auto to_tip = [&](Real limit) {
      flow = shear / mu;
      new_shear = 0;
      new_trace = smaller(limit, strength_at(flowed + flow) / slope);
    };
    const Real demand = fma(slope, trace, shear);
    if (demand > strength_at(flowed)) {
      flow = further_flow(demand, fma(Real(9) * bulk * slope, dilation, mu), flowed);
      new_shear = fma(-mu, flow, shear);
      new_trace = fma(Real(-9) * bulk * dilation, flow, trace);
      if (new_shear < Real(0)) to_tip(trace);
    }
    if (new_trace > cut_off) {
      new_trace = cut_off;
      new_shear = shear;
      flow = 0;
      const Real demand_there = fma(slope, cut_off, shear);
      if (demand_there > strength_at(flowed)) {
        flow = further_flow(demand_there, mu, flowed);
        new_shear = fma(-mu, flow, shear);
        if (new_shear < Real(0)) to_tip(cut_off);
      }
    }
    const Real kept = shear > Real(0) ? new_shear / shear : Real(0);
    const Sym3<Real> d = deviator(s, trace);
    const Real mean = new_trace * Real(1.0 / 3);
    const Real stretch = (trace - new_trace) / (Real(9) * bulk), turn = (Real(1) - kept) / mu;
    s = {fma(kept, d.xx, mean), fma(kept, d.yy, mean), fma(kept, d.zz, mean), kept * d.xy, kept * d.yz, kept * d.zx};
    h.strain.xx += fma(Real(0.5) * turn, d.xx, stretch);
    h.strain.yy += fma(Real(0.5) * turn, d.yy, stretch);
    h.strain.zz += fma(Real(0.5) * turn, d.zz, stretch);
    h.strain.xy = fma(turn, d.xy, h.strain.xy);
    h.strain.yz = fma(turn, d.yz, h.strain.yz);
    h.strain.zx = fma(turn, d.zx, h.strain.zx);
    h.equivalent = fma(Real(0.57735026918962576451), flow, h.equivalent);
    h.dissipation += fma(new_trace, stretch, new_shear * ((shear - new_shear) / mu));
  }
};

}  // namespace ashlar
