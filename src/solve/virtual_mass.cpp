#include "solve/virtual_mass.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "solve/relaxation.hpp"

namespace ashlar {

namespace {

constexpr double mass_split =
    4;  // t of the two masses: heavier against each other, where modes are stiff and fast anyway

class Components {
 public:
  explicit Components(int n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0); }
  int root(int i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(int a, int b) {
    a = root(a);
    b = root(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<int> parent_;
};

}  // namespace

void set_virtual_mass(const Problem& problem, Backend& backend, const Relaxation& relaxation) {
  backend.run(Phase::stiffness_bound);
  const std::vector<double> blocks = backend.read(Field::stiffness);
  const int nodes = static_cast<int>(blocks.size());
  const double factor = 1.05 * (1 + local_damping(relaxation)) / 4 / (relaxation.step_factor * relaxation.step_factor);
  std::vector<double> inverse_mass(nodes);
  const ContactPoints& contacts = problem.contacts;
  if (contacts.count() == 0) {
    for (int n = 0; n < nodes; ++n) inverse_mass[n] = 1 / (factor * blocks[n]);
    backend.write(Field::inverse_mass, inverse_mass);
    return;
  }

  const std::vector<SpringLaw<double>> laws = problem.setup().interface_laws;
  const std::vector<double> state = backend.read(Field::contact_state);
  const std::vector<int>& renumber = problem.discretisation.blocks.new_node;
  Components components(nodes);
  const bool grouped = relaxation.damping != Damping::local;
  for (int c = 0; grouped && c < contacts.pair_count(); ++c)
    if (laws[contacts.interface[c]].holds(static_cast<ContactState>(state[c])))
      components.join(renumber[contacts.node_a[c]], renumber[contacts.node_b[c]]);

  std::vector<double> springs(nodes), between(nodes);  // S of all springs, and of those to other groups
  for (int c = 0; c < contacts.pair_count(); ++c) {
    const int a = renumber[contacts.node_a[c]], b = renumber[contacts.node_b[c]];
    if (a == b) continue;  // the tip of a joint: no relative displacement
    const double s = 2 * contacts.area[c] * std::max(contacts.normal_stiffness[c], contacts.shear_stiffness[c]);
    for (const int n : {a, b}) {
      springs[n] += s;
      if (components.root(a) != components.root(b)) between[n] += s;
    }
  }

  // The row sum of a spring between many nodes is its stiffness times a node's weight times the sum of all weights, 2.
  for (int c = contacts.pair_count(); c < contacts.count(); ++c) {
    const double s = 2 * contacts.area[c] * std::max(contacts.normal_stiffness[c], contacts.shear_stiffness[c]);
    contacts.each_end(c, [&](int node, double weight) {
      springs[renumber[node]] += s * std::abs(weight);
      between[renumber[node]] += s * std::abs(weight);
    });
  }

  std::vector<std::vector<int>> members(nodes);
  for (int n = 0; n < nodes; ++n) members[components.root(n)].push_back(n);
  NodeGroups groups;
  for (const auto& group : members) {
    if (group.empty()) continue;
    double mean = 0, against = 0;
    for (const int n : group) {
      const double mass =
          group.size() == 1 ? factor * (blocks[n] + springs[n]) : (1 + mass_split) * factor * (blocks[n] + springs[n]);
      inverse_mass[n] = 1 / mass;
      against += mass;
      mean += (1 + 1 / mass_split) * factor * (blocks[n] + between[n]);
    }
    groups.pull.push_back(group.size() == 1 ? 0 : 1 / mean - 1 / against);
    groups.member.insert(groups.member.end(), group.begin(), group.end());
    groups.first.push_back(static_cast<int>(groups.member.size()));
  }
  backend.write(Field::inverse_mass, inverse_mass);
  backend.write_groups(groups);
}

}  // namespace ashlar
