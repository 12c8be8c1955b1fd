#pragma once
#include <optional>
#include <vector>

#include "solve/checkpoint.hpp"
#include "solve/contact_states.hpp"
#include "solve/result.hpp"

/// Breaking contact points at converged states, and the account of it (numerics 5, crack events).
namespace ashlar {

class CrackEvents {
 public:
  /// `problem` outlives this.
  explicit CrackEvents(const Problem& problem);

  /// Whether any contact point has a strength.
  bool can_crack() const { return breakable_ || softens_; }
  /// Whether any contact point can open or slide, at once or after it has cracked.
  bool can_separate() const { return slides_; }

  /// Share of its strength that the worst contact point uses at the present, converged state; 0 where nothing can
  /// break.
  double largest_utilisation();

  /// Cracks the worst group at the present, converged state, whose worst contact point uses `used` >= 1 of its strength
  /// and whose others use at least `share` of that, and tells what broke.
  CrackEvent break_worst_group(double used, double share, double load_factor);

  /// Takes slip and damage of the present equilibrium as those to go on from, and books what both have cost since the
  /// last one: traction now times slip since then, and the energy of softening, never negative. Tells what has softened
  /// to the end since then.
  std::optional<CrackEvent> keep_history(double load_factor);

  /// Cracked area in all and by direction, dissipated energy.
  void fill(StageResult& result) const;
  void fill_areas(StageResult& result) const;

  /// J since the stage began.
  const Dissipation<double>& dissipated() const { return dissipated_; }

  void exchange(Exchange& e) {
    e("dissipated", dissipated_);
    if (e.taking()) cracked_.reset();
  }

  /// Share of the contact points with a strength that have cracked.
  double cracked_fraction();

 private:
  /// Books a group that cracked at the same time, and tells of it.
  CrackEvent event_of(const CrackMeasure& cracked, double load_factor);
  const Problem& problem_;
  bool breakable_ = false;
  bool slides_ = false;
  bool softens_ = false;
  long strong_ = 0;              ///< contact points with a strength
  std::optional<long> cracked_;  ///< those of them that have cracked, once it has been asked for
  Dissipation<double> dissipated_;  ///< J: friction work, and spring energy set free beyond what friction takes over
};

/// Direction of a crack by its normal: "horizontal" within 30 degrees of z, "vertical" within 30 degrees of the
/// horizontal plane, else "inclined".
const char* crack_direction(const Vec3<double>& normal);

}  // namespace ashlar
