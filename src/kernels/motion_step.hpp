#pragma once
#include "base/number.hpp"
#include "kernels/motion_view.hpp"
#include "model/view.hpp"

/// Phase step_motion: paper (13) in time with the real mass, velocity first, then displacement. Velocities belong to
/// the middle of a step (central difference).
namespace ashlar {

/// Lengths of one step and its damping.
template <class Real>
struct MotionStep {
  Real velocity_step = 0;      ///< s, from velocity to velocity
  Real displacement_step = 0;  ///< s, from displacement to displacement; 0: the velocity moves on alone
  double step_before = 0;      ///< s, displacement step that led here
  Real local_damping = 0;      ///< Cundall's alpha
  Real mass_damping = 0;       ///< Rayleigh's factor of the mass, 1/s
};

/// One node -> its velocity and displacement, work of loads and damping on the way between the middles of two steps.
template <class Real>
struct StepMotion {
  BodyView<Real> body;
  MotionView<Real> motion;
  MotionStep<Real> step;

  ASHLAR_HD void operator()(int node) const {
    // Mass-proportional damping acts on the mean of both velocities: stable at any coefficient.
    const Real half = Real(0.5) * step.mass_damping * step.velocity_step;
    const Real keep = (Real(1) - half) / (Real(1) + half), gain = step.velocity_step / (Real(1) + half);
    const Real inverse_mass = body.inverse_mass[node];
    const double viscous = 0.5 * double(step.mass_damping) / double(inverse_mass);
    double supplied = 0, damped = 0;
    for (int c = 0; c < 3; ++c) {
      const int i = 3 * node + c;
      if ((unsigned(body.fixed[node]) >> c) & 1u) {
        if (motion.given_velocity) move_held(i, inverse_mass, supplied, damped);
        continue;
      }
      const Real v = body.v[i];
      const Real resisting = resistance(i, v);
      const Real moved = fma(keep, v, gain * (inverse_mass * (body.load[i] - body.force[i] - resisting)));
      body.v[i] = moved;
      SummedValue<Real> u = body.u[i];
      u.add_product(step.displacement_step, moved);
      body.u.write(i, u);
      const double way = 0.5 * (double(step.displacement_step) * double(moved) + step.step_before * double(v));
      supplied += way * double(body.load[i]);
      damped += way * (double(resisting) + viscous * (double(moved) + double(v)));
    }
    if (step.displacement_step == Real(0)) return;
    motion.supplied[node] += supplied;
    motion.damped[node] += damped;
  }

 private:
  /// A held component goes as given; what holds it supplies the work of all forces there and of the mass.
  ASHLAR_HD void move_held(int i, Real inverse_mass, double& supplied, double& damped) const {
    const double v = body.v[i], moved = motion.given_velocity[i];
    const double resisting = motion.damping_force ? double(motion.damping_force[i]) : 0.0;
    const double push = (moved - v) / (double(step.velocity_step) * double(inverse_mass));
    const double way = 0.5 * (double(step.displacement_step) * moved + step.step_before * v);
    body.v[i] = motion.given_velocity[i];
    SummedValue<Real> u = body.u[i];
    u.add_product(step.displacement_step, motion.given_velocity[i]);
    body.u.write(i, u);
    supplied += way * (double(body.force[i]) + resisting + push);
    damped += way * resisting;
  }
  /// Force against the motion: stiffness-proportional and local damping.
  ASHLAR_HD Real resistance(int i, Real v) const {
    const Real viscous = motion.damping_force ? motion.damping_force[i] : Real(0);
    const Real f = body.load[i] - body.force[i] - viscous;
    const Real sign = Real((v > Real(0)) - (v < Real(0)));
    return fma(step.local_damping * (f < Real(0) ? -f : f), sign, viscous);
  }
};

/// One node -> velocity times a factor, as a displacement whose elastic force is that of stiffness-proportional
/// damping.
template <class Real>
struct ScaleVelocity {
  BodyView<Real> body;
  Real factor;   ///< s
  Real* scaled;  ///< [3 * nodes] m
  ASHLAR_HD void operator()(int node) const {
    for (int c = 0; c < 3; ++c) scaled[3 * node + c] = factor * body.v[3 * node + c];
  }
};

}  // namespace ashlar
