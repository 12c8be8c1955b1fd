#pragma once
#include "model/view.hpp"

/// Sums that relaxation decides by, in double (kernels/sum.hpp).
namespace ashlar {

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

/// One group of nodes -> its share of every sum.
template <class Real>
struct RelaxationSums {
  BodyView<Real> body;
  GroupView<Real> groups;

  ASHLAR_HD void operator()(int group, double (&s)[relaxation_sum_count]) const {
    for (int c = 0; c < 3; ++c) add_component(group, c, s);
  }

 private:
  ASHLAR_HD void add_component(int group, int c, double (&s)[relaxation_sum_count]) const {
    double motion = 0, momentum = 0, mass_of_group = 0;
    bool any_held = false;
    for (int j = groups.begin(group); j < groups.end(group); ++j) {
      const int node = groups.node(j), i = 3 * node + c;
      const double load = body.load[i], force = body.force[i], u = body.u.whole(i), v = body.v[i];
      const double residual = load - force;
      s[sum_load] += load * load;
      s[sum_load_work] += u * load;
      s[sum_force_work] += u * force;
      if ((unsigned(body.fixed[node]) >> c) & 1u) {
        s[sum_reaction] += residual * residual;
        any_held = true;
      } else {
        const double mass = 1.0 / double(body.inverse_mass[node]);
        s[sum_unbalanced] += residual * residual;
        s[sum_curvature] += v * (force - double(body.kept_force[i]));
        motion += mass * v * v;
        momentum += mass * v;
        mass_of_group += mass;
      }
    }
    // v . M v of the group, M the inverse of diag(1/m) + pull ones ones^T (Sherman and Morrison).
    if (!any_held && !groups.single(group)) {
      const double pull = groups.pull[group];
      motion -= pull / (1.0 + pull * mass_of_group) * momentum * momentum;
    }
    s[sum_motion] += motion;
    s[sum_kinetic] += 0.5 * motion;
  }
};

}  // namespace ashlar
