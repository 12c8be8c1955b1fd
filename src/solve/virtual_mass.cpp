#include "solve/virtual_mass.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "solve/relaxation.hpp"

namespace ashlar {

namespace {

constexpr double mass_split =
    4;  // t of the two masses: heavier against each other, where modes are stiff and fast anyway

}  // namespace

VirtualMass::VirtualMass(const Problem& problem, Backend& backend, const Relaxation& relaxation)
    : problem_(problem),
      backend_(backend),
      factor_(1.05 * (1 + local_damping(relaxation)) / 4 / (relaxation.step_factor * relaxation.step_factor)),
      grouped_(relaxation.damping != Damping::local) {
  backend.run(Phase::stiffness_bound);
  blocks_ = backend.read(Field::stiffness);
  const ContactPoints& contacts = problem.contacts;
  if (contacts.count() == 0) return;
  const std::vector<int>& renumber = problem.discretisation.blocks.new_node;
  const auto stiffness = [&](int c) {
    return 2 * contacts.area[c] * std::max(contacts.normal_stiffness[c], contacts.shear_stiffness[c]);
  };
  springs_.resize(blocks_.size());
  of_overlaps_.resize(blocks_.size());
  first_pair_.resize(blocks_.size() + 1);
  for (int c = 0; c < contacts.pair_count(); ++c) {
    a_.push_back(renumber[contacts.node_a[c]]);
    b_.push_back(renumber[contacts.node_b[c]]);
    stiffness_.push_back(stiffness(c));
    if (a_[c] == b_[c]) continue;  // the tip of a joint: no relative displacement
    for (const int n : {a_[c], b_[c]}) {
      springs_[n] += stiffness_[c];
      ++first_pair_[n + 1];
    }
  }
  std::partial_sum(first_pair_.begin(), first_pair_.end(), first_pair_.begin());
  pair_.resize(first_pair_.back());
  std::vector<int> next = first_pair_;
  for (int c = 0; c < contacts.pair_count(); ++c)
    if (a_[c] != b_[c])
      for (const int n : {a_[c], b_[c]}) pair_[next[n]++] = c;

  // The row sum of a spring between many nodes is its stiffness times a node's weight times the sum of all weights, 2.
  for (int c = contacts.pair_count(); c < contacts.count(); ++c)
    contacts.each_end(c, [&](int node, double weight) {
      springs_[renumber[node]] += stiffness(c) * std::abs(weight);
      of_overlaps_[renumber[node]] += stiffness(c) * std::abs(weight);
    });
}

void VirtualMass::set() {
  if (problem_.contacts.count() == 0) {
    std::vector<double> inverse_mass(blocks_.size());
    for (std::size_t n = 0; n < blocks_.size(); ++n) inverse_mass[n] = 1 / (factor_ * blocks_[n]);
    return backend_.write(Field::inverse_mass, inverse_mass);
  }
  const ChangedContacts changed = backend_.take_changed_contacts();
  if (set_before_ && changed.known)
    part(changed.points);
  else
    join_all();
  set_before_ = true;
  write();
}

int VirtualMass::root(int node) {
  while (group_[node] != node) node = group_[node] = group_[group_[node]];
  return node;
}

void VirtualMass::join(int contact) {
  const int a = root(a_[contact]), b = root(b_[contact]);
  group_[std::max(a, b)] = std::min(a, b);
}

void VirtualMass::find_between(int node) {
  double sum = 0;
  for (int i = first_pair_[node]; i < first_pair_[node + 1]; ++i)
    if (group_[a_[pair_[i]]] != group_[b_[pair_[i]]]) sum += stiffness_[pair_[i]];
  between_[node] = sum + of_overlaps_[node];
}

void VirtualMass::join_all() {
  const std::vector<SpringLaw<double>> laws = problem_.setup().interface_laws;
  const std::vector<double> state = backend_.read(Field::contact_state);
  const int nodes = static_cast<int>(blocks_.size()), pairs = static_cast<int>(a_.size());
  bonded_.assign(pairs, 0);
  group_.resize(nodes);
  std::iota(group_.begin(), group_.end(), 0);
  for (int c = 0; grouped_ && c < pairs; ++c) {
    bonded_[c] = laws[problem_.contacts.interface[c]].holds(static_cast<ContactState>(static_cast<int>(state[c])));
    if (bonded_[c]) join(c);
  }
  std::vector<int> last(nodes, -1);
  next_.assign(nodes, -1);
  between_.resize(nodes);
  for (int n = 0; n < nodes; ++n) {
    group_[n] = root(n);
    if (const int before = std::exchange(last[group_[n]], n); before >= 0) next_[before] = n;
  }
  for (int n = 0; n < nodes; ++n) find_between(n);
}

/// Takes the groups apart that lost a bond.
void VirtualMass::part(const std::vector<int>& cracked) {
  std::vector<int> nodes;
  for (const int c : cracked) {
    if (c >= static_cast<int>(a_.size()) || !std::exchange(bonded_[c], 0)) continue;
    for (int n = group_[a_[c]]; n >= 0; n = next_[n]) nodes.push_back(n);
  }
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  for (const int n : nodes) {
    group_[n] = n;
    next_[n] = -1;
  }
  for (const int n : nodes)
    for (int i = first_pair_[n]; i < first_pair_[n + 1]; ++i)
      if (bonded_[pair_[i]]) join(pair_[i]);
  for (const int n : nodes) group_[n] = root(n);
  for (auto n = nodes.rbegin(); n != nodes.rend(); ++n)  // the lowest comes last: every node goes behind its lowest
    if (group_[*n] != *n) next_[*n] = std::exchange(next_[group_[*n]], *n);
  for (const int n : nodes) find_between(n);
}

void VirtualMass::write() {
  const int nodes = static_cast<int>(blocks_.size());
  std::vector<double> inverse_mass(nodes);
  NodeGroups groups;
  groups.member.reserve(nodes);
  for (int lowest = 0; lowest < nodes; ++lowest) {
    if (group_[lowest] != lowest) continue;
    const bool single = next_[lowest] < 0;
    double mean = 0, against = 0;
    for (int n = lowest; n >= 0; n = next_[n]) {
      const double mass = (single ? 1 : 1 + mass_split) * factor_ * (blocks_[n] + springs_[n]);
      inverse_mass[n] = 1 / mass;
      against += mass;
      mean += (1 + 1 / mass_split) * factor_ * (blocks_[n] + between_[n]);
      groups.member.push_back(n);
    }
    groups.pull.push_back(single ? 0 : 1 / mean - 1 / against);
    groups.first.push_back(static_cast<int>(groups.member.size()));
  }
  backend_.write(Field::inverse_mass, inverse_mass);
  backend_.write_groups(groups);
}

}  // namespace ashlar
