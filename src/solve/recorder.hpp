#pragma once
#include <string>
#include <vector>

#include "model/locate.hpp"
#include "solve/observer.hpp"
#include "solve/problem.hpp"

/// Reads the machine's state back for people: history rows and snapshots of all fields.
namespace ashlar {

/// Where a run is: for rows and snapshots.
struct Moment {
  int stage = 0;    ///< 0-based
  double time = 0;  ///< stages done, with the fraction of the present one
  double load_factor = 0;
  bool stage_end = false;
  double seconds = 0;  ///< dynamic, coupled and transient stages: since the stage began
  int record = 0;      ///< of those: number of the row, from 1
  bool balanced = true;
};

class Recorder {
 public:
  /// Throws DeckError: a history's point outside the body, a name in `record` that does not exist, a surface without
  /// facets.
  Recorder(const Problem& problem, Observer& observer);

  /// Loads on surfaces of the present stage, for records of `load`. [3 * block nodes] N, Blocks order.
  void surface_load(std::vector<double> load) { surface_load_ = std::move(load); }
  /// Temperature that stress sees and the thermal one, degC, [mesh nodes]; empty: the model has none.
  void temperature(std::vector<double> temperature) { temperature_ = std::move(temperature); }
  /// J that contact points have lost since the run began.
  void contact_dissipation(const Dissipation<double>& lost) { lost_by_contacts_ = lost; }
  /// Velocity [3 * block nodes] m/s, Blocks order, and energies of a motion; empty: at rest.
  void motion(std::vector<double> velocity, const EnergyBalance& energy) {
    velocity_ = std::move(velocity);
    energy_ = energy;
  }
  void exchange(Exchange& e);
  /// Displacement counts from the present state from now on (numerics 7).
  void reset_displacement();

  void history_rows(const Moment& moment);
  void snapshot(const Moment& moment);
  std::vector<HistoryTable> take_histories() { return std::move(tables_); }

 private:
  struct Probe {
    const History* history;
    Location location;       ///< histories at a point
    std::vector<int> nodes;  ///< histories of a surface: block nodes
  };
  void add_columns(const Probe& probe, HistoryTable& table) const;
  void add_values(const Probe& probe, std::vector<double>& row);
  std::vector<double> at_point(const Probe& probe, const std::vector<double>& field, int components) const;
  std::vector<double> displacement() const;

  const Problem& problem_;
  Observer& observer_;
  std::vector<Probe> probes_;
  std::vector<HistoryTable> tables_;
  std::vector<double> reference_displacement_, surface_load_, temperature_, velocity_;
  EnergyBalance energy_;
  Dissipation<double> lost_by_contacts_;  ///< J
  bool timed_ = false;  ///< rows begin with the seconds of dynamic and transient stages
};

}  // namespace ashlar
