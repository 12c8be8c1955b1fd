#include "solve/solver.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <utility>

#include "solve/activity.hpp"
#include "solve/block_state.hpp"
#include "solve/coupled.hpp"
#include "solve/dynamic.hpp"
#include "solve/elastic_start.hpp"
#include "solve/fracture.hpp"
#include "solve/grouting.hpp"
#include "solve/plan.hpp"
#include "solve/recorder.hpp"
#include "solve/relaxation.hpp"
#include "solve/stage_conditions.hpp"
#include "solve/thermal.hpp"
#include "solve/time_parts.hpp"
#include "solve/virtual_mass.hpp"

namespace ashlar {

namespace {

using Clock = std::chrono::steady_clock;

bool is_dynamic(const Stage& stage) { return std::holds_alternative<DynamicSolve>(stage.solve); }
bool is_coupled(const Stage& stage) { return std::holds_alternative<CoupledSolve>(stage.solve); }

std::string kind_of(const Stage& stage) {
  if (const auto* thermal = std::get_if<ThermalSolve>(&stage.solve))
    return thermal->steady ? "thermal steady" : "thermal transient";
  if (is_dynamic(stage)) return "dynamic";
  if (is_coupled(stage)) return "coupled";
  if (std::holds_alternative<StrengthReduction>(stage.solve)) return "strength reduction";
  return std::holds_alternative<FractureSolve>(stage.solve) ? "fracture" : "static";
}

bool has_temperature(const Model& model) {
  for (const Stage& s : model.stages)
    if (is_thermal(s)) return true;
  for (const Condition& c : model.conditions)
    if (std::holds_alternative<TemperatureField>(c.kind) || std::holds_alternative<InitialTemperature>(c.kind))
      return true;
  return false;
}

/// Fraction of a relaxation that is done, from how far the ratio has fallen.
double relaxation_fraction(double start, double ratio, double goal) {
  if (!(ratio > 0) || !(start > goal)) return 0;
  return std::clamp(std::log(start / ratio) / std::log(start / goal), 0.0, 1.0);
}

class Run {
 public:
  Run(Problem& problem, Observer& observer, const Restart& restart)
      : problem_(problem),
        observer_(observer),
        restart_(restart),
        clock_(*problem.backend),
        recorder_(problem, observer),
        warm_(has_temperature(problem.model)),
        temperature_(problem.model.mesh.points.size(), problem.model.reference_temperature),
        body_temperature_(temperature_),
        shift_(temperature_.size(), 0.0) {
    result_.device = problem.backend->name();
    if (problem.heat_lane && problem.heat_lane->beside())
      result_.device += ", beside it " + problem.heat_lane->backend().name() + " for heat";
  }

  RunResult run() {
    for (const Stage& s : problem_.model.stages)
      if (is_dynamic(s)) motion_steps(problem_, s);  // refused before anything is solved
    if (restart_.stage_start) {
      stage_ = restart_.stage_start->stage;
      Exchange e(*restart_.stage_start);
      exchange(e);
    } else {
      if (warm_ && !problem_.model.stages.empty()) prescribe_temperature(problem_.model, 0, temperature_);
      if (warm_) recorder_.temperature(temperature_);
      if (!problem_.model.stages.empty()) recorder_.history_rows({0, 0, 0, false});
    }
    while (stage_ < static_cast<int>(problem_.model.stages.size())) {
      run_stage();
      if (!result_.stages.back().converged) break;
      ++stage_;
      const During checkpoints(clock_, Activity::checkpoints);
      Checkpoint checkpoint{stage_, false, {}, {}};
      Exchange e(checkpoint);
      exchange(e);
      observer_.checkpoint(checkpoint);
    }
    result_.histories = recorder_.take_histories();
    return std::move(result_);
  }

 private:
  const Stage& stage() const { return problem_.model.stages[stage_]; }

  // ------------------------------------------------------------------ checkpoints

  /// All that later stages depend on.
  void exchange(Exchange& e) {
    e("run.stages", result_.stages);
    e("run.temperature", temperature_);
    e("run.body_temperature", body_temperature_);
    e("run.surface_load", surface_load_);
    e("run.shift", shift_);
    e("run.temperatures_at_end", temperatures_at_end_);
    e("run.plastic_work", block_work_.plastic);
    e("run.fracture_work", block_work_.fracture);
    e("run.lost_by_contacts", lost_by_contacts_);
    e("run.balance_told", balance_told_);
    e("run.warming_used", warming_used_);
    recorder_.exchange(e);
    e("run.opening", problem_.contacts.opening);
    if (e.taking()) write_openings(problem_);
    for (const auto& [field, name] :
         {std::pair{Field::displacement, "displacement"}, std::pair{Field::velocity, "velocity"},
          std::pair{Field::load, "load"}, std::pair{Field::force, "force"}, std::pair{Field::fixed, "fixed"},
          std::pair{Field::warming, "warming"}, std::pair{Field::history, "history"}, std::pair{Field::slip, "slip"},
          std::pair{Field::contact_state, "contact_state"}, std::pair{Field::contact_damage, "contact_damage"},
          std::pair{Field::crack_water, "crack_water"}, std::pair{Field::temperature, "temperature"},
          std::pair{Field::probe_memory, "probe_memory"}})
      exchange_field(e, name, *problem_.backend, field);
    if (e.taking()) problem_.backend->use_warming(warming_used_);
  }

  using Own = std::function<void(Exchange&)>;  ///< what one kind of stage writes down beside the run
  void exchange_within(Exchange& e, const Own& own) {
    exchange(e);
    e("stage.result", outcome_);
    double seconds = std::chrono::duration<double>(Clock::now() - stage_start_).count();
    e("stage.wall_seconds", seconds);
    if (e.taking())
      stage_start_ = Clock::now() - std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
    e("stage.out_of_balance", out_of_balance_);
    e("stage.increment", increment_);
    e("stage.records", records_);
    e("stage.cracked_fraction", cracked_fraction_);
    own(e);
  }
  /// Where the present stage could go on from.
  void offer_checkpoint(const Own& own) {
    if (!observer_.wants_checkpoint()) return;
    const During checkpoints(clock_, Activity::checkpoints);
    Checkpoint checkpoint{stage_, true, {}, {}};
    Exchange e(checkpoint);
    exchange_within(e, own);
    observer_.checkpoint(checkpoint);
  }
  /// Takes the present stage, which has been set up, to where it stopped within, if it did.
  void go_on(const Own& own) {
    if (!restart_.within || restart_.within->stage != stage_) return;
    Exchange e(*restart_.within);
    exchange_within(e, own);
  }

  void run_stage() {
    stage_start_ = Clock::now();
    clock_.enter(Activity::set_up);
    const ActivityClock::Seconds activities_before = clock_.seconds();
    const std::vector<double> seconds_before = phase_seconds();
    outcome_ = {};
    out_of_balance_ = now_ = 0;
    outcome_.name = stage().name;
    outcome_.kind = kind_of(stage());
    observer_.stage_begins(stage_ + 1, stage().name, outcome_.kind);
    if (warm_) prescribe_temperature(problem_.model, stage_, temperature_);
    fill_with_grout(problem_, stage_);
    recorder_.motion({}, {});
    std::visit([this](const auto& how) { solve_stage(how); }, stage().solve);
    temperatures_at_end_[stage().name] = temperature_;
    const BlockWork before = std::exchange(block_work_, block_work(problem_));
    outcome_.plastic_work = block_work_.plastic - before.plastic;
    outcome_.fracture_work = block_work_.fracture - before.fracture;
    outcome_.dissipated_energy += outcome_.plastic_work + outcome_.fracture_work;

    lost_by_contacts_ = lost_by_contacts_ + outcome_.dissipated_by_contacts;
    recorder_.contact_dissipation(lost_by_contacts_);
    record({stage_, stage_ + 1.0, outcome_.load_factor, true, outcome_.seconds, 0, outcome_.balanced()});
    if (after_record_) std::exchange(after_record_, nullptr)();
    outcome_.wall_seconds = std::chrono::duration<double>(Clock::now() - stage_start_).count();
    const std::vector<double> seconds_after = phase_seconds();
    clock_.enter(Activity::set_up);
    for (int a = 0; a < static_cast<int>(Activity::count); ++a)
      if (const double seconds = clock_.seconds()[a] - activities_before[a]; seconds > 0)
        outcome_.activities.push_back({activity_name(static_cast<Activity>(a)), seconds});
    for (int p = 0; p < static_cast<int>(Phase::count) && !problem_.backend->runs_ahead(); ++p)
      if (seconds_after[p] > seconds_before[p])
        outcome_.phases.push_back({phase_name(static_cast<Phase>(p)), seconds_after[p] - seconds_before[p]});
    observer_.stage_ends(outcome_);
    result_.stages.push_back(outcome_);
    if (stage().reset_displacement) recorder_.reset_displacement();
  }

  std::vector<double> phase_seconds() const {
    std::vector<double> seconds;
    for (int p = 0; p < static_cast<int>(Phase::count); ++p)
      seconds.push_back(problem_.backend->seconds(static_cast<Phase>(p)) +
                        (problem_.heat_lane ? problem_.heat_lane->backend().seconds(static_cast<Phase>(p)) : 0));
    return seconds;
  }

  void record(const Moment& moment) {
    const During output(clock_, Activity::output);
    if (warm_) recorder_.temperature(temperature_);
    recorder_.history_rows(moment);
    if (moment.stage_end || wants_output(moment)) recorder_.snapshot(moment);
  }

  /// Outputs inside a stage: every n-th increment, time of a coupled stage, record of a motion.
  bool wants_output(const Moment& moment) const {
    if (std::holds_alternative<ThermalSolve>(stage().solve)) return false;
    const bool by_record = is_dynamic(stage()) || is_coupled(stage());
    const long number = by_record ? moment.record : std::lround(moment.load_factor * increments_);
    for (const Output& o : problem_.model.outputs)
      if (o.every > 0 && number > 0 && number % o.every == 0 && !moment.stage_end) return true;
    return false;
  }

  // ------------------------------------------------------------------ stress

  void set_body_temperature(const std::vector<double>& temperature) {
    body_temperature_ = temperature;
    write_temperature(problem_, *problem_.backend, temperature);
    problem_.backend->run(Phase::gauss_temperature);
    problem_.backend->use_warming(warming_used_ = true);
  }

  /// Temperature of the body in time for the stage, and what fracture stages have put on top.
  void warm_body() {
    if (!warm_) return;
    std::vector<double> seen = temperature_;
    for (std::size_t n = 0; n < seen.size(); ++n) seen[n] += shift_[n];
    set_body_temperature(seen);
  }

  /// Load, supports and given displacements of the stage; returns the loads other than weight, the machine's numbering.
  std::vector<double> set_conditions() {
    Backend& backend = *problem_.backend;
    const double time = stage_times(problem_.model)[stage_].begin + now_;
    MechanicalConditions conditions =
        mechanical_conditions(problem_, acting_conditions(problem_.model, stage_, time));
    backend.write(Field::load, problem_.to_machine(conditions.load, 3));
    backend.write(Field::fixed, problem_.to_machine(conditions.fixed, 1));
    if (backend.size(Field::crack_water) > 0) backend.write(Field::crack_water, conditions.crack_water);
    if (!conditions.prescribed.empty()) {
      std::vector<double> u = problem_.to_blocks(backend.read(Field::displacement), 3);
      for (std::size_t i = 0; i < conditions.prescribed.size(); ++i)
        u[conditions.prescribed[i]] = conditions.displacement[i];
      backend.write(Field::displacement, problem_.to_machine(u, 3));
    }
    if (!problem_.model.initial_stresses.empty() && !balance_told_) outcome_.initial = initial_balance(problem_);
    balance_told_ = true;
    std::vector<double> surface_load = problem_.to_machine(conditions.surface_load, 3);
    surface_load_ = conditions.surface_load;
    recorder_.surface_load(std::move(conditions.surface_load));
    return surface_load;
  }

  /// Sets the stage up; returns what Fracture wants to know.
  FractureLinks set_up(const Relaxation& relaxation) {
    FractureLinks links = links_for(relaxation);
    links.surface_load = set_conditions();
    return links;
  }
  FractureLinks links_for(const Relaxation& relaxation) {
    FractureLinks links;
    auto search = std::make_shared<ElasticStart>(problem_, *problem_.backend);
    auto mass = std::make_shared<VirtualMass>(problem_, *problem_.backend, relaxation);
    links.relax = [this, &relaxation, search, mass](const RelaxationWatch& watch) {
      const During set_up(clock_, Activity::set_up);
      mass->set();
      double start = 0;
      const RelaxationWatch look = [&](long step, double ratio) {
        if (start == 0) start = ratio;
        relaxed_ = relaxation_fraction(start, ratio, relaxation.tolerance);
        tell(step, ratio, relaxation.tolerance);
        const bool stop_wanted = watch && watch(step, ratio);
        return observer_.interrupted() || stop_wanted;
      };
      const double scale = force_scale();
      clock_.enter(Activity::search);
      const long iterations = relaxation.search && search->applies() ? search->run(relaxation, scale, look) : 0;
      clock_.enter(Activity::steps);
      Equilibrium e = relax(*problem_.backend, relaxation, scale, look);
      e.steps += iterations;
      result_.interrupted = result_.interrupted || (e.interrupted && observer_.interrupted());
      return e;
    };
    links.cracked = [this](const CrackEvent& event, double cracked_fraction) {
      cracked_fraction_ = cracked_fraction;
      observer_.crack(stage().name, event);
    };
    return links;
  }

  /// What forces of this stage are measured by beside loads and reactions: the load of the temperature, and a small
  /// share of what was out of balance before, which alone remains where a body comes to rest without load.
  double force_scale() {
    constexpr double share = 1e-3;
    evaluate_force(*problem_.backend);
    out_of_balance_ = std::max(out_of_balance_, problem_.backend->relaxation_sums().unbalanced);
    return std::max(thermal_load_, share * out_of_balance_);
  }

  void tell(long step, double ratio, double target) {
    const auto now = Clock::now();
    if (now - told_ < std::chrono::milliseconds(100)) return;
    told_ = now;
    Progress p;
    p.stage_number = stage_ + 1;
    p.stage_count = static_cast<int>(problem_.model.stages.size());
    p.stage = stage().name;
    p.kind = outcome_.kind;
    p.step = step;
    p.ratio = ratio;
    p.target = target;
    p.increment = increment_;
    p.increments = increments_;
    p.cracked_fraction = cracked_fraction_;
    p.fraction = increments_ > 0 ? (increment_ + relaxed_) / increments_ : relaxed_;
    observer_.progress(p);
  }

  /// Where a balance begins; loads, displacements and temperature go on from there in equal parts.
  struct Start {
    std::vector<double> load, surface_load, force, displacement, temperature, crack_water;
  };
  Start present() {
    Backend& backend = *problem_.backend;
    evaluate_force(backend);
    return {backend.read(Field::load),         surface_load_,     backend.read(Field::force),
            backend.read(Field::displacement), body_temperature_, backend.read(Field::crack_water)};
  }

  void solve_stage(const StaticSolve& how) {
    increment_ = 0;
    const int increments = static_increments(problem_, how);
    increments_ = increments > 1 ? increments : 0;
    const Start start = present();
    warm_body();
    FractureLinks links = set_up(how.relaxation);
    links.keep = [this](const Own& own) { offer_checkpoint(own); };
    links.increment_reached = [this](double factor, const Dissipation<double>& lost) {
      ++increment_;
      recorder_.contact_dissipation(lost_by_contacts_ + lost);
      if (factor < 1) record({stage_, stage_ + factor, factor, false});
    };
    balance(start, links, increments_, outcome_);
  }

  /// Equilibrium with the conditions and the temperature that have been set, in increments of the way from `start`; 0:
  /// at once.
  void balance(const Start& start, FractureLinks links, int increments, StageResult& result) {
    thermal_load_ = warm_ ? thermal_load_norm(*problem_.backend) : 0;
    if (increments > 0) go_from(start, links);
    Fracture fracture(problem_, links);
    if (links.keep) go_on([&](Exchange& e) { fracture.exchange(e); });
    const During events(clock_, Activity::events);
    if (increments > 0)
      fracture.advance(increments);
    else
      fracture.settle(1);
    fracture.fill(result);
  }

  /// What is out of balance when the stage begins comes in proportion to the load factor: loads that it adds, supports
  /// that it takes away; so do the displacements that it prescribes, and temperature.
  void go_from(const Start& start, FractureLinks& links) {
    Backend& backend = *problem_.backend;
    const Start end{backend.read(Field::load),         surface_load_,     {},
                    backend.read(Field::displacement), body_temperature_, backend.read(Field::crack_water)};
    const std::vector<double> fixed = backend.read(Field::fixed);
    links.set_load_factor = [this, &backend, start, end, fixed](double factor) {
      const auto between = [&](double a, double b) { return factor < 1 ? a + factor * (b - a) : b; };
      std::vector<double> load = end.load, displacement = backend.read(Field::displacement);
      for (std::size_t i = 0; i < load.size(); ++i) {
        const bool held = (static_cast<unsigned>(fixed[i / 3]) >> i % 3) & 1u;
        load[i] = between(held ? start.load[i] : start.force[i], load[i]);
        if (held) displacement[i] = between(start.displacement[i], end.displacement[i]);
      }
      backend.write(Field::load, load);
      backend.write(Field::displacement, displacement);
      std::vector<double> water = end.crack_water;
      for (std::size_t c = 0; c < water.size(); ++c) water[c] = between(start.crack_water[c], water[c]);
      backend.write(Field::crack_water, water);
      std::vector<double> surface_load = end.surface_load;
      for (std::size_t i = 0; i < surface_load.size(); ++i)
        surface_load[i] = between(start.surface_load.empty() ? 0 : start.surface_load[i], surface_load[i]);
      recorder_.surface_load(std::move(surface_load));
      if (start.temperature != end.temperature) {
        std::vector<double> temperature = end.temperature;
        for (std::size_t n = 0; n < temperature.size(); ++n)
          temperature[n] = between(start.temperature[n], temperature[n]);
        set_body_temperature(temperature);
      }
    };
  }

  void solve_stage(const FractureSolve& how) {
    increment_ = 0;
    increments_ = how.increments;
    const std::vector<double> base = body_temperature_;
    const std::vector<double> to = temperatures_at_end_.at(how.to);
    const std::vector<double> from = how.from.empty() ? base : temperatures_at_end_.at(how.from);
    const auto set_load_factor = [&](double factor) {
      std::vector<double> seen = base;
      for (std::size_t n = 0; n < seen.size(); ++n) {
        const double change = factor * (to[n] - from[n]);
        seen[n] += change;
        temperature_[n] = from[n] + change;
      }
      set_body_temperature(seen);
    };
    FractureLinks links = set_up(how.relaxation);
    set_load_factor(1);
    thermal_load_ = thermal_load_norm(*problem_.backend);
    set_load_factor(0);
    links.set_load_factor = set_load_factor;
    links.increment_reached = [&](double factor, const Dissipation<double>& lost) {
      ++increment_;
      recorder_.contact_dissipation(lost_by_contacts_ + lost);
      if (factor < 1) record({stage_, stage_ + factor, factor, false});
    };
    links.keep = [this](const Own& own) { offer_checkpoint(own); };
    Fracture fracture(problem_, links, how);
    go_on([&](Exchange& e) { fracture.exchange(e); });
    clock_.enter(Activity::events);
    outcome_.converged = (fracture.advancing() || fracture.settle(0)) && fracture.advance(how.increments);
    fracture.fill(outcome_);
    for (std::size_t n = 0; n < shift_.size(); ++n) shift_[n] = body_temperature_[n] - temperature_[n];
  }

  // ------------------------------------------------------------------ strength

  /// All that flow, slip and cracks change.
  using Body = std::map<Field, std::vector<double>>;
  Body body() {
    Body all;
    for (const Field field :
         {Field::displacement, Field::slip, Field::contact_state, Field::contact_damage, Field::history})
      all[field] = problem_.backend->read(field);
    return all;
  }
  void restore(const Body& all) {
    for (const auto& [field, values] : all) problem_.backend->write(field, values);
  }

  void solve_stage(const StrengthReduction& how) {
    increment_ = increments_ = 0;
    warm_body();
    Relaxation relaxation = how.relaxation;
    if (relaxation.max_steps == 0) relaxation.max_steps = usual_trial_steps;
    const FractureLinks links = set_up(relaxation);
    thermal_load_ = warm_ ? thermal_load_norm(*problem_.backend) : 0;
    const Body start = body();
    Body standing = start;
    long steps = 0;
    bool undecided = false;  // a body that single precision cannot balance neither stands nor falls
    const auto own = [&](Exchange& e) {
      e("trials.steps", steps);
      for (auto& [field, values] : standing) e("trials.standing", values);
    };
    const auto stands = [&](double factor) {
      restore(start);
      problem_.backend->weaken(factor);
      Fracture fracture(problem_, links);
      const bool found = fracture.settle(1);
      StageResult trial;
      fracture.fill(trial);
      steps += trial.steps;
      outcome_.ratio = trial.ratio;
      if (result_.interrupted) return false;
      if (found) standing = body();
      undecided = trial.stop_reason == "precision limit";
      if (undecided) return false;
      (found ? outcome_.safety_factor : outcome_.falling_factor) = factor;
      offer_checkpoint(own);
      return found;
    };
    go_on(own);
    clock_.enter(Activity::events);
    if (outcome_.safety_factor == 0 && !stands(how.low)) {
      outcome_.stop_reason = "falls at the lowest factor";
    } else if (outcome_.falling_factor == 0 && stands(how.high)) {
      outcome_.stop_reason = "stands at the highest factor";
    } else {
      while (outcome_.falling_factor - outcome_.safety_factor > how.width && !result_.interrupted && !undecided)
        stands((outcome_.safety_factor + outcome_.falling_factor) / 2);
      outcome_.converged = !result_.interrupted && !undecided;
      outcome_.stop_reason = "converged";
    }
    if (undecided) outcome_.stop_reason = "precision limit";
    if (result_.interrupted) outcome_.stop_reason = "interrupted";
    outcome_.steps = steps;
    problem_.backend->weaken(outcome_.safety_factor > 0 ? outcome_.safety_factor : 1);
    restore(standing);
    after_record_ = [this, start] {
      problem_.backend->weaken(1);
      restore(start);
      block_work_ = block_work(problem_);
    };
  }

  // ------------------------------------------------------------------ motion

  void solve_stage(const DynamicSolve& how) {
    increment_ = increments_ = 0;
    warm_body();
    set_conditions();
    const StageTimes times = stage_times(problem_.model)[stage_];
    const bool changing = loads_change(problem_.model, stage_);
    DynamicLinks links;
    links.watch = [this](long step, double fraction) {
      relaxed_ = fraction;
      tell(step, 0, 0);
      return observer_.interrupted();
    };
    links.record = [&](int number, double seconds, const std::vector<double>& velocity, const EnergyBalance& energy) {
      recorder_.motion(problem_.to_blocks(velocity, 3), energy);
      recorder_.contact_dissipation(lost_by_contacts_ + energy.contacts);
      if (changing) {
        const auto acting = acting_conditions(problem_.model, stage_, times.begin + seconds);
        recorder_.surface_load(mechanical_conditions(problem_, acting).surface_load);
      }
      record({stage_, stage_ + seconds / how.duration, 1, false, seconds, number});
    };
    links.cracked = [this](const CrackEvent& event) { observer_.crack(stage().name, event); };
    links.keep = [this](const Own& own) { offer_checkpoint(own); };
    links.go_on = [this](const Own& own) {
      go_on(own);
      clock_.enter(Activity::steps);
    };
    const bool moving = stage_ > 0 && is_dynamic(problem_.model.stages[stage_ - 1]);
    move_in_time(problem_, stage(), moving, links, outcome_);
    result_.interrupted = result_.interrupted || outcome_.stop_reason == "interrupted";
    recorder_.motion(problem_.to_blocks(problem_.backend->read(Field::velocity), 3), outcome_.energy);
    outcome_.dissipated_by_contacts = outcome_.energy.contacts;
  }

  // ------------------------------------------------------------------ heat

  /// Rows of histories on the way; the stage's end is recorded with every stage.
  void record_transient(const ThermalSolve& how, const ThermalProgress& progress) {
    const double interval = how.record_every > 0 ? how.record_every : how.duration / 100;
    const int due = static_cast<int>(progress.time / interval * (1 + 1e-12));
    if (due <= records_ || progress.fraction >= 1 || problem_.model.histories.empty()) return;
    records_ = due;
    temperature_ = read_temperature(problem_);
    record({stage_, stage_ + progress.fraction, progress.fraction, false, progress.time, records_});
  }

  void solve_stage(const ThermalSolve& how) {
    increment_ = records_ = 0;
    increments_ = how.steady ? 0 : 100;
    write_temperature(problem_, *problem_.backend, temperature_);
    long done = 0;
    const auto own = [&](Exchange& e) { e("march.steps", done); };
    const auto watch = [&](const ThermalProgress& progress) {
      relaxed_ = progress.fraction;
      if (!how.steady) {
        increment_ = static_cast<int>(100 * progress.fraction);
        relaxed_ = 0;
        outcome_.seconds = progress.time;
        record_transient(how, progress);
        done = progress.step;
        if (progress.fraction < 1) offer_checkpoint(own);
      }
      tell(progress.step, progress.ratio, how.steady ? how.tolerance : 0);
      return observer_.interrupted();
    };
    const ThermalResult r = solve_thermal(problem_, stage_, watch, [&] {
      if (!how.steady) go_on(own);
      clock_.enter(how.steady ? Activity::search : Activity::steps);
      return done;
    });
    temperature_ = read_temperature(problem_);
    result_.interrupted = result_.interrupted || r.interrupted;
    outcome_.converged = r.converged;
    outcome_.stop_reason = r.stop_reason;
    outcome_.steps = r.steps;
    outcome_.ratio = r.ratio;
  }

  // ------------------------------------------------------------------ both

  /// Temperature of the heat lane, which rests; the body has what fracture stages have put on top as well.
  void take_temperature() {
    Backend& backend = *problem_.backend;
    backend.take_temperature(problem_.heat_lane->backend());
    temperature_ = read_temperature(problem_);
    if (std::any_of(shift_.begin(), shift_.end(), [](double s) { return s != 0; })) return warm_body();
    body_temperature_ = temperature_;
    backend.run(Phase::gauss_temperature);
    backend.use_warming(warming_used_ = true);
  }

  /// Adds what one balance of a coupled stage found; load factors of it are shares of the way between two times.
  void add(const StageResult& part, double before) {
    const double duration = duration_of(stage());
    const auto seconds = [&](double factor) { return before + factor * (now_ - before); };
    outcome_.converged = part.converged;
    outcome_.stop_reason = part.stop_reason;
    outcome_.steps += part.steps;
    outcome_.ratio = part.ratio;
    outcome_.seconds = seconds(part.load_factor);
    outcome_.load_factor = outcome_.seconds / duration;
    outcome_.cracked_area = part.cracked_area;
    outcome_.cracked_area_by_direction = part.cracked_area_by_direction;
    outcome_.dissipated_energy += part.dissipated_energy;
    outcome_.dissipated_by_contacts = outcome_.dissipated_by_contacts + part.dissipated_by_contacts;
    recorder_.contact_dissipation(lost_by_contacts_ + outcome_.dissipated_by_contacts);
    const auto known = [this](int block) {
      return std::find(outcome_.free_blocks.begin(), outcome_.free_blocks.end(), block) != outcome_.free_blocks.end();
    };
    for (const LooseBlocks& body : part.loose)
      if (!known(body.blocks.front())) outcome_.loose.push_back(body);
    for (const int block : part.free_blocks)
      if (!known(block)) outcome_.free_blocks.push_back(block);
    for (const CrackEvent& event : part.events) outcome_.events.push_back(in_time(event, seconds(event.load_factor)));
  }
  CrackEvent in_time(CrackEvent event, double seconds) const {
    event.seconds = seconds;
    event.load_factor = seconds / duration_of(stage());
    return event;
  }

  void solve_stage(const CoupledSolve& how) {
    const std::vector<double> times = balance_times(how);
    increments_ = static_cast<int>(times.size());
    const bool loads = loads_change(problem_.model, stage_), contacts = problem_.contacts.count() > 0;
    const bool on_path = how.increments > 1 || problem_.backend->size(Field::history) > 0 ||
                         CrackEvents(problem_).can_crack();
    FractureLinks balancing = links_for(how.relaxation);
    Start start = present();
    warm_body();
    CoupledLinks links;
    links.take_over = [&] {
      if (on_path) start = present();
      take_temperature();
    };
    links.balance = [&](int number) {
      increment_ = number;
      now_ = times[number];
      out_of_balance_ = 0;
      const double before = number > 0 ? times[number - 1] : 0;
      // Bodies that float are held for one balance only.
      if (number == 0 || loads || contacts) balancing.surface_load = set_conditions();
      const int first = static_increments(problem_, {});
      balancing.cracked = [&](const CrackEvent& event, double cracked_fraction) {
        cracked_fraction_ = cracked_fraction;
        observer_.crack(stage().name, in_time(event, before + event.load_factor * (now_ - before)));
      };
      StageResult part;
      balance(start, balancing, number > 0 ? (on_path ? how.increments : 0) : (first > 1 ? first : 0), part);
      add(part, before);
      if (part.converged && now_ < how.duration)
        record({stage_, stage_ + outcome_.load_factor, outcome_.load_factor, false, now_, number});
      return part.converged;
    };
    links.interrupted = [this] { return observer_.interrupted(); };
    const auto with_start = [&](const Own& lanes) {
      return [&](Exchange& e) {
        for (auto* values : {&start.load, &start.surface_load, &start.force, &start.displacement, &start.temperature,
                             &start.crack_water})
          e("coupled.start", *values);
        lanes(e);
      };
    };
    links.keep = [&](const Own& lanes) { offer_checkpoint(with_start(lanes)); };
    links.go_on = [&](const Own& lanes) { go_on(with_start(lanes)); };
    clock_.enter(Activity::steps);  // what the lanes wait for each other is part of them
    outcome_.converged = march_coupled(problem_, stage_, temperature_, links, outcome_);
    result_.interrupted = result_.interrupted || outcome_.stop_reason == "interrupted";
  }

  Problem& problem_;
  Observer& observer_;
  const Restart& restart_;
  ActivityClock clock_;
  Recorder recorder_;
  bool warm_;
  RunResult result_;
  int stage_ = 0;
  StageResult outcome_;
  std::vector<double> temperature_;       ///< of the body in time, degC, mesh nodes
  std::vector<double> body_temperature_;  ///< that stress sees: changed by static and fracture stages only
  std::vector<double> surface_load_;      ///< N, the Blocks order, at the end of the present stage
  std::vector<double> shift_;  ///< body temperature less temperature: a fracture stage loads by a difference, and
                               ///< later stages go on from there
  std::map<std::string, std::vector<double>> temperatures_at_end_;
  double thermal_load_ = 0;
  std::function<void()> after_record_;  ///< what a stage undoes once its results are written
  Dissipation<double> lost_by_contacts_;  ///< J, up to the end of the last stage
  BlockWork block_work_;       ///< up to the end of the last stage
  double now_ = 0;             ///< s since the stage began, of the conditions that act
  double out_of_balance_ = 0;  ///< N, largest at the start of a relaxation of this balance
  int increment_ = 0, increments_ = 0;
  int records_ = 0;  ///< rows of a transient thermal stage
  bool balance_told_ = false;
  bool warming_used_ = false;
  double relaxed_ = 0, cracked_fraction_ = 0;
  Clock::time_point told_{}, stage_start_{};
};

}  // namespace

RunResult solve(Problem& problem, Observer& observer, const Restart& restart) {
  return Run(problem, observer, restart).run();
}

}  // namespace ashlar
