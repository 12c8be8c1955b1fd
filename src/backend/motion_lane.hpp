#pragma once
#include <vector>

#include "backend/backend.hpp"
#include "kernels/motion_step.hpp"
#include "kernels/motion_sums.hpp"

namespace ashlar {

/// What a motion in time keeps in a machine's memory beside the body; empty until one starts.
template <class Exec, class Real>
class MotionLane {
 public:
  void start(std::size_t nodes, std::size_t contacts) {
    load_work.resize(nodes);
    damping_work.resize(nodes);
    spring_dissipation.resize(3 * contacts);
    damped_beside_ = false;
  }
  /// Where a damping force is to be found that steps take account of from now on: zero at first, and when cleared.
  Real* damping_force(std::size_t nodes) {
    if (!damped_beside_) damping_force_.resize(3 * nodes);
    damped_beside_ = true;
    return damping_force_.data();
  }
  void clear_damping_force() { damping_force_.resize(damping_force_.size()); }
  /// Velocity times `factor`, into `scaled`; makes room for the damping force, which steps take account of from now on.
  Real* scale_velocity(Exec& exec, const BodyView<Real>& body, double factor, Real* scaled) {
    exec.for_each(body.nodes.node_count, ScaleVelocity<Real>{body, Real(factor), scaled});
    return damping_force(body.nodes.node_count);
  }
  void step(Exec& exec, const BodyView<Real>& body, const Controls& c) {
    const MotionStep<Real> step{Real(c.velocity_step), Real(c.time_step), c.step_before, Real(c.local_damping),
                                Real(c.mass_damping)};
    exec.for_each(body.nodes.node_count, StepMotion<Real>{body, view(), step});
  }
  MotionMeasure sums(Exec& exec, const BodyView<Real>& body, double step_before) {
    return measure(exec, body.nodes.node_count, MotionSums<Real>{{body, view(), step_before}});
  }
  /// In large displacement, without the energy that elements and contacts store at the present displacement.
  MotionMeasure turning_sums(Exec& exec, const BodyView<Real>& body, double step_before) {
    return measure(exec, body.nodes.node_count, TurningSums<Real>{{body, view(), step_before}});
  }

 private:
  template <class T>
  using Array = typename Exec::template Array<T>;
  template <class Sums>
  static MotionMeasure measure(Exec& exec, int nodes, const Sums& sums) {
    const auto s = exec.template combine<motion_sum_count>(nodes, sums);
    return {s[motion_kinetic], s[motion_potential], s[motion_rest_work], s[motion_supplied], s[motion_damped], 0};
  }
  MotionView<Real> view() {
    return {damped_beside_ ? damping_force_.data() : nullptr,
            given_velocity.size() > 0 ? given_velocity.data() : nullptr, load_work.data(), damping_work.data()};
  }
  bool damped_beside_ = false;
  Array<Real> damping_force_;

 public:
  Array<Real> given_velocity;        ///< [3 * nodes] m/s of held components; empty: at rest
  Array<double> spring_dissipation;  ///< [3 * contacts] J
  Array<double> load_work, damping_work;  ///< [nodes] J
};

}  // namespace ashlar
