#include "solve/contact_states.hpp"

#include <algorithm>

#include "physics/interface_laws/interface_laws.hpp"

namespace ashlar {

ContactReader::ContactReader(const Problem& problem) : problem_(problem) {
  for (const Interface& i : problem.model.interfaces)
    laws_.push_back(interface_constants(i.law, i.values, i.where, "'" + i.name + "'").law);
}

std::vector<ContactPoint> ContactReader::read() const {
  const ContactPoints& c = problem_.contacts;
  const std::vector<int>& renumber = problem_.discretisation.blocks.new_node;
  Backend& backend = *problem_.backend;
  const auto u = backend.read(Field::displacement), slip = backend.read(Field::slip),
             state = backend.read(Field::contact_state), damage = backend.read(Field::contact_damage);
  std::vector<ContactPoint> points(c.count());
  for (int i = 0; i < c.count(); ++i) {
    ContactPoint& point = points[i];
    const auto& law = laws_[c.interface[i]];
    Vec3<double> gap;
    c.each_end(i, [&](int node, double weight) {
      const double* at = u.data() + 3 * renumber[node];
      gap = gap + weight * Vec3<double>{at[0], at[1], at[2]};
    });
    point.state = static_cast<ContactState>(static_cast<int>(state[i]));
    point.gap = split(gap, c.normal[i]);
    const auto stretch = split(gap + c.initial_gap(i), c.normal[i]);
    point.closed = stretch.normal <= 0;
    const SpringStiffness<double> stiffness{c.normal_stiffness[i], c.shear_stiffness[i]};
    const Vec3<double> slipped{slip[3 * i], slip[3 * i + 1], slip[3 * i + 2]};
    if (law.softens()) {
      const auto answer = softening_traction(c.strength.empty() ? law : law.with_strength(c.strength[i]), stiffness,
                                             stretch, slipped, damage[i], point.state);
      point.traction = answer.traction;
      point.slip = answer.slip;
      point.rubbing = answer.rubbing;
      point.damage = answer.damage;
      point.state = answer.state;
      point.bonded = answer.damage < 1;
      continue;
    }
    point.bonded = law.holds(point.state);
    const auto answer = spring_traction(point.bonded, law.tan_friction, stiffness, stretch, slipped);
    point.traction = answer.traction;
    point.rubbing = answer.traction.shear;
    point.slip = answer.slip;
    point.damage = is_cracked(point.state) ? 1 : 0;
  }
  return points;
}

std::vector<double> open_to_heat(const Problem& problem) {
  std::vector<double> open;
  if (std::none_of(problem.model.interfaces.begin(), problem.model.interfaces.end(),
                   [](const Interface& i) { return i.resists_heat(); }))
    return open;
  const ContactReader reader(problem);
  for (const ContactPoint& point : reader.read()) {
    const double broken = reader.law(static_cast<int>(open.size())).softens() ? point.damage : point.bonded ? 0 : 1;
    open.push_back(point.closed ? 0 : broken);
  }
  return open;
}

void fill_contact_fields(const std::vector<ContactPoint>& points, const std::vector<double>& opening,
                         Snapshot& snapshot) {
  snapshot.opening.clear();
  snapshot.slip.clear();
  snapshot.normal_traction.clear();
  snapshot.shear_traction.clear();
  snapshot.contact_state.clear();
  snapshot.contact_damage.clear();
  for (const auto& point : points) {
    snapshot.opening.push_back(point.gap.normal + (opening.empty() ? 0 : opening[snapshot.opening.size()]));
    snapshot.slip.push_back(norm(point.gap.shear));
    snapshot.normal_traction.push_back(point.traction.normal);
    snapshot.shear_traction.push_back(norm(point.traction.shear));
    snapshot.contact_state.push_back(static_cast<std::uint8_t>(point.state));
    snapshot.contact_damage.push_back(point.damage);
  }
}

}  // namespace ashlar
