#pragma once
#include <vector>

#include "solve/checkpoint.hpp"
#include "solve/contact_states.hpp"
#include "solve/result.hpp"

/// Breaking contact points at converged states, and the account of it (numerics 5, crack events).
namespace ashlar {

/// Members of the group that breaks together use at least this share of what the worst one uses.
inline constexpr double worst_group_share = 0.999;

class CrackEvents {
 public:
  /// `problem` outlives this.
  explicit CrackEvents(const Problem& problem);

  /// Whether any contact point has a strength.
  bool breakable() const { return breakable_; }
  /// Whether any contact point can open or slide, at once or after it has cracked.
  bool can_separate() const { return slides_; }

  /// Share of its strength that the worst contact point uses at the present, converged state; 0 where nothing can
  /// break.
  double largest_utilisation();

  /// Cracks the worst group at the present, converged state, which has to use its strength, and tells what broke.
  CrackEvent break_worst_group(double load_factor);

  /// Takes the slip of the present equilibrium as the one to go on from, and books the friction work since the last
  /// one: traction now times slip since then, never negative.
  void keep_slip();

  /// J: friction work, and spring energy set free by cracking beyond what friction takes over.
  double dissipated_energy() const { return dissipated_; }

  /// Cracked area in all and by direction, dissipated energy.
  void fill(StageResult& result);

  void exchange(Exchange& e) { e("dissipated", dissipated_); }

  /// Share of the contact points with a strength that have cracked.
  double cracked_fraction();

 private:
  const Problem& problem_;
  ContactReader contacts_;
  bool breakable_ = false;
  bool slides_ = false;
  double dissipated_ = 0;
};

/// Direction of a crack by its normal: "horizontal" within 30 degrees of z, "vertical" within 30 degrees of the
/// horizontal plane, else "inclined".
const char* crack_direction(const Vec3<double>& normal);

}  // namespace ashlar
