#include "solve/crack_events.hpp"

#include <algorithm>
#include <cmath>

namespace ashlar {

CrackEvents::CrackEvents(const Problem& problem) : problem_(problem), contacts_(problem) {
  for (int c = 0; c < problem.contacts.count(); ++c) {
    breakable_ = breakable_ || contacts_.law(c).breakable;
    softens_ = softens_ || contacts_.law(c).softens();
    slides_ = slides_ || contacts_.law(c).separates();
  }
}

double CrackEvents::largest_utilisation() {
  if (!breakable_) return 0;
  problem_.backend->run(Phase::spring_utilisation);
  const auto used = problem_.backend->read(Field::utilisation);
  return *std::max_element(used.begin(), used.end());
}

CrackEvent CrackEvents::break_worst_group(double load_factor) {
  const ContactPoints& contacts = problem_.contacts;
  problem_.backend->run(Phase::spring_utilisation);
  const auto used = problem_.backend->read(Field::utilisation);
  const auto worst = static_cast<int>(std::max_element(used.begin(), used.end()) - used.begin());
  const auto before = contacts_.read();

  Controls controls;
  controls.break_threshold = worst_group_share * used[worst];
  problem_.backend->run(Phase::break_springs, controls);
  const auto state = problem_.backend->read(Field::contact_state);

  CrackEvent event = event_of(worst, static_cast<ContactState>(static_cast<int>(state[worst])), load_factor);
  for (int c = 0; c < contacts.count(); ++c) {
    if (static_cast<int>(state[c]) == static_cast<int>(before[c].state)) continue;
    ++event.contact_points;
    // What is left of the spring's energy once it has slid to its friction limit at this gap; the friction work on that
    // way is booked as slip.
    const double tension = std::max(before[c].traction.normal, 0.0);
    const double friction = std::max(-before[c].traction.normal, 0.0) * contacts_.law(c).tan_friction;
    const double dropped = std::max(norm(before[c].traction.shear) - friction, 0.0);
    dissipated_.opening += 0.5 * contacts.area[c] * tension * tension / contacts.normal_stiffness[c];
    dissipated_.shear += 0.5 * contacts.area[c] * dropped * dropped / contacts.shear_stiffness[c];
  }
  return event;
}

std::optional<CrackEvent> CrackEvents::keep_history(double load_factor) {
  if (!slides_) return std::nullopt;
  const auto points = contacts_.read();
  const auto slip_before = problem_.backend->read(Field::slip),
             state_before = problem_.backend->read(Field::contact_state);
  std::vector<double> slip(slip_before.size()), state(points.size()), damage(softens_ ? points.size() : 0);
  std::optional<CrackEvent> event;
  for (std::size_t c = 0; c < points.size(); ++c) {
    const double area = problem_.contacts.area[c];
    Vec3<double> slid;
    for (int i = 0; i < 3; ++i) {
      slip[3 * c + i] = points[c].slip[i];
      slid[i] = slip[3 * c + i] - slip_before[3 * c + i];
    }
    state[c] = static_cast<double>(points[c].state);
    if (softens_) damage[c] = points[c].damage;
    if (!contacts_.law(static_cast<int>(c)).softens()) {
      dissipated_.friction += area * dot(points[c].traction.shear, slid);
      continue;
    }
    dissipated_ = dissipated_ + area * points[c].lost;
    if (!is_cracked(points[c].state) || is_cracked(static_cast<ContactState>(static_cast<int>(state_before[c]))))
      continue;
    if (!event) event = event_of(static_cast<int>(c), points[c].state, load_factor);
    ++event->contact_points;
  }
  problem_.backend->write(Field::slip, slip);
  if (softens_) {
    problem_.backend->write(Field::contact_state, state);
    problem_.backend->write(Field::contact_damage, damage);
  }
  return event;
}

CrackEvent CrackEvents::event_of(int worst, ContactState state, double load_factor) const {
  CrackEvent event;
  event.load_factor = load_factor;
  event.place = problem_.place_of_contact(worst);
  for (int i = 0; i < 3; ++i) event.place[i] += 0.0;  // meshes write -0
  event.interface = problem_.model.interfaces[problem_.contacts.interface[worst]].name;
  event.mode = state == ContactState::cracked_in_tension ? "tension" : "shear";
  return event;
}

const char* crack_direction(const Vec3<double>& normal) {
  const double cos30 = std::sqrt(3.0) / 2, up = std::abs(normal.z) / norm(normal);
  return up >= cos30 ? "horizontal" : up <= 0.5 ? "vertical" : "inclined";
}

void CrackEvents::fill(StageResult& result) const {
  result.dissipated_energy = dissipated_.sum();
  result.dissipated_by_contacts = dissipated_;
  fill_areas(result);
}

void CrackEvents::fill_areas(StageResult& result) const {
  result.cracked_area = 0;
  result.cracked_area_by_direction = {{"horizontal", 0.0}, {"vertical", 0.0}, {"inclined", 0.0}};
  if (!can_crack()) return;
  const auto state = problem_.backend->read(Field::contact_state);
  for (int c = 0; c < problem_.contacts.count(); ++c) {
    if (!is_cracked(static_cast<ContactState>(static_cast<int>(state[c])))) continue;
    result.cracked_area += problem_.contacts.area[c];
    result.cracked_area_by_direction[crack_direction(problem_.contacts.normal[c])] += problem_.contacts.area[c];
  }
}

double CrackEvents::cracked_fraction() {
  if (!can_crack()) return 0;
  const auto state = problem_.backend->read(Field::contact_state);
  long cracked = 0, strong = 0;
  for (int c = 0; c < problem_.contacts.count(); ++c) {
    strong += contacts_.law(c).breakable || contacts_.law(c).softens();
    cracked += is_cracked(static_cast<ContactState>(static_cast<int>(state[c])));
  }
  return static_cast<double>(cracked) / static_cast<double>(strong);
}

}  // namespace ashlar
