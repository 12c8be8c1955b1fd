#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "model/blocks.hpp"
#include "model/contact/moving.hpp"
#include "model/discretisation.hpp"
#include "model/loads.hpp"
#include "physics/interface_laws/spring.hpp"
#include "physics/laws/laws.hpp"

/// What a solver sees of a machine: named phases to run, scalars to decide by, whole fields only for set-up and output.
namespace ashlar {

/// One named piece of a step: the unit of order, timing and test.
enum class Phase : std::uint8_t {
  block_force,           ///< element corner forces
  gather_force,          ///< corner forces to nodes
  spring_force,          ///< contact springs, added to nodes
  move_nodes,            ///< velocity, then displacement
  relaxation_steps,      ///< the four above, Controls::steps times, as machines do that fuse them
  stop_nodes,            ///< velocity 0
  keep_force,            ///< remember the force for the next stiffness estimate
  relaxation_sums,       ///< partial sums behind Backend::relaxation_sums
  stiffness_bound,       ///< Gershgorin bound of the blocks' stiffness at every node, into Field::stiffness
  block_stress,          ///< Gauss-point stress for output
  spring_utilisation,    ///< behind Backend::largest_utilisation
  spring_crossing,       ///< behind Backend::first_crossing
  advance_history,       ///< what Gauss points remember, moved on to the present displacement
  break_springs,         ///< behind Backend::break_springs
  keep_springs,          ///< behind Backend::keep_springs
  look_at_springs,       ///< behind Backend::loosened_springs
  heat_flow,             ///< conduction and film at the present temperature, into Field::heat_flow
  step_heat,             ///< temperature after Controls::time_step, held nodes kept
  heat_steps,            ///< the two above, Controls::steps times, as machines do that fuse them
  heat_bound,            ///< diagonal and row sums of conduction and film, into Field::heat_bound
  start_search,          ///< steady stages: residual from Field::heat_flow, first direction of conjugate gradients
  search_flow,           ///< conduction and film of the direction
  advance_search,        ///< temperature moved by Controls::search_length along the direction
  turn_search,           ///< next direction, keeping Controls::search_keep of the last
  balance_residual,      ///< elastic search: what is out of balance (load less Field::force)
  balance_precondition,  ///< inverse virtual mass times residual
  balance_turn,          ///< next direction, keeping Controls::search_keep of the last
  balance_product,       ///< stiffness times direction, springs bonded, no temperature
  balance_advance,       ///< displacement moved by Controls::search_length along the direction
  gauss_temperature,     ///< Field::warming from the present temperature
  start_motion,          ///< dynamic stages: no work done yet, no stiffness damping; kept force: at rest
  advance_springs,       ///< springs crack and slide by the present displacement
  damping_force,         ///< stiffness-proportional: Controls::stiffness_damping times elastic force of the velocity
  moving_contacts,       ///< large displacement: contacts of blocks among the candidates, after a step of
                         ///< Controls::step_before, added to nodes
  step_motion,           ///< velocity, then displacement, in time with the real mass
  combine_parts,         ///< Controls::combined of the moment from its parts and Controls::factors
  count
};
const char* phase_name(Phase phase);

/// Arrays that cross between solver and machine. Always double outside; vectors are packed x y z.
enum class Field : std::uint8_t {
  displacement,         ///< [3 * block nodes] m
  velocity,             ///< [3 * block nodes]
  load,                 ///< [3 * block nodes] N
  force,                ///< [3 * block nodes] N, internal and contact
  inverse_mass,         ///< [block nodes]
  fixed,                ///< [block nodes] bits 0 1 2: x y z held
  stiffness,            ///< [block nodes] N/m, row-sum bound, largest of the three directions
  warming,              ///< [Gauss points] K above the reference temperature
  history,              ///< [numbers a point remembers][Gauss points that remember], see Setup::first_history
  stress,               ///< [6 * Gauss points] Pa
  slip,                 ///< [3 * contact points] m
  contact_state,        ///< [contact points] ContactState as a number
  initial_gap,          ///< [3 * contact points] m, ContactPoints::initial_gap; empty: none
  crack_water,          ///< [contact points] Pa, pressure where they are open; empty: all is dry
  contact_damage,       ///< [contact points] broken share of a bond that softens; empty: nothing softens
  joined,               ///< [contact points] 1: its sides held each other at the last Backend::loosened_springs
  displacement_before,  ///< [3 * block nodes] m, of the last equilibrium (keep_equilibrium); motions: of the step
                        ///< before
  kept_slip,            ///< [3 * contact points] m, of the last equilibrium
  displacement_rate,    ///< [3 * block nodes] m per load factor, see keep_equilibrium; empty until there was one
  spring_dissipation,   ///< [3 * contact points] J since start_motion: of opening, shear, friction
  load_work,            ///< [block nodes] J since start_motion
  damping_work,         ///< [block nodes] J since start_motion
  temperature,          ///< [mesh nodes] degC
  heat,                 ///< [mesh nodes] W into the body: flux, and film times ambient
  inverse_capacity,     ///< [mesh nodes] K/J
  held,                 ///< [mesh nodes] 1: temperature is given
  given_velocity,       ///< [3 * block nodes] m/s of held components in motions; empty: at rest
  film,                 ///< [entries of the films' matrix] W/K
  given_temperature,    ///< [mesh nodes] degC that held nodes take with the next step; empty: they keep theirs
  heat_flow,            ///< [mesh nodes] W leaving each node by conduction and film
  heat_bound,           ///< [2 * mesh nodes] W/K, diagonal and absolute row sum of conduction and film
  probe_memory,         ///< [numbers * probes] what contacts of large displacement remember; empty: there are none
  probe_loss,           ///< [probes] J since start_motion
};

/// Numbers that a step needs from the solver.
struct Controls {
  double local_damping = 0;           ///< Cundall's alpha
  double viscous_damping = 0;         ///< c of one unit step, < 2
  double break_threshold = 1;         ///< break_springs: share of strength
  double time_step = 0;               ///< s; of displacement in motions
  double velocity_step = 0;           ///< s, motions: half of time_step in the first step
  double step_before = 0;             ///< s, motions: the time_step before this one; 0 in the first
  double mass_damping = 0;            ///< motions: Rayleigh, 1/s
  double stiffness_damping = 0;       ///< motions: Rayleigh, s
  double contact_damping = 0;         ///< moving_contacts: s
  double search_length = 0;           ///< conjugate gradients: alpha
  double search_keep = 0;             ///< conjugate gradients: beta
  int steps = 1;                      ///< relaxation_steps, heat_steps
  Field combined{};                   ///< combine_parts
  std::span<const double> factors{};  ///< combine_parts: of every part after the first
};

struct RelaxationMeasure {
  double unbalanced = 0;  ///< |load - force| over free components, N
  double load = 0;        ///< |load|, N
  double reaction = 0;    ///< |load - force| over held components, N
  double kinetic = 0;     ///< J
  double load_work = 0;   ///< u . load, J
  double force_work = 0;  ///< u . force, J
  double curvature = 0;   ///< v . (force - kept force)
  double motion = 0;      ///< v . m v
};

/// Sums over nodes that are not held.
struct HeatMeasure {
  double residual = 0;        ///< |residual|, W
  double preconditioned = 0;  ///< residual . residual / diagonal, W K
  double along = 0;           ///< direction . Field::heat_flow, W K
};

/// Contact points that cracked together.
struct CrackMeasure {
  int count = 0;
  int worst = -1;            ///< the first of those that used most of their strength, or of those that softened
  ContactState mode{};       ///< of the worst
  Dissipation<double> lost;  ///< J, by all contact points
};

/// Contact points whose state has changed.
struct ChangedContacts {
  bool known = false;  ///< else any may have
  std::vector<int> points{};
};

/// Energies of a motion between its last two displacements, blocks and springs (central difference: velocity and
/// the product of two displacements belong to the same moment, and their sum is kept to rounding).
struct MotionMeasure {
  double kinetic = 0;    ///< J
  double potential = 0;  ///< J, (u_before . force(u) + u . force(0)) / 2: strain energy, less work of thermal strain
  double rest_work = 0;  ///< J, u . force(0)
  double supplied = 0;   ///< J since start_motion, work of the load
  double damped = 0;     ///< J since start_motion, taken out by damping
  double rubbed = 0;     ///< J since start_motion, large displacement: friction, and contacts that ended pressed
};

/// Groups of nodes that relaxation moves together (see GroupView), machine's numbering.
struct NodeGroups {
  std::vector<int> first{0};  ///< [groups + 1] into member
  std::vector<int> member;    ///< [block nodes] every node once
  std::vector<double> pull;   ///< [groups] 1/kg
};

/// The coarse part of the elastic search: nodes in aggregates, and how these give way, each as a rigid body (three
/// translations, three rotations about its centre), to resultant forces and moments. Machine's numbering.
struct CoarseBalance {
  std::vector<int> aggregate;      ///< [block nodes]
  std::vector<int> first;          ///< [aggregates + 1] into member
  std::vector<int> member;         ///< [block nodes]
  std::vector<double> centre;      ///< [3 * aggregates] m
  std::vector<double> compliance;  ///< [6 * aggregates squared] symmetric; m, rad per N, N m
  int count() const { return static_cast<int>(first.size()) - 1; }
};
/// Of a coarse part: its compliance is a full matrix, which every iteration reads.
inline constexpr int most_aggregates = 64;

/// Sums of the elastic search over free components.
struct BalanceMeasure {
  double residual = 0;        ///< |residual|, N
  double preconditioned = 0;  ///< residual . preconditioned residual, N m
};

/// What a backend is built from. The model's laws by material; everything is copied to the machine.
struct Setup {
  const Discretisation& discretisation;
  const ContactPoints& contacts;  ///< block nodes numbered as in Blocks
  std::vector<BlockLaw> laws{};   ///< [materials]
  std::vector<char> bbar{};       ///< [materials] 0: full, 1: B-bar hex8 and wedge6, 2: tet4 averaged too
  std::vector<SpringLaw<double>> interface_laws{};  ///< [interfaces]
  std::vector<double> conductivity{};               ///< [materials] W/(m K); empty: no thermal stages
  double reference_temperature = 0;                 ///< degC
  bool heat_only = false;                           ///< nothing of the stress lane: no phase or field of it
  bool motion = false;                              ///< whether a stage is dynamic
  bool crack_water = false;                         ///< whether water may stand in cracks
  const ContactSurface* surface = nullptr;          ///< null or empty: no stage is in large displacement

  /// [batches + 1] Gauss points that remember: first of each batch, Gauss points in a batch as in Batch::gauss.
  std::vector<int> first_history() const;
};

class Backend {
 public:
  virtual ~Backend() = default;
  virtual std::string name() const = 0;
  virtual double rounding() const = 0;  ///< distance from 1 to the next number
  /// Waits until everything asked for has happened.
  virtual void finish() = 0;
  /// Bytes per second that a plain copy reads and writes on the machine, measured.
  virtual double copy_bandwidth() = 0;
  /// Runs one phase to its end and books its wall time.
  void run(Phase phase, const Controls& controls = {});
  /// Whether run() comes back before the phase has ended.
  virtual bool runs_ahead() const = 0;
  /// Seconds spent in a phase since the backend was made; of machines that run ahead, in sending it off.
  double seconds(Phase phase) const { return seconds_[static_cast<std::size_t>(phase)]; }
  /// Steps of relaxation: block_force, gather_force, spring_force, move_nodes. Machines may fuse them; the bits stay.
  virtual void relax(const Controls& controls, int steps);
  /// Steps of a transient: heat_flow, step_heat.
  virtual void march_heat(const Controls& controls, int steps);
  virtual RelaxationMeasure relaxation_sums() = 0;
  virtual HeatMeasure heat_sums() = 0;
  /// Share of its strength that the worst contact point uses; not above 0 where nothing can break.
  virtual double largest_utilisation() = 0;
  /// Paths of loads: the present displacement and slip become the equilibrium to go on from. With `advance` > 0, the
  /// load factor since the last one, the way between the two gives the rate to go on at.
  virtual void keep_equilibrium(double advance) = 0;
  /// Back to that equilibrium and, unless `advance` of the load factor is 0, straight on at the rate.
  virtual void leave_equilibrium(double advance) = 0;
  /// The present displacement and slip become the end of the way that begins there.
  virtual void keep_way_end() = 0;
  /// To a fraction of that way, with the slip of its beginning.
  virtual void go_part_of_way(double fraction) = 0;
  virtual void go_to_way_end() = 0;
  /// Largest component of displacement since that equilibrium, m.
  virtual double moved_since_equilibrium() = 0;
  /// Fraction of that way at which a contact point first uses its strength; above 1: none does.
  virtual double first_crossing() = 0;
  /// Cracks all contact points that use at least `share` of what the worst one uses, which is `most`.
  virtual CrackMeasure break_springs(double most, double share) = 0;
  /// Those that have changed since this was last asked for, which one does for all: VirtualMass.
  virtual ChangedContacts take_changed_contacts() = 0;
  /// Slip and damage of an equilibrium become those to go on from.
  virtual CrackMeasure keep_springs() = 0;
  /// Contact points whose sides held each other at the last look (Field::joined) and no longer do.
  virtual long loosened_springs() = 0;
  /// After a force at the displacement that a step of `step_before` seconds led to.
  virtual MotionMeasure motion_sums(double step_before) = 0;
  /// Every node is by itself until groups are written.
  virtual void write_groups(const NodeGroups& groups) = 0;
  virtual void write_coarse(const CoarseBalance& coarse) = 0;
  virtual BalanceMeasure balance_sums() = 0;
  /// direction . stiffness . direction of the elastic search over free components, N m.
  virtual double balance_along() = 0;
  /// Parts of a field that is linear in a few numbers: load, heat, film, given_velocity or given_temperature is the
  /// first part plus factors times the others. No parts: forgotten, with what was given.
  virtual void write_parts(Field field, const std::vector<std::vector<double>>& parts) = 0;
  /// Exchange with the surroundings, nodes numbered as on the machine.
  virtual void write_films(const FilmMatrix& films) = 0;
  virtual std::size_t size(Field field) const = 0;
  virtual void write(Field field, std::span<const double> values) = 0;
  virtual void read(Field field, std::span<double> values) = 0;
  /// Takes Field::temperature of another machine of the same model that has nothing left to do; machine to machine
  /// where both are of a kind. Done when it returns.
  virtual void take_temperature(Backend& from) = 0;
  /// All bits of a field, to go on from later. Of fields that are sums of two numbers first the one, then the other.
  virtual std::vector<double> save(Field field) const = 0;
  virtual void restore(Field field, std::span<const double> values) = 0;
  /// Bytes of its arrays, with those that stages add at most.
  virtual std::size_t memory_bytes() const = 0;
  /// Whether stress takes account of Field::warming. Off until a stage has a temperature.
  virtual void use_warming(bool on) = 0;
  /// From now on blocks turn and move far: motions take elements in large displacement and contacts of
  /// Setup::surface instead of springs.
  virtual void use_large_displacement() = 0;
  /// What a search has found at `displacement` [3 * block nodes] m.
  virtual void write_candidates(const ContactCandidates& candidates, const std::vector<double>& displacement) = 0;
  /// Whether a probe has moved by more than `limit` m since then, or could in `ahead` seconds.
  virtual bool moved_far(double limit, double ahead) = 0;
  /// Divides the strength of every law and interface, as it was at set-up, by `factor`.
  virtual void weaken(double factor) = 0;

  std::vector<double> read(Field field) {
    std::vector<double> values(size(field));
    read(field, values);
    return values;
  }

 private:
  virtual void run_phase(Phase phase, const Controls& controls) = 0;
  std::array<double, static_cast<std::size_t>(Phase::count)> seconds_{};
};

/// @param threads number of threads; 0: all cores
std::unique_ptr<Backend> make_cpu_backend(const Setup& setup, Precision precision, int threads);

}  // namespace ashlar
