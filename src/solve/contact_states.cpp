#include "solve/contact_states.hpp"

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
             state = backend.read(Field::contact_state);
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
    point.bonded = law.holds(point.state);
    point.gap = split(gap, c.normal[i]);
    const auto stretch = split(gap + c.initial_gap(i), c.normal[i]);
    point.closed = stretch.normal <= 0;
    const auto answer = spring_traction(point.bonded, law.tan_friction,
                                        SpringStiffness<double>{c.normal_stiffness[i], c.shear_stiffness[i]}, stretch,
                                        Vec3<double>{slip[3 * i], slip[3 * i + 1], slip[3 * i + 2]});
    point.traction = answer.traction;
    point.slip = answer.slip;
  }
  return points;
}

void fill_contact_fields(const std::vector<ContactPoint>& points, Snapshot& snapshot) {
  snapshot.opening.clear();
  snapshot.slip.clear();
  snapshot.normal_traction.clear();
  snapshot.shear_traction.clear();
  snapshot.contact_state.clear();
  for (const auto& point : points) {
    snapshot.opening.push_back(point.gap.normal);
    snapshot.slip.push_back(norm(point.gap.shear));
    snapshot.normal_traction.push_back(point.traction.normal);
    snapshot.shear_traction.push_back(norm(point.traction.shear));
    snapshot.contact_state.push_back(static_cast<std::uint8_t>(point.state));
  }
}

}  // namespace ashlar
