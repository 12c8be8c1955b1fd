#include "solve/fracture.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "model/check_mesh.hpp"

namespace ashlar {

namespace {

constexpr double most_over_strength = 1.005;   // numerics 5
constexpr double aimed_over_strength = 1.001;  // where the search for the first crack aims: surely over, hardly over
constexpr double finest_advance = 1e-9;        // of the load factor: below this the path jumps
constexpr double runaway = 0.1;                // of the body's size: farther from the last equilibrium there is none
constexpr long support_interval = 1000;        // relaxation steps between two looks for bodies that float away

/// Diagonal of the box around points, m.
double size_of(const std::vector<Vec3<double>>& points) {
  Vec3<double> low = points[0], high = points[0];
  for (const auto& p : points)
    for (int i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], p[i]);
      high[i] = std::max(high[i], p[i]);
    }
  return norm(high - low);
}

}  // namespace

Fracture::Fracture(const Problem& problem, FractureLinks links, const FractureSolve& how)
    : problem_(problem),
      links_(std::move(links)),
      max_events_(how.max_events),
      event_group_(how.event_group),
      cracks_(problem),
      paths_(problem),
      plastic_(problem.backend->size(Field::history) > 0),
      size_(size_of(problem.discretisation.block_points)) {
  problem.backend->keep_equilibrium(0);
}

bool Fracture::stop(const std::string& reason) {
  stop_reason_ = reason;
  return false;
}

/// What depends on the path takes the present equilibrium as the one to go on from. False: that changed what may crack.
bool Fracture::move_on(double factor) {
  if (auto event = cracks_.keep_history(factor)) {
    events_.push_back(std::move(*event));
    if (links_.cracked) links_.cracked(events_.back(), cracks_.cracked_fraction());
  }
  if (paths_.any()) return !paths_.advance();
  if (plastic_) problem_.backend->run(Phase::advance_history);
  return true;
}

/// False: what may crack changed, see move_on().
bool Fracture::keep(double factor, bool smooth) {
  const bool settled = move_on(factor);
  // In a linear model the search finds the way; it needs no guess.
  const bool bends = plastic_ || cracks_.can_crack() || cracks_.can_separate();
  const double advance = bends && smooth && kept_ ? factor - kept_factor_ : 0;
  problem_.backend->keep_equilibrium(advance);
  rate_known_ = rate_known_ || advance > 0;
  kept_factor_ = factor;
  kept_ = true;
  return settled;
}

/// Bodies that nothing keeps in place now. Where no contact has come loose since none was found there are none.
std::vector<FreeBody> Fracture::find_free_bodies() {
  const long loosened = problem_.backend->loosened_springs();
  if (all_held_ && loosened == 0) return {};
  auto bodies = free_bodies(problem_);
  all_held_ = bodies.empty();
  return bodies;
}

/// Holds every body that nothing keeps in place where it is, free to deform, so that it takes no further part.
/// False: one of them carries a load other than its weight.
bool Fracture::hold_free_bodies() {
  const auto bodies = find_free_bodies();
  if (bodies.empty()) return true;
  Backend& backend = *problem_.backend;
  auto fixed = backend.read(Field::fixed), velocity = backend.read(Field::velocity);
  bool loaded = false;
  for (const auto& body : bodies) {
    free_blocks_.insert(free_blocks_.end(), body.blocks.begin(), body.blocks.end());
    loose_.push_back(describe(body.blocks));
    for (const int component : body.supports)
      fixed[component / 3] = static_cast<double>(static_cast<int>(fixed[component / 3]) | 1 << component % 3);
    for (const int n : body.nodes)
      for (int i = 0; i < 3; ++i) {
        velocity[3 * n + i] = 0;
        loaded = loaded || (!links_.surface_load.empty() && links_.surface_load[3 * n + i] != 0);
      }
  }
  std::sort(free_blocks_.begin(), free_blocks_.end());
  backend.write(Field::fixed, fixed);
  backend.write(Field::velocity, velocity);
  return loaded ? stop("block free") : true;
}

LooseBlocks Fracture::describe(const std::vector<int>& blocks) const {
  const Mesh& mesh = problem_.model.mesh;
  LooseBlocks loose{blocks, "", 0, {}};
  for (int e = 0; e < mesh.element_count(); ++e) {
    if (!std::binary_search(blocks.begin(), blocks.end(), problem_.blocks.block_of_element[e])) continue;
    if (loose.region.empty()) loose.region = mesh.region_names[mesh.regions[e]];
    const double volume = element_volume(mesh, e);
    loose.volume += volume;
    loose.centre = loose.centre + volume * mesh.centroid(e);
  }
  loose.centre = (1 / loose.volume) * loose.centre;
  return loose;
}

bool Fracture::relax() {
  std::size_t floating_before = 0;
  bool stopped = false;
  const auto watch = [&](long step, double) {
    if (step % support_interval != 0 || !(cracks_.can_separate() || plastic_)) return false;
    if (problem_.backend->moved_since_equilibrium() > runaway * size_) return stopped = !stop("moves without limit");
    if (!cracks_.can_separate()) return false;
    // A body that lost its hold may fall back on its neighbours: it floats away if nothing holds it at two looks in a
    // row.
    const auto floating = find_free_bodies().size();
    if (floating > 0 && floating_before > 0) {
      stopped = !hold_free_bodies();
      floating_before = 0;
    } else {
      floating_before = floating;
    }
    return stopped;
  };
  last_ = links_.relax(watch);
  steps_ += last_.steps;
  if (stopped) return false;
  if (!last_.converged) return stop(last_.stop_reason);
  return !cracks_.can_separate() || hold_free_bodies();
}

bool Fracture::settle(double load_factor) {
  if (!std::exchange(resumed_, false)) {
    place_.factor = load_factor;
    place_.events_before = events_.size();
    // Bodies that an earlier stage left floating stay where they are.
    if (steps_ == 0 && cracks_.can_separate() && !hold_free_bodies()) return false;
    if (!relax()) return false;
  }
  place_.settling = true;
  for (bool settled = false; !settled;) {
    offer_checkpoint();
    if (const double used = cracks_.largest_utilisation(); used >= 1) {
      if (static_cast<long>(events_.size()) >= max_events_) return stop("event limit");
      move_on(load_factor);
      events_.push_back(cracks_.break_worst_group(used, event_group_, load_factor));
      if (links_.cracked) links_.cracked(events_.back(), cracks_.cracked_fraction());
    } else {
      settled = keep(load_factor, events_.size() == place_.events_before);
    }
    if (!settled && !relax()) return false;
  }
  place_.settling = false;
  stop_reason_ = "converged";
  return true;
}

/// Equilibrium at `factor`, started on the straight line through the last equilibria between which nothing broke.
bool Fracture::reach(double factor) {
  problem_.backend->leave_equilibrium(rate_known_ ? factor - kept_factor_ : 0);
  links_.set_load_factor(factor);
  return relax();
}

/// From the equilibrium at load factor `high`, whose worst contact point uses `used` > 1 of its strength, back to one
/// where it uses 1 to 1.005 of it; moves the last equilibrium up where it proves to be below. Returns its load factor,
/// nothing if stopped.
std::optional<double> Fracture::reach_first_crack(double high, double used) {
  Backend& backend = *problem_.backend;
  backend.keep_way_end();
  while (used > most_over_strength) {
    const double width = high - kept_factor_;
    // Utilisation is convex along a straight way, so between the crossing and `high` it stays below its chord.
    const double crossing = std::clamp(backend.first_crossing(), 0.0, 1.0);
    const double fraction = crossing + (1 - crossing) * (aimed_over_strength - 1) / (used - 1);
    const bool path_jumps = width < finest_advance;
    const double factor = path_jumps ? high : kept_factor_ + fraction * width;
    if (path_jumps)
      backend.go_to_way_end();
    else
      backend.go_part_of_way(fraction);
    links_.set_load_factor(factor);
    if (!relax()) return std::nullopt;
    if (path_jumps) return factor;

    const double used_there = cracks_.largest_utilisation();
    if (used_there < 1) {
      keep(factor, true);
    } else {
      used = used_there;
      high = factor;
      backend.keep_way_end();
    }
  }
  return high;
}

bool Fracture::advance(int increments) {
  if (!resumed_) {
    place_.increment = 0;
    links_.set_load_factor(0);
  }
  if (place_.increment == 0 || place_.settling)
    if (!settle(place_.increment == 0 ? 0 : place_.factor)) return false;
  resumed_ = false;
  for (int i = std::max(1, place_.increment); i <= increments; ++i) {
    place_.increment = i;
    const double target = static_cast<double>(i) / increments;
    while (kept_factor_ < target) {
      offer_checkpoint();
      if (!reach(target)) return false;
      const double used = cracks_.largest_utilisation();
      if (used < 1) {
        if (!keep(target, true) && !settle(target)) return false;
        break;
      }
      const auto factor = reach_first_crack(target, used);
      if (!factor || !settle(*factor)) return false;
    }
    if (links_.increment_reached) links_.increment_reached(target, cracks_.dissipated());
  }
  return true;
}

void Fracture::offer_checkpoint() {
  if (links_.keep) links_.keep([this](Exchange& e) { exchange(e); });
}

void Fracture::exchange(Exchange& e) {
  e("place.increment", place_.increment);
  e("place.settling", place_.settling);
  e("place.factor", place_.factor);
  e("place.events_before", place_.events_before);
  e("kept.factor", kept_factor_);
  e("kept", kept_);
  e("rate_known", rate_known_);
  for (const auto& [field, name] : {std::pair{Field::displacement_before, "displacement_before"},
                                    std::pair{Field::kept_slip, "kept_slip"},
                                    std::pair{Field::displacement_rate, "displacement_rate"}})
    exchange_field(e, name, *problem_.backend, field);
  e("events", events_);
  e("free_blocks", free_blocks_);
  e("loose", loose_);
  e("last.converged", last_.converged);
  e("last.ratio", last_.ratio);
  e("search_steps", steps_);
  e("stop_reason", stop_reason_);
  cracks_.exchange(e);
  resumed_ = e.taking();
}

void Fracture::fill(StageResult& result) {
  result.converged = stop_reason_ == "converged";
  result.stop_reason = stop_reason_;
  result.steps = steps_;
  result.ratio = last_.ratio;
  result.load_factor = kept_factor_;
  result.events = events_;
  result.free_blocks = free_blocks_;
  result.loose = loose_;
  cracks_.fill(result);
}

}  // namespace ashlar
