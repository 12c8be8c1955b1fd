#pragma once
#include "model/view.hpp"

/// Sums that relaxation decides by, over fixed chunks of nodes in index order, in double: the same on every machine and
/// for every number of threads (numerics 8).
namespace ashlar {

inline constexpr int chunk_nodes = 256;

/// Index of each sum in a chunk's record.
enum RelaxationSum : int {
  sum_unbalanced,  ///< |load - force|^2 over free components, N^2
  sum_load,        ///< |load|^2, N^2
  sum_reaction,    ///< |load - force|^2 over held components, N^2
  sum_kinetic,     ///< m v^2 / 2, J
  sum_load_work,   ///< u . load, J
  sum_force_work,  ///< u . force, J
  sum_curvature,   ///< v . (force - kept force) over free components
  sum_motion,      ///< v . m v over free components
  relaxation_sum_count
};

template <class Real>
struct RelaxationSums {
  BodyView<Real> body;
  double* chunk_sums;  ///< [relaxation_sum_count * chunks]

  ASHLAR_HD void operator()(int chunk) const {
    double s[relaxation_sum_count] = {};
    const int first = chunk * chunk_nodes;
    const int last = first + chunk_nodes < body.nodes.node_count ? first + chunk_nodes : body.nodes.node_count;
    for (int node = first; node < last; ++node) {
      const double mass = 1.0 / double(body.inverse_mass[node]);
      const unsigned fixed = body.fixed[node];
      for (int c = 0; c < 3; ++c) {
        const int i = 3 * node + c;
        const double load = body.load[i], force = body.force[i], u = body.u[i], v = body.v[i];
        const double residual = load - force;
        s[sum_load] += load * load;
        s[sum_load_work] += u * load;
        s[sum_force_work] += u * force;
        if ((fixed >> c) & 1u) {
          s[sum_reaction] += residual * residual;
        } else {
          s[sum_unbalanced] += residual * residual;
          s[sum_kinetic] += 0.5 * (mass * v * v);
          s[sum_curvature] += v * (force - double(body.kept_force[i]));
          s[sum_motion] += mass * v * v;
        }
      }
    }
    for (int k = 0; k < relaxation_sum_count; ++k) chunk_sums[chunk * relaxation_sum_count + k] = s[k];
  }
};

}  // namespace ashlar
