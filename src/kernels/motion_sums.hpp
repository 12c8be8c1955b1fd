#pragma once
#include "kernels/motion_view.hpp"
#include "model/view.hpp"

/// Energies of a motion, over fixed chunks of nodes in index order, in double: the same on every machine and for every
/// number of threads (numerics 8).
namespace ashlar {

inline constexpr int motion_chunk_nodes = 256;

/// Index of each sum in a chunk's record.
enum MotionSum : int {
  motion_kinetic,    ///< m v^2 / 2 in the middle of the last step, J
  motion_potential,  ///< (u_before . force + u . force at rest) / 2, J; see MotionMeasure::potential
  motion_rest_work,  ///< u . force at rest, J
  motion_supplied,   ///< J
  motion_damped,     ///< J
  motion_sum_count
};

/// One chunk of nodes -> its sums. The force is that of the present displacement, `kept_force` that of displacement
/// zero (temperature, initial stress).
template <class Real>
struct MotionSums {
  BodyView<Real> body;
  MotionView<Real> motion;
  double step_before;  ///< s
  double* chunk_sums;  ///< [motion_sum_count * chunks]

  ASHLAR_HD void operator()(int chunk) const {
    double s[motion_sum_count] = {};
    const int first = chunk * motion_chunk_nodes, beyond = first + motion_chunk_nodes;
    const int last = beyond < body.nodes.node_count ? beyond : body.nodes.node_count;
    for (int node = first; node < last; ++node) {
      for (int c = 0; c < 3; ++c) {
        const int i = 3 * node + c;
        const double u = body.u[i], v = body.v[i], rest = body.kept_force[i];
        const double before = u - step_before * v;
        s[motion_kinetic] += 0.5 * v * v / double(body.inverse_mass[node]);
        s[motion_potential] += 0.5 * (before * double(body.force[i]) + u * rest);
        s[motion_rest_work] += u * rest;
      }
      s[motion_supplied] += motion.supplied[node];
      s[motion_damped] += motion.damped[node];
    }
    for (int k = 0; k < motion_sum_count; ++k) chunk_sums[chunk * motion_sum_count + k] = s[k];
  }
};

}  // namespace ashlar
