#include "solve/crack_events.hpp"

#include <algorithm>
#include <cmath>

namespace ashlar {

CrackEvents::CrackEvents(const Problem& problem) : problem_(problem) {
  const ContactReader contacts(problem);
  for (int c = 0; c < problem.contacts.count(); ++c) {
    const auto& law = contacts.law(c);
    breakable_ = breakable_ || law.breakable;
    softens_ = softens_ || law.softens();
    slides_ = slides_ || law.separates();
    strong_ += law.breakable || law.softens();
  }
}

double CrackEvents::largest_utilisation() { return breakable_ ? problem_.backend->largest_utilisation() : 0; }

CrackEvent CrackEvents::break_worst_group(double used, double share, double load_factor) {
  return event_of(problem_.backend->break_springs(used, share), load_factor);
}

std::optional<CrackEvent> CrackEvents::keep_history(double load_factor) {
  if (!slides_) return std::nullopt;
  const CrackMeasure softened = problem_.backend->keep_springs();
  if (softened.count > 0) return event_of(softened, load_factor);
  dissipated_ = dissipated_ + softened.lost;
  return std::nullopt;
}

CrackEvent CrackEvents::event_of(const CrackMeasure& cracked, double load_factor) {
  dissipated_ = dissipated_ + cracked.lost;
  if (cracked_) *cracked_ += cracked.count;
  CrackEvent event;
  event.load_factor = load_factor;
  event.contact_points = cracked.count;
  event.place = problem_.place_of_contact(cracked.worst);
  for (int i = 0; i < 3; ++i) event.place[i] += 0.0;  // meshes write -0
  event.interface = problem_.model.interfaces[problem_.contacts.interface[cracked.worst]].name;
  event.mode = cracked.mode == ContactState::cracked_in_tension ? "tension" : "shear";
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
  if (!cracked_) {
    const auto state = problem_.backend->read(Field::contact_state);
    cracked_ = std::count_if(state.begin(), state.end(), [](double s) {
      return is_cracked(static_cast<ContactState>(static_cast<int>(s)));
    });
  }
  return static_cast<double>(*cracked_) / static_cast<double>(strong_);
}

}  // namespace ashlar
