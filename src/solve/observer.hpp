#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "solve/checkpoint.hpp"
#include "solve/result.hpp"

/// How a running solver tells the world: progress, events and fields. Implemented by io/ (files) and main (terminal).
namespace ashlar {

/// All fields at one moment, in the deck's own order: block nodes (Blocks), mesh elements (Mesh), contact points (ContactPoints).
/// An empty vector means the field does not exist in this model.
struct Snapshot {
  std::string stage;
  int stage_number = 0;               ///< 1, 2, ...
  double time = 0;                    ///< same as HistoryTable::Row::time
  double load_factor = 0;
  bool stage_end = true;
  bool balanced = true;               ///< false: the last state of a stage that failed
  std::vector<double> displacement;       ///< [3 * block nodes] m, counted from the last reset
  std::vector<double> temperature;        ///< [block nodes] degC
  std::vector<double> stress;             ///< [6 * elements] Pa, element mean: xx yy zz xy yz zx
  std::vector<double> nodal_stress;       ///< [6 * block nodes] Pa, Gauss-point extrapolation averaged by volume within one region and block
  std::vector<double> principal_stress;   ///< [3 * elements] Pa, of the element mean, largest (most tensile) first
  std::vector<double> plastic_strain;     ///< [elements] equivalent plastic strain, element mean
  std::vector<double> damage;             ///< [elements] share of strength that is gone, element mean
  std::vector<double> crack_normal;       ///< [3 * elements] unit normal of the crack plane of the most damaged Gauss point; 0: none
  std::vector<double> opening;            ///< [contact points] m, normal gap, positive open
  std::vector<double> slip;               ///< [contact points] m, tangential relative displacement
  std::vector<double> normal_traction;    ///< [contact points] Pa, tension positive
  std::vector<double> shear_traction;     ///< [contact points] Pa, magnitude
  std::vector<std::uint8_t>
      contact_state;  ///< [contact points] 0 intact, 1 cracked in tension, 2 cracked in shear, 3 softening
  std::vector<double> contact_damage;  ///< [contact points] broken share of the bond
};

struct Progress {
  int stage_number = 0, stage_count = 0;
  std::string stage, kind;
  long step = 0;
  double ratio = 0, target = 0;       ///< convergence measure and its goal
  int increment = 0, increments = 0;  ///< fracture stages, coupled ones (equilibria), thermal transients (percent of duration)
  double fraction = 0;                ///< 0..1 of the stage, estimated; for the ETA
  double cracked_fraction = 0;        ///< broken contact points / all breakable ones
};

class Observer {
 public:
  virtual ~Observer() = default;
  virtual void stage_begins(int /*number*/, const std::string& /*name*/, const std::string& /*kind*/) {}
  virtual void progress(const Progress&) {}               ///< at most about ten times a second
  virtual void crack(const std::string& /*stage*/, const CrackEvent&) {}
  virtual void output(const Snapshot&) {}
  virtual void history_row(const HistoryTable&) {}       ///< the table's last row is new
  virtual void stage_ends(const StageResult&) {}
  virtual bool wants_checkpoint() { return false; }       ///< asked at places within stages that a run can go on from
  virtual void checkpoint(const Checkpoint&) {}           ///< after every stage, and where one was wanted
  virtual bool interrupted() { return false; }            ///< asked between steps; true: stop with reason "interrupted"
};

}  // namespace ashlar
