#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "solve/checkpoint.hpp"
#include "solve/crack_events.hpp"
#include "solve/crack_paths.hpp"
#include "solve/relaxation.hpp"
#include "solve/support.hpp"

/// Equilibrium with cracks: in a static stage at one load, in a fracture stage along a load factor (numerics 5 and 7).
namespace ashlar {

/// What a stage lends to the search for equilibrium.
struct FractureLinks {
  /// Relaxation at the present load from the present displacement; `watch` as in relax().
  std::function<Equilibrium(const RelaxationWatch& watch)> relax;
  /// Sets load and temperature of a load factor. Not needed by static stages.
  std::function<void(double load_factor)> set_load_factor;
  /// [3 * block nodes, the machine's numbering] N: loads other than weight. A free body under such a load stops the
  /// stage.
  std::vector<double> surface_load;
  /// Called for every crack event.
  std::function<void(const CrackEvent&, double cracked_fraction)> cracked;
  /// Called at the end of every increment of the load factor, at equilibrium.
  std::function<void(double load_factor, const Dissipation<double>& lost)> increment_reached;  ///< J by contacts so far
  /// Offered wherever the stage could go on from; calls back with what to write down if it is wanted.
  std::function<void(const std::function<void(Exchange&)>&)> keep;
};

class Fracture {
 public:
  /// `problem` outlives this. Of `how` only what concerns crack events; static stages take the defaults.
  Fracture(const Problem& problem, FractureLinks links, const FractureSolve& how = {});

  /// Equilibrium at the present load: relax; while a contact point uses its strength crack the worst group and relax
  /// again. False: stopped, see stop_reason().
  bool settle(double load_factor);

  /// From equilibrium at load factor 0 to 1 in equal increments. Where contact points would crack inside an increment
  /// the load factor stops at the first of them, at most 0.5 % above its strength, and goes on from there.
  bool advance(int increments);

  /// Stop reason, steps, ratio of the last relaxation, load factor reached, events, cracked area, free blocks,
  /// dissipated energy.
  void fill(StageResult& result);

  /// What to go on from. After it was taken settle() and advance() do what was left of them.
  void exchange(Exchange& e);
  /// Whether the stage had begun to advance where it goes on.
  bool advancing() const { return place_.increment >= 0; }

  const std::string& stop_reason() const { return stop_reason_; }
  double load_factor() const { return kept_factor_; }
  double cracked_fraction() { return cracks_.cracked_fraction(); }

 private:
  /// Where the search stands when it offers a checkpoint.
  struct Place {
    int increment = -1;  ///< 0: before the first, -1: advance() has not been asked for
    bool settling = false;
    double factor = 0;               ///< while settling
    std::size_t events_before = 0;  ///< while settling: events when it began
  };
  bool relax();
  std::vector<FreeBody> find_free_bodies();
  bool hold_free_bodies();
  LooseBlocks describe(const std::vector<int>& blocks) const;
  bool reach(double factor);
  bool move_on(double factor);
  std::optional<double> reach_first_crack(double high, double used);
  bool stop(const std::string& reason);
  bool keep(double factor, bool smooth);
  void offer_checkpoint();

  const Problem& problem_;
  FractureLinks links_;
  long max_events_;
  double event_group_;
  CrackEvents cracks_;
  CrackPaths paths_;
  bool plastic_;              ///< some law remembers
  double size_;               ///< m, of the whole body
  Place place_;
  bool all_held_ = false;     ///< no body was free at the last look
  bool resumed_ = false;      ///< the present place was taken from a checkpoint
  double kept_factor_ = 0;    ///< of the last equilibrium without over-strength, which the backend keeps
  bool kept_ = false;         ///< there is one
  bool rate_known_ = false;   ///< the backend's rate is of this path
  std::vector<CrackEvent> events_;
  std::vector<int> free_blocks_;
  std::vector<LooseBlocks> loose_;
  Equilibrium last_;
  long steps_ = 0;
  std::string stop_reason_;
};

}  // namespace ashlar
