#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "physics/interface_laws/spring.hpp"

/// What a run leaves for summaries, expects and studies. Small: scalars and history tables, no fields.
namespace ashlar {

struct CrackEvent {
  double load_factor = 0;
  Vec3<double> place;             ///< of the worst contact point of the group, m
  int contact_points = 0;         ///< how many broke together
  std::string interface;          ///< name in the deck
  std::string mode;               ///< "tension" or "shear"
  double seconds = 0;             ///< coupled and dynamic stages: since the stage began
};

/// Energies of a motion, J, all in the middle of one step. kinetic + strain + dissipated - external_work keeps its value.
struct EnergyBalance {
  double kinetic = 0;
  double strain = 0;              ///< of blocks and springs, less the work of thermal strain
  double dissipated = 0;          ///< by damping, sliding and cracking since the stage began
  Dissipation<double> contacts;   ///< the part of it that contact points took, by mode
  double external_work = 0;       ///< of the loads since the stage began
  double error = 0;               ///< what the sum has gained since the first step
  double drift = 0;               ///< largest error so far over the peak of kinetic energy, strain energy gained or work
};

/// How far loads and the initial stress are from balance before anything moves.
struct InitialBalance {
  double share = 0;               ///< unbalanced force on free nodes over the larger of loads and internal forces there
  double largest = 0;             ///< N, of one node
  Vec3<double> place;             ///< of that node, m
  static constexpr double far = 0.01;  ///< of share: worth a warning
};

/// How the two lanes of a coupled stage spent their time.
struct LaneTimes {
  std::string stress_device, heat_device;
  bool beside = false;            ///< whether they could work at once
  long heat_steps = 0;
  double stress = 0, heat = 0;    ///< s at work
  double both = 0;                ///< s of these at once
};

/// Blocks that hold each other, and that nothing else holds any more.
struct LooseBlocks {
  std::vector<int> blocks;  ///< Blocks numbering
  std::string region;       ///< of the first of them
  double volume = 0;        ///< m^3
  Vec3<double> centre;      ///< m
};

struct PhaseTime {
  std::string phase;
  double seconds = 0;
};

struct StageResult {
  std::string name;
  std::string kind;               ///< "static", "thermal steady", "thermal transient", "fracture", "dynamic", "strength reduction", "coupled"
  bool converged = false;
  std::string stop_reason;        ///< "converged", "duration reached", "step limit", "not finite", "block free", "interrupted", "runaway energy at ...", ...
  long steps = 0;                 ///< passes over the elements: relaxation steps, heat steps, iterations of conjugate gradients
  double ratio = 0;               ///< unbalanced force ratio or relative residual at the end
  double load_factor = 1;         ///< reached by a fracture stage; coupled stages: share of the duration
  double wall_seconds = 0;
  std::vector<PhaseTime> activities;   ///< set-up, steps, output, ...: all of the wall time, on every machine
  std::vector<PhaseTime> phases;       ///< empty where a machine runs ahead: then only activities can be timed
  std::vector<CrackEvent> events;
  double cracked_area = 0;                             ///< m^2, all broken contact points at the stage's end
  std::map<std::string, double> cracked_area_by_direction;  ///< "horizontal" (normal within 30 deg of z), "vertical" (normal within 30 deg of the horizontal plane), "inclined"
  std::vector<int> free_blocks;                        ///< blocks that lost all contact, Blocks numbering
  std::vector<LooseBlocks> loose;  ///< the same as connected bodies, in the order in which they came off
  double dissipated_energy = 0;                        ///< J, by sliding, cracking and what blocks lose; in dynamic stages also by damping
  Dissipation<double> dissipated_by_contacts;          ///< J, the part of contact points, by mode
  double plastic_work = 0;                             ///< J, the part of plastic flow
  double fracture_work = 0;                            ///< J, the part of blocks that crack
  double safety_factor = 0;                            ///< strength reduction: the largest factor at which it stands
  double falling_factor = 0;                           ///< and the smallest at which it does not; 0: none was found
  double seconds = 0;                                  ///< coupled and dynamic stages: time reached, s
  double time_step = 0, stable_step = 0;               ///< s, dynamic stages
  std::optional<InitialBalance> initial;               ///< of the first mechanical stage of a model with initial stress
  EnergyBalance energy;                                ///< at the end of a dynamic stage
  std::optional<LaneTimes> lanes;                      ///< of a coupled stage

  /// Whether its last state is one to trust: in balance, or on its way in time where no balance is asked for.
  bool balanced() const {
    if (kind == "strength reduction") return safety_factor > 0;
    const bool on_its_way = kind == "dynamic" || kind == "thermal transient";
    return converged || stop_reason == "precision limit" || (on_its_way && stop_reason == "interrupted");
  }
};

/// One history: columns with units; a row whenever something was recorded (start, increments, stage ends).
struct HistoryTable {
  std::string name;
  std::vector<std::string> columns;   ///< "displacement.x", "temperature", "stress.zz", "reaction.z", ...
  std::vector<std::string> units;     ///< "m", "degC", "Pa", "N"
  struct Row {
    std::string stage;
    double time = 0;                  ///< stages done, with the fraction of the present one (load factor, share of a duration)
    double load_factor = 0;
    std::vector<double> values;
    bool balanced = true;             ///< false: the last state of a stage that failed, see StageResult::balanced
  };
  std::vector<Row> rows;
  /// Value of `column` at the end of `stage` ("" : last row). Throws std::out_of_range with the valid names, and where
  /// that row is not in balance.
  double at(const std::string& column, const std::string& stage) const;
  /// Values of `column` in all rows of `stage` ("" : all rows) that are in balance, in order. Throws if there are none.
  std::vector<double> values(const std::string& column, const std::string& stage) const;

 private:
  std::size_t index_of(const std::string& column) const;
  std::string not_in_balance(const std::string& stage) const;
};

struct RunResult {
  std::string device;                 ///< "cpu, 2 threads" or the GPU's name
  std::vector<StageResult> stages;
  std::vector<HistoryTable> histories;
  bool interrupted = false;
  bool all_converged() const {
    for (const auto& s : stages)
      if (!s.converged) return false;
    return true;
  }
};

}  // namespace ashlar
