#pragma once
#include "kernels/motion_view.hpp"
#include "model/view.hpp"

/// Energies of a motion, in double (kernels/sum.hpp).
namespace ashlar {

enum MotionSum : int {
  motion_kinetic,    ///< m v^2 / 2 in the middle of the last step, J
  motion_potential,  ///< (u_before . force + u . force at rest) / 2, J; see MotionMeasure::potential
  motion_rest_work,  ///< u . force at rest, J
  motion_supplied,   ///< J
  motion_damped,     ///< J
  motion_sum_count
};

/// What one node has of every sum, small displacement or large: kinetic energy, and what came in and was damped.
template <class Real>
struct NodeEnergies {
  BodyView<Real> body;
  MotionView<Real> motion;
  double step_before;  ///< s

  ASHLAR_HD void add(int node, double (&s)[motion_sum_count]) const {
    for (int c = 0; c < 3; ++c) {
      const double v = body.v[3 * node + c];
      s[motion_kinetic] += 0.5 * v * v / double(body.inverse_mass[node]);
    }
    s[motion_supplied] = motion.supplied[node];
    s[motion_damped] = motion.damped[node];
  }
};

/// One node -> its share of every sum. The force is that of the present displacement, `kept_force` that of displacement
/// zero (temperature, initial stress).
template <class Real>
struct MotionSums : NodeEnergies<Real> {
  ASHLAR_HD void operator()(int node, double (&s)[motion_sum_count]) const {
    const BodyView<Real>& body = this->body;
    for (int i = 3 * node; i < 3 * node + 3; ++i) {
      const double u = body.u.whole(i), rest = body.kept_force[i];
      const double before = u - this->step_before * double(body.v[i]);
      s[motion_potential] += 0.5 * (before * double(body.force[i]) + u * rest);
      s[motion_rest_work] += u * rest;
    }
    this->add(node, s);
  }
};

/// The same in large displacement: of the potential only what lies between the present displacement, where elements and
/// contacts store their energy, and the middle of the last step.
template <class Real>
struct TurningSums : NodeEnergies<Real> {
  ASHLAR_HD void operator()(int node, double (&s)[motion_sum_count]) const {
    for (int i = 3 * node; i < 3 * node + 3; ++i)
      s[motion_potential] -= 0.5 * this->step_before * double(this->body.v[i]) * double(this->body.force[i]);
    this->add(node, s);
  }
};

}  // namespace ashlar
