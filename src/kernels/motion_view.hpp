#pragma once
#include "base/hd.hpp"

namespace ashlar {

/// Account of a motion in time with the real mass, beside the body.
template <class Real>
struct MotionView {
  const Real* damping_force = nullptr;   ///< [3 * nodes] N, stiffness-proportional; null: none
  const Real* given_velocity = nullptr;  ///< [3 * nodes] m/s of held components; null: at rest
  double* supplied = nullptr;            ///< [nodes] J, work of the external force
  double* damped = nullptr;              ///< [nodes] J, taken out by damping
};

}  // namespace ashlar
