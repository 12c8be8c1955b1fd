#include "solve/grouting.hpp"

#include <set>

#include "solve/contact_states.hpp"

namespace ashlar {

void write_openings(Problem& problem) {
  if (!problem.contacts.opening.empty()) problem.backend->write(Field::initial_gap, problem.contacts.initial_gaps());
}

void fill_with_grout(Problem& problem, int stage) {
  std::set<std::string> filled;
  for (const ActingCondition& a : acting_conditions(problem.model, stage))
    if (const auto* grout = std::get_if<Grouting>(&a.condition->kind);
        grout && first_acts(problem.model, stage, *a.condition))
      filled.insert(grout->interfaces.begin(), grout->interfaces.end());
  if (filled.empty()) return;
  ContactPoints& contacts = problem.contacts;
  const std::vector<ContactPoint> points = ContactReader(problem).read();
  std::vector<double> slip = problem.backend->read(Field::slip);
  for (int c = 0; c < contacts.count(); ++c) {
    if (points[c].joined() || !filled.contains(problem.model.interfaces[contacts.interface[c]].name)) continue;
    contacts.opening[c] -= points[c].gap.normal + dot(contacts.initial_gap(c), contacts.normal[c]);
    for (int i = 0; i < 3; ++i) slip[3 * c + i] = points[c].slip[i];
  }
  problem.backend->write(Field::slip, slip);
  write_openings(problem);
}

}  // namespace ashlar
