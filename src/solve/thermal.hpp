#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "solve/problem.hpp"

/// Thermal stages: steady temperature by conjugate gradients, transient by forward Euler, both matrix-free (paper
/// (6)-(10); numerics 6). The temperature lives in the backend from stage to stage, one value per mesh node.
namespace ashlar {

struct ThermalResult {
  bool converged = false;
  bool interrupted = false;
  long steps = 0;           ///< heat steps or iterations
  double ratio = 0;         ///< steady: norm of the residual over its start
  double time_step = 0;     ///< s, transient
  std::string stop_reason;  ///< "converged", "precision limit", "step limit", "not finite", "interrupted"
};

struct ThermalProgress {
  long step = 0;
  double fraction = 0;  ///< of the march: exact for transients, estimated for steady stages
  double time = 0;      ///< s since the stage began; 0 in steady stages
  double ratio = 0;     ///< steady: norm of the residual over its start
};
/// Called after every step; true stops the stage.
using ThermalWatch = std::function<bool(const ThermalProgress&)>;
/// Called once the stage is set up; of a transient it may put back a state within it and returns the steps that that
/// has done.
using ThermalResume = std::function<long()>;

/// Temperatures that the deck gives when stage `stage` (0-based) begins: initial_temperature in the first stage where
/// it acts, on the nodes of its regions (all, if it names none), and temperature_field on all nodes, whenever it acts.
/// `temperature` [mesh nodes], degC, the mesh's own order.
void prescribe_temperature(const Model& model, int stage, std::vector<double>& temperature);

/// Temperature of the present state, degC, [mesh nodes] in the mesh's own order.
std::vector<double> read_temperature(const Problem& problem);
void write_temperature(const Problem& problem, Backend& backend, const std::vector<double>& temperature);

/// Steps of a transient; none of a steady stage, whose iterations only solving tells.
struct ThermalSteps {
  long count = 0;
  double length = 0;  ///< s
};

/// The transient of a thermal or coupled stage, piece by piece in time, from the temperature in a backend.
class HeatMarch {
 public:
  /// Sets stage `stage` (0-based) up in the backend; both outlive this. Throws DeckError: a material without
  /// conductivity or heat capacity.
  HeatMarch(const Problem& problem, Backend& backend, int stage);
  ~HeatMarch();
  /// Times are s since the stage began. @param done steps on the way that have been made
  ThermalSteps steps(double from, double to) const;
  /// Joints that resist heat pass from now on what their open shares let pass (open_to_heat; empty: none resists).
  void open_joints(const std::vector<double>& open);
  ThermalResult march(double from, double to, const ThermalWatch& watch = {}, long done = 0);

 private:
  struct BoundaryInTime;
  const Problem& problem_;
  Backend& backend_;
  int stage_;
  double longest_;            ///< s, of a step
  std::vector<double> open_;  ///< see open_joints
  std::unique_ptr<BoundaryInTime> boundary_;
};

/// Sets thermal stage `stage` (0-based) up in the backend and says how it will be marched through. Throws DeckError as
/// solve_thermal does.
ThermalSteps thermal_steps(Problem& problem, int stage);

/// Solves thermal stage `stage` (0-based) from the temperature in the backend. Throws DeckError: a material without
/// conductivity or heat capacity, a steady stage that nothing ties to a temperature.
ThermalResult solve_thermal(Problem& problem, int stage, const ThermalWatch& watch = {},
                            const ThermalResume& resume = {});

}  // namespace ashlar
