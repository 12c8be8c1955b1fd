#include "solve/dynamic.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "model/loads.hpp"
#include "solve/contact_start.hpp"
#include "solve/contact_states.hpp"
#include "solve/crack_events.hpp"
#include "solve/relaxation.hpp"
#include "solve/stage_conditions.hpp"
#include "solve/time_parts.hpp"

namespace ashlar {

namespace {

constexpr double safety = 0.9;             // of the stable step, unless the deck chooses
constexpr double switching = 2;            // finer where contacts open and close: near the limit that feeds energy in
constexpr long look_interval = 10;         // steps between two looks at the energies
constexpr double runaway_energy = 1000;    // kinetic energy over all that the loads could have given
constexpr double records_per_stage = 100;  // unless the deck gives an interval
constexpr double steps_of_period = 50;     // of what changes in time
constexpr double ahead = 1.5;              // looks until blocks may be searched again, by their present speed

/// Integral of N rho dV at every block node, kg, the machine's numbering.
std::vector<double> lumped_mass(const Problem& problem) {
  std::vector<double> weight(3 * static_cast<std::size_t>(problem.blocks.node_count()));
  add_gravity(problem.model, problem.blocks.corners, {1, 0, 0}, weight);  // of a unit acceleration along x
  std::vector<double> mass(problem.blocks.node_count());
  for (std::size_t n = 0; n < mass.size(); ++n) mass[n] = weight[3 * n];
  return problem.to_machine(mass, 1);
}

/// Loads and given displacements as time goes on.
class GivenInTime {
 public:
  GivenInTime(const Problem& problem, int stage)
      : load_(problem.model, stage, *problem.backend, Field::load,
              [&](const auto& acting) { return problem.to_machine(mechanical_conditions(problem, acting).load, 3); }),
        velocity_(
            problem.model, stage, *problem.backend, Field::given_velocity,
            [&](const auto& acting) {
              const MechanicalConditions c = mechanical_conditions(problem, acting);
              std::vector<double> u(c.load.size(), 0.0);
              for (std::size_t i = 0; i < c.prescribed.size(); ++i) u[c.prescribed[i]] = c.displacement[i];
              return problem.to_machine(u, 3);
            },
            TimeParts::Sets::rate),
        times_(stage_times(problem.model)[stage]) {}

  /// Loads at `time`, s since the stage began.
  void load_at(double time) { load_.set(times_.begin + time); }
  /// Mean velocity of what is moved from one time to another, s since the stage began.
  void move(double from, double to) {
    velocity_.set_rate(times_.begin + from, std::min(times_.begin + to, times_.end));
  }

 private:
  TimeParts load_, velocity_;
  StageTimes times_;
};

/// One stage in motion.
class Motion {
 public:
  Motion(const Problem& problem, const Stage& stage, const DynamicLinks& links, StageResult& result)
      : problem_(problem),
        backend_(*problem.backend),
        stage_(stage),
        solve_(std::get<DynamicSolve>(stage.solve)),
        links_(links),
        result_(result),
        given_(problem, static_cast<int>(&stage - problem.model.stages.data())),
        mass_(lumped_mass(problem)),
        contacts_(problem),
        cracks_(problem) {}

  void run(bool moving) {
    choose_step();
    start(moving);
    const double interval = solve_.record_every > 0 ? solve_.record_every : solve_.duration / records_per_stage;
    int records = 0;
    long done = 0;
    const auto exchange_all = [&](Exchange& e) {
      e("motion.steps", done);
      e("motion.records", records);
      exchange(e);
    };
    if (links_.go_on) links_.go_on(exchange_all);
    for (long n = done + 1; n <= steps_; ++n) {
      evaluate(step_);
      result_.steps = n;
      const double seconds = static_cast<double>(n) * step_;
      result_.seconds = seconds;
      given_.load_at(seconds);
      const bool end = n == steps_, record = end || seconds >= (records + 1) * interval * (1 - 1e-12);
      if ((record || n == 1 || n % look_interval == 0) && !look(seconds, record)) return;
      if (record) {
        records = std::max(records + 1, static_cast<int>(seconds / interval * (1 + 1e-12)));
        const std::vector<double> velocity = present_velocity(seconds, end);
        if (!end) links_.record(records, seconds, velocity, result_.energy);
      }
      if (end) break;
      advance(seconds, step_, step_);
      if (n % look_interval != 0) continue;
      if (large() && backend_.moved_far(problem_.surface.skin / 2, ahead * look_interval * step_)) search();
      done = n;
      if (links_.keep) links_.keep(exchange_all);
      if (links_.watch(n, seconds / solve_.duration)) {
        result_.stop_reason = "interrupted";
        return;
      }
    }
    result_.converged = true;
    result_.stop_reason = "duration reached";
  }

 private:
  void choose_step() {
    const MotionSteps chosen = motion_steps(problem_, stage_);
    steps_ = chosen.count;
    result_.time_step = step_ = chosen.length;
    result_.stable_step = chosen.stable;
  }

  void start(bool moving) {
    std::vector<double> inverse_mass = mass_;
    for (double& m : inverse_mass) m = 1 / m;
    backend_.write(Field::inverse_mass, inverse_mass);
    const std::vector<double> fixed = backend_.read(Field::fixed);
    std::vector<double> velocity = backend_.read(Field::velocity);
    for (std::size_t i = 0; i < velocity.size(); ++i)
      if (!moving || (static_cast<unsigned>(fixed[i / 3]) >> i % 3) & 1u) velocity[i] = 0;
    backend_.write(Field::velocity, velocity);
    if (large())
      backend_.use_large_displacement();
    else
      find_force_at_rest();
    backend_.run(Phase::start_motion);
    if (problem_.contacts.count() > 0) state_ = backend_.read(Field::contact_state);
    if (large()) {
      begin_with_shear_of_springs(problem_);
      search();
    }
    evaluate(0);
    const MotionMeasure m = backend_.motion_sums(0);
    // The potential of the start without its temperature part, the scale that stays when nothing else acts.
    start_energy_ = m.kinetic + std::abs(m.potential - m.rest_work);
    // Central difference: half a step brings the velocity to the middle of the first one.
    advance(0, step_ / 2, 0);
  }

  /// Internal force of displacement zero (temperature, initial stress), into the kept force.
  void find_force_at_rest() {
    const std::vector<double> displacement = backend_.read(Field::displacement);
    backend_.write(Field::displacement, std::vector<double>(displacement.size(), 0.0));
    backend_.run(Phase::block_force);
    backend_.run(Phase::gather_force);
    if (!problem_.contacts.initial_traction.empty()) {
      const std::vector<double> slip = backend_.read(Field::slip);
      backend_.write(Field::slip, std::vector<double>(slip.size(), 0.0));
      backend_.run(Phase::spring_force);
      backend_.write(Field::slip, slip);
    }
    backend_.run(Phase::keep_force);
    backend_.write(Field::displacement, displacement);
  }

  bool large() const { return solve_.large_displacement; }
  /// Which blocks are near to each other.
  void search() {
    searched_ = backend_.read(Field::displacement);
    search_again();
  }
  void search_again() {
    std::vector<Vec3<double>> places = problem_.discretisation.block_points;
    for (std::size_t n = 0; n < places.size(); ++n)
      for (int i = 0; i < 3; ++i) places[n][i] += searched_[3 * n + i];
    backend_.write_candidates(find_candidates(problem_.surface, places), searched_);
  }

  /// Forces at a displacement that a step of `step_before` seconds led to.
  void evaluate(double step_before) {
    backend_.run(Phase::block_force);
    backend_.run(Phase::gather_force);
    if (large()) {
      Controls contacts;
      contacts.step_before = step_before;
      contacts.contact_damping = solve_.contact_damping;
      return backend_.run(Phase::moving_contacts, contacts);
    }
    Controls controls;
    controls.time_step = step_before;
    if (cracks_.can_separate()) backend_.run(Phase::advance_springs, controls);
    backend_.run(Phase::spring_force);
    controls.stiffness_damping = solve_.stiffness_damping;
    if (solve_.stiffness_damping > 0) backend_.run(Phase::damping_force, controls);
  }

  Controls step_controls(double velocity_step) const {
    Controls c;
    c.velocity_step = velocity_step;
    c.local_damping = solve_.local_damping;
    c.mass_damping = solve_.mass_damping;
    return c;
  }
  void advance(double seconds, double velocity_step, double step_before) {
    given_.move(seconds, seconds + step_);
    Controls c = step_controls(velocity_step);
    c.time_step = step_;
    c.step_before = step_before;
    backend_.run(Phase::step_motion, c);
  }

  /// Velocity at the present displacement: half a step on from the middle of the last one.
  std::vector<double> present_velocity(double seconds, bool keep) {
    given_.move(seconds - step_, seconds + step_);
    const std::vector<double> middle = backend_.read(Field::velocity);
    backend_.run(Phase::step_motion, step_controls(step_ / 2));
    std::vector<double> velocity = backend_.read(Field::velocity);
    if (!keep) backend_.write(Field::velocity, middle);
    return velocity;
  }

  /// Energies, runaway, new cracks. False: stopped.
  bool look(double seconds, bool record) {
    const MotionMeasure m = backend_.motion_sums(step_);
    const double could_be = start_energy_ + std::abs(m.supplied) + std::abs(m.rest_work);
    if (!std::isfinite(m.kinetic) || !std::isfinite(m.potential)) return stop_at_fastest("not finite");
    const bool runaway = m.kinetic > runaway_energy * could_be;
    if (record || runaway || !balanced_ || problem_.contacts.count() == 0 || large()) balance(m);
    if (runaway) return stop_at_fastest("runaway energy");
    if (cracks_.can_crack()) note_cracks(seconds);
    return true;
  }

  void exchange(Exchange& e) {
    e("motion.state", state_);
    for (double* number : {&start_energy_, &first_sum_, &first_strain_, &peak_, &largest_error_})
      e("motion.number", *number);
    e("motion.balanced", balanced_);
    for (const auto& [field, name] : {std::pair{Field::displacement_before, "displacement_before"},
                                      std::pair{Field::spring_dissipation, "spring_dissipation"},
                                      std::pair{Field::load_work, "load_work"},
                                      std::pair{Field::damping_work, "damping_work"}})
      exchange_field(e, name, backend_, field);
    if (!large()) return;
    e("motion.searched", searched_);
    if (e.taking()) search_again();
    for (const auto& [field, name] :
         {std::pair{Field::probe_memory, "probe_memory"}, std::pair{Field::probe_loss, "probe_loss"}})
      exchange_field(e, name, backend_, field);
  }

  bool stop_at_fastest(const char* what) {
    const std::vector<double> v = backend_.read(Field::velocity);
    std::size_t fastest = 0;
    const auto speed = [&](std::size_t i) { return std::isfinite(v[i]) ? std::abs(v[i]) : HUGE_VAL; };
    for (std::size_t i = 0; i < v.size(); ++i)
      if (speed(i) > speed(fastest)) fastest = i;
    const Vec3<double> at = problem_.discretisation.block_points[fastest / 3];
    char text[160];
    std::snprintf(text, sizeof text, "%s at (%.6g, %.6g, %.6g), step %ld", what, at.x + 0.0, at.y + 0.0, at.z + 0.0,
                  result_.steps);
    result_.stop_reason = text;
    return false;
  }

  void balance(const MotionMeasure& m) {
    EnergyBalance& e = result_.energy;
    e.kinetic = m.kinetic;
    e.strain = m.potential;
    e.dissipated = m.damped;
    e.contacts = {};
    e.external_work = m.supplied;
    if (large()) {
      e.contacts.friction = m.rubbed;
    } else if (problem_.contacts.count() > 0) {
      const std::vector<double> lost = backend_.read(Field::spring_dissipation);
      const std::vector<ContactPoint> points = contacts_.read();
      for (int c = 0; c < problem_.contacts.count(); ++c) {
        // force . u took the whole relative displacement of a spring, its slip is no strain.
        const double area = problem_.contacts.area[c];
        e.strain -= 0.5 * area * dot(points[c].rubbing, points[c].slip);
        if (!problem_.contacts.opening.empty())
          e.strain += 0.5 * area * points[c].traction.normal * problem_.contacts.opening[c];
        if (!problem_.contacts.initial_traction.empty()) e.strain -= 0.5 * area * unfelt(points[c], c);
        e.contacts = e.contacts + Dissipation<double>{lost[3 * c], lost[3 * c + 1], lost[3 * c + 2]};
      }
    }
    e.dissipated += e.contacts.sum();
    const double sum = e.kinetic + e.strain + e.dissipated - e.external_work;
    if (!balanced_) {
      first_sum_ = sum;
      first_strain_ = e.strain;
      balanced_ = true;
    }
    peak_ = std::max({peak_, e.kinetic, std::abs(e.strain - first_strain_), std::abs(e.external_work)});
    e.error = sum - first_sum_;
    if (peak_ > 0) largest_error_ = std::max(largest_error_, std::abs(e.error));
    e.drift = peak_ > 0 ? largest_error_ / peak_ : 0;
  }

  /// What the force at rest of a spring takes too much, over the area: initial traction times slip or opening.
  double unfelt(const ContactPoint& point, int c) const {
    const Split<double> initial = split(problem_.contacts.initial_traction[c], problem_.contacts.normal[c]);
    if (!point.joined()) return initial.normal * point.gap.normal + dot(initial.shear, point.gap.shear);
    return dot(initial.shear, point.slip);
  }

  void note_cracks(double seconds) {
    const std::vector<double> state = backend_.read(Field::contact_state);
    const ContactPoints& contacts = problem_.contacts;
    CrackEvent event;
    for (int c = 0; c < contacts.count(); ++c) {
      if (state[c] == state_[c] || !is_cracked(static_cast<ContactState>(static_cast<int>(state[c]))) ||
          event.contact_points++ > 0)
        continue;
      event.place = problem_.place_of_contact(c);
      for (int i = 0; i < 3; ++i) event.place[i] += 0.0;  // meshes write -0
      event.interface = problem_.model.interfaces[contacts.interface[c]].name;
      event.mode = state[c] == static_cast<double>(ContactState::cracked_in_tension) ? "tension" : "shear";
    }
    if (event.contact_points == 0) return;
    event.load_factor = 1;
    event.seconds = seconds;
    state_ = state;
    result_.events.push_back(event);
    links_.cracked(event);
  }

  const Problem& problem_;
  Backend& backend_;
  const Stage& stage_;
  const DynamicSolve& solve_;
  const DynamicLinks& links_;
  StageResult& result_;
  GivenInTime given_;
  std::vector<double> mass_;      ///< [block nodes] kg
  std::vector<double> state_;     ///< of the contact points at the last look
  std::vector<double> searched_;  ///< displacement of the last search of contacts
  ContactReader contacts_;
  CrackEvents cracks_;
  double step_ = 0;
  long steps_ = 0;
  double start_energy_ = 0, first_sum_ = 0, first_strain_ = 0, peak_ = 0, largest_error_ = 0;
  bool balanced_ = false;
};

}  // namespace

StableStep stable_step(const Problem& problem, double damping, bool large) {
  problem.backend->run(Phase::stiffness_bound);
  const std::vector<double> stiffness = problem.backend->read(Field::stiffness), mass = lumped_mass(problem);
  const ContactPoints& contacts = problem.contacts;
  const std::vector<int>& renumber = problem.discretisation.blocks.new_node;
  const ContactReader reader(problem);
  std::vector<double> springs(mass.size()), finer(mass.size());
  if (large) springs = contact_stiffness(problem.surface, static_cast<int>(mass.size()));
  for (int c = 0; c < contacts.count() && !large; ++c) {
    if (contacts.is_tip(c)) continue;
    const double k = contacts.area[c] * std::max(contacts.normal_stiffness[c], contacts.shear_stiffness[c]);
    const double more = reader.law(c).separates() ? switching * switching : 1;
    contacts.each_end(c, [&](int node, double weight) {
      springs[renumber[node]] += k * std::abs(weight);
      finer[renumber[node]] += more * k * std::abs(weight);
    });
  }
  double blocks = 0, between = 0, resolved = 0;  // squares of frequencies over 4, 1/s^2
  for (std::size_t n = 0; n < mass.size(); ++n) {
    blocks = std::max(blocks, stiffness[n] / (4 * mass[n]));
    between = std::max(between, springs[n] / (2 * mass[n]));
    resolved = std::max(resolved, finer[n] / (2 * mass[n]));
  }
  StableStep step;
  step.blocks = 1 / std::sqrt(blocks);
  step.springs = between > 0 ? 1 / std::sqrt(between) : 0;
  if (large) {  // damped is what contacts do alone: dt^2 lambda(K) / 4 + dt lambda(C) / 2 <= 1
    const double resists = damping * between;
    const auto stable = [&](double more) { return 1 / (resists + std::sqrt(resists * resists + blocks + more)); };
    step.together = stable(between);
    step.switching = stable(switching * switching * between);
    return step;
  }
  const auto damped = [&](double square) {
    const double undamped = 1 / std::sqrt(square), xi = damping / undamped;
    return undamped * (std::sqrt(1 + xi * xi) - xi);
  };
  step.together = damped(blocks + between);
  step.switching = damped(blocks + resolved);
  return step;
}

MotionSteps motion_steps(const Problem& problem, const Stage& stage) {
  const auto& solve = std::get<DynamicSolve>(stage.solve);
  if (solve.large_displacement && problem.backend->rounding() > 1e-10)
    throw DeckError(stage.where, "stage '" + stage.name +
                                     "': large_displacement needs double precision, because strains are small "
                                     "differences of large movements; leave --precision single out");
  const double damping = solve.large_displacement ? solve.contact_damping : solve.stiffness_damping;
  const StableStep bounds = stable_step(problem, damping, solve.large_displacement);
  const double stable = bounds.together;
  if (solve.time_step > stable) {
    char text[200];
    std::snprintf(text, sizeof text,
                  "time_step %.4g s is above the stable step of this mesh, %.4g s; give less, or leave it out for one "
                  "that fits",
                  solve.time_step, stable);
    throw DeckError(stage.where, "stage '" + stage.name + "': " + text);
  }
  double longest = solve.time_factor > 0 ? solve.time_factor * stable : safety * bounds.switching;
  const int index = static_cast<int>(&stage - problem.model.stages.data());
  longest = std::min(longest, shortest_period(problem.model, index) / steps_of_period);
  if (solve.time_step > 0) longest = solve.time_step;
  MotionSteps steps;
  steps.count = std::max(1L, static_cast<long>(std::ceil(solve.duration / longest * (1 - 1e-12))));
  steps.length = solve.duration / static_cast<double>(steps.count);
  steps.stable = stable;
  return steps;
}

void move_in_time(const Problem& problem, const Stage& stage, bool moving, const DynamicLinks& links,
                  StageResult& result) {
  Motion motion(problem, stage, links, result);
  motion.run(moving);
  CrackEvents cracks(problem);
  cracks.fill_areas(result);
  result.dissipated_energy = result.energy.dissipated;
}

}  // namespace ashlar
