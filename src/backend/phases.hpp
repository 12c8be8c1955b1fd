#pragma once
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>
#include <utility>

#include "backend/averaging.hpp"
#include "backend/backend.hpp"
#include "backend/balance_lane.hpp"
#include "backend/crack_lane.hpp"
#include "backend/heat_lane.hpp"
#include "backend/machine_memory.hpp"
#include "backend/motion_lane.hpp"
#include "backend/moving_contacts.hpp"
#include "backend/node_set.hpp"
#include "backend/parted_field.hpp"
#include "backend/path_lane.hpp"
#include "backend/springs.hpp"
#include "backend/summed_array.hpp"
#include "kernels/block_force.hpp"
#include "kernels/element_types.hpp"
#include "kernels/gather.hpp"
#include "kernels/move_nodes.hpp"
#include "kernels/relaxation_sums.hpp"
#include "kernels/spring_advance.hpp"
#include "kernels/spring_force.hpp"

/// Every phase once, for any machine. Exec brings memory and a parallel for:
///   template <class T> using Array: resize(n), upload(span), download(span), copy(array of this size), data()
///   void for_each(int n, kernel): kernel(i) for every i < n, in any order
///   block_forces(...): the machine's fastest driver of the element routine (see cpu_exec.hpp), same bits as BlockForce
///   + GatherPatch
namespace ashlar {

struct CopyNumber {
  const double* from;
  double* to;
  ASHLAR_HD void operator()(int i) const { to[i] = from[i]; }
};

template <class Exec, class Real>
class Phases final : public Backend {
 public:
  Phases(const Setup& setup, Exec exec)
      : exec_(std::move(exec)),
        discretisation_(setup.discretisation),
        full_laws_(setup.laws),
        laws_(setup.laws),
        bbar_(setup.bbar),
        first_history_(setup.first_history()),
        blocks_(setup.discretisation.blocks),
        springs_(setup),
        moving_contacts_(setup),
        heat_(setup) {
    const Discretisation& d = setup.discretisation;
    exec_.template set_patches<Real>(d);
    if (!setup.heat_only) make_body(setup);
    own_bytes_ = MachineMemory::bytes - own_bytes_;
    stage_bytes_ = stage_bytes(setup);
  }

  std::size_t memory_bytes() const override { return own_bytes_ + stage_bytes_; }
  std::string name() const override { return exec_.name() + (Summed<Real>::paired ? ", single precision" : ""); }
  double rounding() const override { return std::numeric_limits<Real>::epsilon(); }
  void use_warming(bool on) override { warm_ = on; }
  void weaken(double factor) override {
    laws_.clear();
    for (const BlockLaw& law : full_laws_) laws_.push_back(weakened(law, factor));
    springs_.weaken(factor);
    ++MachineMemory::changes;  // launches that a machine has recorded carry the laws
  }
  void use_large_displacement() override { large_ = true; }
  void write_candidates(const ContactCandidates& candidates, const std::vector<double>& displacement) override {
    moving_contacts_.write(candidates, displacement);
    motion_.clear_damping_force();
  }
  bool moved_far(double limit, double ahead) override { return moving_contacts_.moved_far(exec_, body_, limit, ahead); }
  bool runs_ahead() const override { return Exec::marches; }
  void finish() override { exec_.finish(); }
  double copy_bandwidth() override {
    using Clock = std::chrono::steady_clock;
    constexpr int numbers = 1 << 25, rounds = 10;
    Array<double> from, to;
    from.resize(numbers);
    to.resize(numbers);
    double best = 0;
    for (int round = 0; round < rounds; ++round) {
      exec_.finish();
      const auto start = Clock::now();
      exec_.for_each(numbers, CopyNumber{from.data(), to.data()});
      exec_.finish();
      best =
          std::max(best, 2.0 * numbers * sizeof(double) / std::chrono::duration<double>(Clock::now() - start).count());
    }
    return best;
  }

  void run_phase(Phase phase, const Controls& controls) override {
    switch (phase) {
      case Phase::block_force:
        if (large_) return each_turning([&](auto element, auto law, int b) { elastic_forces(element, law, b, body_); });
        average(body_);
        return each_batch([&](auto element, auto law, int b) { block_force(element, law, b); });
      case Phase::gather_force: return gather_boundary(body_.force);
      case Phase::move_nodes: set_damping(controls); return move_nodes();
      case Phase::relaxation_steps: return relaxation_steps(controls.steps);
      case Phase::stop_nodes: return exec_.for_each(node_count(), StopNode<Real>{body_});
      case Phase::keep_force: return exec_.for_each(node_count(), KeepForce<Real>{body_});
      case Phase::relaxation_sums: return sum_relaxation();
      case Phase::stiffness_bound: return stiffness_bound();
      case Phase::block_stress:
        if (large_)
          return each_turning([&](auto element, const auto& law, int b) { gauss_stress<false>(element, law, b); });
        average(body_);
        return each_batch([&](auto element, const auto& law, int b) { block_stress(element, law, b); });
      case Phase::spring_force: return spring_force();
      case Phase::advance_history:
        average_dilatation(body_);
        each_batch([&](auto element, const auto& law, int b) {
          if constexpr (std::decay_t<decltype(law)>::history_size > 0) gauss_stress<true>(element, law, b);
        });
        return find_memory();
      case Phase::spring_utilisation: return cracks_.find_worst(exec_, body_.u);
      case Phase::spring_crossing: return cracks_.find_crossing(exec_, u_before_.view(), path_.end());
      case Phase::break_springs: return cracks_.break_at(exec_, body_.u, controls.break_threshold);
      case Phase::keep_springs: return cracks_.keep(exec_, body_.u);
      case Phase::look_at_springs: return cracks_.look(exec_, body_.u);
      case Phase::heat_flow: return heat_.find_flow(exec_);
      case Phase::step_heat: return heat_.step(exec_, controls.time_step);
      case Phase::heat_steps: return heat_.march(exec_, controls.time_step, controls.steps);
      case Phase::heat_bound: return heat_.find_bound(exec_);
      case Phase::start_search: return heat_.start_search(exec_);
      case Phase::search_flow: return heat_.find_search_flow(exec_);
      case Phase::advance_search: return heat_.advance_search(exec_, controls.search_length);
      case Phase::turn_search: return heat_.turn_search(exec_, controls.search_keep);
      case Phase::balance_residual: return exec_.for_each(node_count(), BalanceResidual<Real>{balance_view()});
      case Phase::balance_precondition: return balance_.precondition(exec_, balance_view());
      case Phase::balance_turn:
        return exec_.for_each(3 * node_count(), BalanceTurn<Real>{balance_view(), Real(controls.search_keep)});
      case Phase::balance_product: return balance_product();
      case Phase::balance_advance:
        return exec_.for_each(3 * node_count(), BalanceAdvance<Real>{balance_view(), Real(controls.search_length)});
      case Phase::gauss_temperature: return heat_.warm_gauss_points(exec_, warming_.data());
      case Phase::start_motion: motion_.start(node_count(), contact_count()); return moving_contacts_.start();
      case Phase::advance_springs:
        cracks_.changed.known = false;
        return each_contact([&](auto springs, int first) {
          return AdvanceSprings<Real, decltype(springs)>{springs,
                                                         body_.u,
                                                         body_.v,
                                                         Real(controls.time_step),
                                                         springs_.slip.data() + 3 * first,
                                                         springs_.damage_from(first),
                                                         motion_.spring_dissipation.data() + 3 * first};
        });
      case Phase::damping_force: return damping_force(controls.stiffness_damping);
      case Phase::moving_contacts:
        return moving_contacts_.add_force(exec_, body_, controls.step_before, controls.contact_damping,
                                          controls.contact_damping > 0 ? motion_.damping_force(node_count()) : nullptr);
      case Phase::step_motion: return motion_.step(exec_, body_, controls);
      case Phase::combine_parts:
        return visit_field(*this, controls.combined, [&](auto& array) {
          if constexpr (std::is_same_v<std::decay_t<decltype(array)>, Array<Real>>)
            parts_[controls.combined].combine(exec_, controls.factors, array.data());
        });
      case Phase::count: break;
    }
    throw std::logic_error("not a phase");
  }

  void relax(const Controls& controls, int steps) override {
    if constexpr (Exec::marches) {
      set_damping(controls);
      run(Phase::relaxation_steps, {.steps = steps});
    } else {
      Backend::relax(controls, steps);
    }
  }
  void march_heat(const Controls& controls, int steps) override {
    if constexpr (Exec::marches)
      run(Phase::heat_steps, {.time_step = controls.time_step, .steps = steps});
    else
      Backend::march_heat(controls, steps);
  }

  RelaxationMeasure relaxation_sums() override {
    run(Phase::relaxation_sums, {});
    const auto& s = relaxation_sums_;
    return {std::sqrt(s[sum_unbalanced]),
            std::sqrt(s[sum_load]),
            std::sqrt(s[sum_reaction]),
            s[sum_kinetic],
            s[sum_load_work],
            s[sum_force_work],
            s[sum_curvature],
            s[sum_motion]};
  }

  double largest_utilisation() override {
    run(Phase::spring_utilisation);
    return cracks_.largest;
  }
  void keep_equilibrium(double advance) override { path_.keep(exec_, u_, springs_.slip, u_before_, advance); }
  void leave_equilibrium(double advance) override { path_.leave(exec_, u_, springs_.slip, u_before_, advance); }
  void keep_way_end() override { path_.keep_end(u_, springs_.slip); }
  void go_part_of_way(double fraction) override { path_.go_part(exec_, u_, springs_.slip, u_before_, fraction); }
  void go_to_way_end() override { path_.go_to_end(u_, springs_.slip); }
  double moved_since_equilibrium() override { return path_.largest_change(exec_, u_, u_before_); }
  double first_crossing() override {
    run(Phase::spring_crossing);
    return -cracks_.largest;
  }
  CrackMeasure break_springs(double most, double share) override {
    cracks_.largest = most;
    run(Phase::break_springs, {.break_threshold = share * most});
    return cracks_.cracked;
  }
  CrackMeasure keep_springs() override {
    run(Phase::keep_springs);
    return cracks_.cracked;
  }
  ChangedContacts take_changed_contacts() override { return std::exchange(cracks_.changed, {true}); }
  long loosened_springs() override {
    run(Phase::look_at_springs);
    return static_cast<long>(cracks_.largest);
  }

  void write_groups(const NodeGroups& groups) override {
    const std::size_t count = groups.pull.size(), nodes = groups.member.size();
    std::vector<int> of_node(nodes), first(nodes + 1, groups.first.back());  // room for as many groups as may come
    std::vector<Real> pull(nodes);
    for (std::size_t g = 0; g < count; ++g) {
      first[g] = groups.first[g];
      pull[g] = Real(groups.pull[g]);
      for (int j = groups.first[g]; j < groups.first[g + 1]; ++j) of_node[groups.member[j]] = static_cast<int>(g);
    }
    group_first_.assign(first);
    group_member_.assign(groups.member);
    group_pull_.assign(pull);
    group_of_node_.assign(of_node);
    if (group_shared_.size() != 3 * nodes) group_shared_.resize(3 * nodes);
    const GroupView<Real> before = groups_;
    groups_ = {.group_count = static_cast<int>(count),
               .first = group_first_.data(),
               .member = group_member_.data(),
               .pull = group_pull_.data(),
               .of_node = group_of_node_.data(),
               .shared = group_shared_.data()};
    if (before.group_count != groups_.group_count) regrouped();
  }
  void write_coarse(const CoarseBalance& coarse) override {
    balance_.write(coarse, discretisation_.block_points);
    no_slip_.resize(springs_.slip.size());
  }
  BalanceMeasure balance_sums() override { return balance_.sums(exec_, balance_view()); }
  double balance_along() override { return balance_.along(exec_, balance_view()); }
  HeatMeasure heat_sums() override { return heat_.sums(exec_); }
  MotionMeasure motion_sums(double step_before) override {
    if (!large_) return motion_.sums(exec_, body_, step_before);
    MotionMeasure m = motion_.turning_sums(exec_, body_, step_before);
    each_turning([&](auto element, const auto& law, int b) { m.potential += strain_energy(element, law, b); });
    moving_contacts_.add_energies(exec_, m);
    return m;
  }
  void write_films(const FilmMatrix& films) override { heat_.write_films(films); }
  void write_parts(Field field, const std::vector<std::vector<double>>& parts) override {
    parts_[field].write(parts);
    const std::size_t size = parts.empty() ? 0 : parts[0].size();
    if (field == Field::given_velocity) motion_.given_velocity.resize(size);
    if (field == Field::given_temperature) heat_.give_temperature(size);
  }

  std::size_t size(Field field) const override {
    return visit_field(*this, field, [](const auto& array) { return array.size(); });
  }
  void write(Field field, std::span<const double> values) override {
    std::vector<double> ordered;
    if (is_of_contacts(field)) values = ordered = springs_.in_machine_order(values);
    visit_field(*this, field, [&](auto& array) { copy_in(array, values); });
    written(field);
  }
  void read(Field field, std::span<double> values) override {
    visit_field(*this, field, [&](auto& array) { copy_out(array, values); });
    if (is_of_contacts(field)) springs_.to_model_order(values);
  }
  void take_temperature(Backend& from) override {
    if (auto* const same = dynamic_cast<Phases*>(&from))
      heat_.temperature.copy(same->heat_.temperature);
    else
      write(Field::temperature, from.Backend::read(Field::temperature));
    exec_.finish();
  }
  std::vector<double> save(Field field) const override {
    return visit_field(*this, field, [](const auto& array) {
      if constexpr (requires { array.save(); }) {
        return array.save();
      } else {
        std::vector<double> values(array.size());
        copy_out(array, values);
        return values;
      }
    });
  }
  void restore(Field field, std::span<const double> values) override {
    if (field == Field::displacement_rate) path_.rate.resize(values.empty() ? 0 : u_.size());
    moving_contacts_.make_room(field, values.size());
    visit_field(*this, field, [&](auto& array) {
      if constexpr (requires { array.save(); })
        array.restore(values);
      else
        copy_in(array, values);
    });
    written(field);
  }

 private:
  template <class T>
  using Array = typename Exec::template Array<T>;
  /// What depends on a field that has been written.
  void written(Field field) {
    if (field == Field::history) find_memory();
    if (field == Field::contact_state) cracks_.changed.known = false;
  }
  /// What the stress lane works on.
  void make_body(const Setup& setup) {
    const Discretisation& d = setup.discretisation;
    if constexpr (Exec::marches) exec_.set_clusters(springs_.clusters());
    const std::size_t nodes = d.blocks.node_count;
    x_.assign(places_in_patches<Real>(d.blocks, d.block_points));
    for (auto* a : {&v_, &load_, &force_, &kept_force_}) a->resize(3 * nodes);
    for (auto* a : {&u_, &u_before_}) a->resize(3 * nodes);
    inverse_mass_.resize(nodes);
    stiffness_.resize(nodes);
    fixed_.resize(nodes);
    corner_force_.resize(3 * std::size_t(d.slot_count));
    partial_.resize(3 * std::size_t(d.blocks.entry_count()));
    warming_.resize(d.gauss_count);
    stress_.resize(6 * std::size_t(d.gauss_count));
    int remembered = 0;
    for (const BlockLaw& law : laws_) remembered = std::max(remembered, history_size(law));
    history_.resize(remembered * std::size_t(first_history_.back()));
    remembers_.resize(first_history_.back());
    groups_.group_count = static_cast<int>(nodes);
    damping_.assign({last_damping_});
    body_ = {.nodes = blocks_.view(),
             .x = x_.data(),
             .u = u_.view(),
             .v = v_.data(),
             .load = load_.data(),
             .force = force_.data(),
             .kept_force = kept_force_.data(),
             .inverse_mass = inverse_mass_.data(),
             .fixed = fixed_.data(),
             .corner_force = corner_force_.data(),
             .partial = partial_.data(),
             .warming = warming_.data(),
             .stress = stress_.data(),
             .history = history_.data(),
             .history_stride = first_history_.back(),
             .remembers = remembers_.data(),
             .corner_gradient = nullptr,
             .averaged = nullptr};
    find_gradients();
    find_averages();
  }
  BalanceView<Real> balance_view() { return balance_.view(body_, groups_); }
  /// What stages add at most: groups, elastic search, motion, paths of loads.
  static std::size_t stage_bytes(const Setup& setup) {
    if (setup.heat_only) return 0;
    const std::size_t nodes = setup.discretisation.blocks.node_count, contacts = setup.contacts.count(),
                      vector = 3 * nodes * sizeof(Real);
    const std::size_t groups = contacts > 0 ? vector + nodes * (sizeof(Real) + 3 * sizeof(int)) + sizeof(int) : 0;
    const std::size_t search =
        3 * contacts * sizeof(Real) +
        BalanceLane<Exec, Real>::bytes(nodes, std::min(most_aggregates, setup.discretisation.patch_count()));
    const std::size_t motion = setup.motion ? vector + (2 * nodes + 3 * contacts) * sizeof(double) : 0;
    const auto any = [](const auto& all, auto what) { return std::any_of(all.begin(), all.end(), what); };
    const bool cracks = contacts > 0 && any(setup.interface_laws, [](const auto& law) { return law.breakable; });
    const bool bends = (contacts > 0 && any(setup.interface_laws, [](const auto& law) { return law.separates(); })) ||
                       any(setup.laws, [](const auto& law) { return history_size(law) > 0; });
    const std::size_t path =
        (bends + cracks) * (Summed<Real>::paired ? 2 : 1) * vector + (1 + cracks) * 3 * contacts * sizeof(Real);
    return groups + search + motion + path;
  }
  int node_count() const { return body_.nodes.node_count; }
  int contact_count() const { return springs_.pairs().contact_count + springs_.overlaps().contact_count; }

  /// Runs kernel_of(springs, their first contact point) on node pairs, then on the points of overlaps.
  template <class KernelOf>
  void each_contact(KernelOf kernel_of) {
    const int pairs = springs_.pairs().contact_count;
    exec_.for_each(pairs, kernel_of(springs_.pairs(), 0));
    if (pairs < contact_count())
      exec_.for_each(springs_.overlaps().contact_count, kernel_of(springs_.overlaps(), pairs));
  }

  void set_damping(const Controls& c) {
    const StepDamping<Real> damping{Real(c.local_damping), Real((2 - c.viscous_damping) / (2 + c.viscous_damping)),
                                    Real(2 / (2 + c.viscous_damping))};
    if (damping == last_damping_) return;
    damping_.upload({damping});
    last_damping_ = damping;
  }
  void move_nodes() {
    const MoveNode<Real> step{body_, damping_.data()};
    if (groups_.first) exec_.for_each(3 * groups_.group_count, PullGroup<Real>{groups_, step});
    exec_.for_each(node_count(), MoveNodes<Real>{groups_, step});
  }

  /// Launches that a machine has recorded carry how many groups they pull, where it has no clusters.
  void regrouped() {
    if constexpr (Exec::marches)
      if (!exec_.has_clusters()) ++MachineMemory::changes;
  }

  void sum_relaxation() {
    relaxation_sums_ =
        exec_.template combine<relaxation_sum_count>(groups_.group_count, RelaxationSums<Real>{body_, groups_});
  }

  /// Relaxation steps as the machine does them best: without springs every node moves as soon as its force is whole.
  void relaxation_steps(int steps) {
    if constexpr (Exec::marches) {
      const bool free = contact_count() == 0 && !groups_.first && every_batch_fits();
      if (free && march_blocks(steps)) return;
      exec_.repeat(std::string(free ? "free" : "jointed") + (warm_ ? ", warm" : ""), steps, [&] {
        if (free) {
          const MoveNode<Real> step{body_, damping_.data()};
          average(body_);
          each_batch([&](auto element, const auto& law, int b) { step_patches(element, law, b, step); });
          exec_.step_boundary(body_, discretisation_, step);
        } else {
          run_phase(Phase::block_force, {});
          run_phase(Phase::gather_force, {});
          step_jointed();
        }
      });
    }
  }
  /// Springs, then motion: cluster by cluster where the machine can, else one after the other.
  void step_jointed() {
    const MoveNode<Real> step{body_, damping_.data()};
    if (!exec_.has_clusters()) {
      spring_force();
      return move_nodes();
    }
    add_overlap_force(springs_.overlaps(), body_.u, body_.force);
    exec_.step_clusters(springs_.pairs(), groups_, step);
  }
  /// All steps at once, where every batch has the same element and a law of one kind without memory, elements look at
  /// themselves only, and the machine can.
  bool march_blocks(int steps) {
    if constexpr (Exec::marches) {
      const std::vector<Batch>& batches = discretisation_.batches;
      const auto alike = [&](const Batch& b) {
        return b.shape == batches[0].shape && bbar_[b.material] == bbar_[batches[0].material] &&
               laws_[b.material].index() == laws_[batches[0].material].index();
      };
      if (!std::all_of(batches.begin(), batches.end(), alike)) return false;
      std::vector<BatchView> views;
      for (int b = 0; b < static_cast<int>(batches.size()); ++b) views.push_back(batch_view(b));
      return std::visit(
          [&]<class Law>(const Law&) {
            using Point = decltype(std::declval<Law>().template prepare<Real>());
            bool marched = false;
            if constexpr (Point::history_size == 0) {
              std::vector<Point> points;
              for (const Batch& b : batches)
                points.push_back(std::get<Law>(laws_[b.material]).template prepare<Real>());
              with_element(batches[0].shape, bbar_[batches[0].material], [&]<template <class> class E>(ElementTag<E>) {
                if constexpr (!is_averaged<E>)
                  with_warmth<Point>([&]<bool Warm>() {
                    marched = exec_.template march_blocks<E, Warm>(body_, views, points, discretisation_,
                                                                   MoveNode<Real>{body_, damping_.data()}, steps);
                  });
              });
            }
            return marched;
          },
          laws_[batches[0].material]);
    }
    return false;
  }
  bool every_batch_fits() {
    bool fit = true;
    each_batch([&](auto element, const auto&, int b) { fit = fit && batch_fits(element, b); });
    return fit;
  }
  template <template <class> class E>
  bool batch_fits(ElementTag<E>, int b) const {
    return exec_.template fits<E, Real>(b);
  }
  template <template <class> class E, class Point>
  void step_patches(ElementTag<E>, const Point& law, int b, const MoveNode<Real>& step) {
    with_warmth<Point>(
        [&]<bool Warm>() { exec_.template step_blocks<E, Warm>(body_, batch_view(b), law, discretisation_, b, step); });
  }
  /// Whether there is temperature as a constant, for laws that have a form without.
  template <class Point, class Work>
  void with_warmth(const Work& work) const {
    if constexpr (!always_warm<Point>)
      if (!warm_) return work.template operator()<false>();
    work.template operator()<true>();
  }

  /// Calls work(element tag, prepared law, batch index) for every batch: the one place where shape and law become
  /// types.
  template <class Work>
  void each_batch(Work work) {
    for (int b = 0; b < static_cast<int>(discretisation_.batches.size()); ++b) {
      const Batch& batch = discretisation_.batches[b];
      std::visit(
          [&](const auto& law) {
            with_element(batch.shape, bbar_[batch.material],
                         [&](auto element) { work(element, law.template prepare<Real>(), b); });
          },
          laws_[batch.material]);
    }
  }
  /// The same in large displacement, where every law is elastic.
  template <class Work>
  void each_turning(Work work) {
    for (int b = 0; b < static_cast<int>(discretisation_.batches.size()); ++b) {
      const Batch& batch = discretisation_.batches[b];
      with_turning_element(batch.shape, [&](auto element) {
        work(element, std::get<Elastic>(laws_[batch.material]).template prepare<Real>(), b);
      });
    }
  }
  template <template <class> class E, class Point>
  double strain_energy(ElementTag<E>, const Point& law, int b) {
    const BatchView batch = batch_view(b);
    return exec_.template combine<1>(batch.element_count, ElementEnergy<E, Point, Real>{body_, batch, law})[0];
  }
  BatchView batch_view(int b) const {
    const Batch& batch = discretisation_.batches[b];
    return {batch.first_patch, batch.patch_size,  batch.element_count,      batch.first_slot,
            batch.first_gauss, first_history_[b], corner_count(batch.shape)};
  }

  template <template <class> class E, class Point>
  void block_force(ElementTag<E>, const Point& law, int b) {
    with_warmth<Point>(
        [&]<bool Warm>() { exec_.template block_forces<E, Warm>(body_, batch_view(b), law, discretisation_, b); });
  }
  template <bool moves_on, template <class> class E, class Point>
  void gauss_stress(ElementTag<E>, const Point& law, int b) {
    const BatchView batch = batch_view(b);
    exec_.for_each(batch.element_count, GaussStrain<E, Real>{body_, batch});
    exec_.for_each(batch.element_count * E<Real>::gauss_points, GaussStress<Point, Real, moves_on>{body_, batch, law});
  }
  template <template <class> class E, class Point>
  void block_stress(ElementTag<E> element, const Point& law, int b) {
    const BatchView batch = batch_view(b);
    if constexpr (is_averaged<E>)
      exec_.for_each(batch.element_count, BalancedStress<Real>{body_, batch});
    else
      gauss_stress<false>(element, law, b);
  }
  void find_memory() {
    each_batch([&]<template <class> class E, class Point>(ElementTag<E>, const Point&, int b) {
      if constexpr (Point::history_size > 0) {
        const BatchView batch = batch_view(b);
        exec_.for_each(batch.element_count,
                       FindMemory<Real>{body_, batch, E<Real>::gauss_points, Point::history_size, remembers_.data()});
      }
    });
  }
  /// Laws that are sized ask for them.
  void find_gradients() {
    each_batch([&]<template <class> class E>(ElementTag<E>, const auto& law, int b) {
      if constexpr (std::decay_t<decltype(law)>::sized) {
        if (!body_.corner_gradient) {
          corner_gradient_.resize(3 * std::size_t(discretisation_.slot_count));
          body_.corner_gradient = corner_gradient_.data();
        }
        if (!MachineMemory::within_limit()) return;
        const BatchView batch = batch_view(b);
        exec_.for_each(batch.element_count, CornerGradient<E, Real>{body_, batch});
      }
    });
  }
  void find_averages() {
    std::vector<int> averaged;
    each_averaged([&](auto, const auto&, int b) { averaged.push_back(b); });
    if (averaged.empty()) return;
    averaging_.assign(discretisation_, averaged);
    body_.averaged = averaging_.mean();
  }
  /// each_batch() of those whose elements take means over their neighbourhood.
  template <class Work>
  void each_averaged(Work work) {
    each_batch([&]<template <class> class E>(ElementTag<E> element, const auto& law, int b) {
      if constexpr (is_averaged<E>) work(element, law, b);
    });
  }
  void average_dilatation(const BodyView<Real>& body) {
    if (!averaging_.any()) return;
    each_averaged([&](auto, const auto&, int b) {
      const BatchView batch = batch_view(b);
      exec_.for_each(batch.element_count, OwnDilatation<Real>{body, batch});
    });
    averaging_.spread(exec_, [&](int b) { return batch_view(b); });
  }
  /// Before element forces: dilatation, stress by the law or the elastic part of it alone, its mean.
  void average(const BodyView<Real>& body) {
    average_with(body, [&]<template <class> class E, class Point>(ElementTag<E>, const Point& law, int b) {
      with_warmth<Point>([&]<bool Warm>() { averaged_stress<E, Warm>(body, law, b); });
    });
  }
  void average_elastic(const BodyView<Real>& body) {
    average_with(body, [&]<template <class> class E>(ElementTag<E>, const auto& law, int b) {
      averaged_stress<E, false>(body, law.elastic(), b);
    });
  }
  template <class StressOf>
  void average_with(const BodyView<Real>& body, const StressOf& stress_of) {
    if (!averaging_.any()) return;
    average_dilatation(body);
    each_averaged(stress_of);
    averaging_.spread(exec_, [&](int b) { return batch_view(b); });
  }
  template <template <class> class E, bool Warm, class Point>
  void averaged_stress(const BodyView<Real>& body, const Point& law, int b) {
    const BatchView batch = batch_view(b);
    exec_.for_each(batch.element_count, AveragedStress<E, Warm, Point, Real>{body, batch, law});
  }
  void gather_boundary(Real* sum) {
    exec_.for_each(discretisation_.blocks.boundary_count(), GatherBoundary<Real, 3>{body_.nodes, body_.partial, sum});
  }
  void spring_force() { add_spring_force(springs_.pairs(), springs_.overlaps(), body_.u, body_.force); }
  void add_spring_force(const SpringView<Real>& pairs, const OverlapView<Real>& overlaps, const Summed<Real>& u,
                        Real* force) {
    add_overlap_force(overlaps, u, force);
    exec_.for_each(pairs.contact_count, SpringForce<Real>{pairs, u});
    exec_.for_each(pairs.node_count, GatherSpring<Real>{pairs, force});
  }
  void add_overlap_force(const OverlapView<Real>& overlaps, const Summed<Real>& u, Real* force) {
    if (overlaps.contact_count == 0) return;
    exec_.for_each(overlaps.contact_count, SpringForce<Real, OverlapView<Real>>{overlaps, u});
    exec_.for_each(overlaps.node_count, GatherOverlap<Real>{overlaps, force});
  }
  /// The force routines on the search direction instead of the displacement.
  void balance_product() {
    const BalanceView<Real> view = balance_view();
    BodyView<Real> moved = body_;
    moved.u = {view.direction};
    moved.force = view.product;
    average_elastic(moved);
    each_batch([&](auto element, const auto& law, int b) { elastic_forces(element, law.elastic(), b, moved); });
    gather_boundary(view.product);
    SpringView<Real> pairs = springs_.pairs();
    OverlapView<Real> overlaps = springs_.overlaps();
    pairs.slip = overlaps.slip = no_slip_.data();
    pairs.initial_gap = overlaps.initial_gap = nullptr;
    pairs.damage = overlaps.damage = nullptr;  // bonded and linear
    pairs.water = overlaps.water = nullptr;
    add_spring_force(pairs, overlaps, moved.u, view.product);
  }
  void damping_force(double factor) {
    BodyView<Real> moved = body_;
    moved.u = {u_before_.view().high};
    moved.force = motion_.scale_velocity(exec_, body_, factor, moved.u.high);
    average_elastic(moved);
    each_batch([&](auto element, const auto& law, int b) { elastic_forces(element, law.elastic(), b, moved); });
    gather_boundary(moved.force);
  }
  template <template <class> class E, class Point>
  void elastic_forces(ElementTag<E>, const Point& law, int b, const BodyView<Real>& body) {
    exec_.template block_forces<E, false>(body, batch_view(b), law, discretisation_, b);
  }
  void stiffness_bound() {
    each_batch([&](auto element, const auto& law, int b) { bound_batch(element, law.elastic(), b); });
    exec_.for_each(body_.nodes.entry_count,
                   GatherPatch<Real, 3>{body_.nodes, body_.corner_force, body_.partial, body_.force});
    gather_boundary(body_.force);
    exec_.for_each(node_count(), LargestComponent<Real>{body_.force, stiffness_.data()});
  }
  template <template <class> class E, class Point>
  void bound_batch(ElementTag<E>, const Point& law, int b) {
    const BatchView batch = batch_view(b);
    exec_.for_each(batch.element_count, StiffnessBound<E, Point, Real>{body_, batch, law});
  }

  /// Machines keep contact points in an order of their own.
  static bool is_of_contacts(Field field) {
    return field == Field::slip || field == Field::contact_state || field == Field::initial_gap ||
           field == Field::crack_water || field == Field::contact_damage || field == Field::joined ||
           field == Field::spring_dissipation;
  }
  template <class Self, class Visit>
  static decltype(auto) visit_field(Self& self, Field field, Visit visit) {
    switch (field) {
      case Field::displacement: return visit(self.u_);
      case Field::velocity: return visit(self.v_);
      case Field::load: return visit(self.load_);
      case Field::force: return visit(self.force_);
      case Field::inverse_mass: return visit(self.inverse_mass_);
      case Field::stiffness: return visit(self.stiffness_);
      case Field::warming: return visit(self.warming_);
      case Field::stress: return visit(self.stress_);
      case Field::history: return visit(self.history_);
      case Field::fixed: return visit(self.fixed_);
      case Field::slip: return visit(self.springs_.slip);
      case Field::contact_state: return visit(self.springs_.state);
      case Field::initial_gap: return visit(self.springs_.initial_gap);
      case Field::crack_water: return visit(self.springs_.water);
      case Field::contact_damage: return visit(self.springs_.damage);
      case Field::joined: return visit(self.springs_.joined);
      case Field::displacement_before: return visit(self.u_before_);
      case Field::kept_slip: return visit(self.path_.kept_slip);
      case Field::displacement_rate: return visit(self.path_.rate);
      case Field::spring_dissipation: return visit(self.motion_.spring_dissipation);
      case Field::load_work: return visit(self.motion_.load_work);
      case Field::damping_work: return visit(self.motion_.damping_work);
      case Field::temperature: return visit(self.heat_.temperature);
      case Field::heat: return visit(self.heat_.heat);
      case Field::inverse_capacity: return visit(self.heat_.inverse_capacity);
      case Field::held: return visit(self.heat_.held);
      case Field::given_velocity: return visit(self.motion_.given_velocity);
      case Field::film: return visit(self.heat_.film_value);
      case Field::given_temperature: return visit(self.heat_.given_temperature);
      case Field::heat_flow: return visit(self.heat_.flow);
      case Field::heat_bound: return visit(self.heat_.bound);
      case Field::probe_memory: return visit(self.moving_contacts_.memory);
      case Field::probe_loss: return visit(self.moving_contacts_.lost);
    }
    throw std::logic_error("not a field");
  }
  static void copy_in(SummedArray<Exec, Real>& array, std::span<const double> values) { array.upload(values); }
  static void copy_out(const SummedArray<Exec, Real>& array, std::span<double> values) { array.download(values); }
  template <class T>
  static void copy_in(Array<T>& array, std::span<const double> values) {
    if (values.size() != array.size()) throw std::logic_error("field of the wrong size");
    std::vector<T> copy(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) copy[i] = T(values[i]);
    array.upload(copy);
  }
  template <class T>
  static void copy_out(const Array<T>& array, std::span<double> values) {
    std::vector<T> copy(array.size());
    array.download(copy);
    for (std::size_t i = 0; i < copy.size(); ++i) values[i] = double(copy[i]);
  }

  std::size_t own_bytes_ = MachineMemory::bytes, stage_bytes_ = 0;
  Exec exec_;
  const Discretisation& discretisation_;
  std::vector<BlockLaw> full_laws_, laws_;
  std::vector<char> bbar_;
  std::vector<int> first_history_;
  NodeSet<Exec> blocks_;
  Springs<Exec, Real> springs_;
  CrackLane<Exec, Real> cracks_{springs_};
  PathLane<Exec, Real> path_;
  MovingContacts<Exec, Real> moving_contacts_;
  BalanceLane<Exec, Real> balance_;
  Array<StepDamping<Real>> damping_;
  StepDamping<Real> last_damping_;
  Array<Real> no_slip_;
  HeatLane<Exec, Real> heat_;
  MotionLane<Exec, Real> motion_;
  Averaging<Exec, Real> averaging_;
  std::map<Field, PartedField<Exec, Real>> parts_;
  SummedArray<Exec, Real> u_, u_before_;
  Array<Real> x_, v_, load_, force_, kept_force_, inverse_mass_, stiffness_, corner_force_, partial_, warming_, stress_,
      history_, corner_gradient_;
  Array<std::uint8_t> fixed_, remembers_;
  std::array<double, relaxation_sum_count> relaxation_sums_{};
  BodyView<Real> body_;
  Array<int> group_first_, group_member_, group_of_node_;
  Array<Real> group_pull_, group_shared_;
  GroupView<Real> groups_;
  bool warm_ = false, large_ = false;
};

}  // namespace ashlar
