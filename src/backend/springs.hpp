#pragma once
#include <cstdint>
#include <numeric>
#include <vector>

#include "backend/backend.hpp"
#include "backend/clusters.hpp"
#include "kernels/spring_view.hpp"

namespace ashlar {

/// Which contact points touch which block nodes, contact points ascending.
struct ContactsOfNodes {
  std::vector<int> node, first{0}, contact;
  std::vector<double> weight;

  explicit ContactsOfNodes(int nodes) : contacts_(nodes) {}
  void add(int block_node, int entry, double entry_weight = 0) {
    contacts_[block_node].push_back({entry, entry_weight});
  }
  void finish() {
    for (int n = 0; n < static_cast<int>(contacts_.size()); ++n) {
      if (contacts_[n].empty()) continue;
      node.push_back(n);
      for (const Entry& e : contacts_[n]) {
        contact.push_back(e.contact);
        weight.push_back(e.weight);
      }
      first.push_back(static_cast<int>(contact.size()));
    }
    contacts_ = {};
  }

 private:
  struct Entry {
    int contact;
    double weight;
  };
  std::vector<std::vector<Entry>> contacts_;
};

/// Springs in a machine's memory, block nodes renumbered. Arrays hold node pairs first, cluster by cluster, then the
/// points of overlaps.
template <class Exec, class Real>
class Springs {
 public:
  explicit Springs(const Setup& setup) : clusters_(clusters_of(setup)), points_(setup.contacts.count()) {
    const ContactPoints& c = setup.contacts;
    const std::vector<int>& renumber = setup.discretisation.blocks.new_node;
    const int n = c.count(), pairs = c.pair_count();
    std::vector<Real> normal(3 * n);
    for (int i = 0; i < n; ++i)
      for (int k = 0; k < 3; ++k) normal[3 * i + k] = Real(c.normal[i][k]);
    std::vector<SpringLaw<Real>> laws;
    for (const auto& law : setup.interface_laws) laws.push_back(law.template as<Real>());
    normal_.assign(in_machine_order<Real>(normal));
    initial_gap.assign(in_machine_order<Real>(c.initial_gaps()));
    area_.assign(in_machine_order<Real>(real(c.area)));
    normal_stiffness_.assign(in_machine_order<Real>(real(c.normal_stiffness)));
    shear_stiffness_.assign(in_machine_order<Real>(real(c.shear_stiffness)));
    interface_.assign(in_machine_order<int>(c.interface));
    laws_.assign(laws);
    full_laws_ = setup.interface_laws;
    state.resize(n);
    slip.resize(3 * n);
    strength_.assign(in_machine_order<Real>(real(c.strength)));
    bool softens = false;
    for (const auto& law : setup.interface_laws) softens = softens || law.softens();
    damage.resize(softens ? n : 0);
    water.resize(setup.crack_water ? n : 0);
    force_.resize(3 * n);
    std::vector<int> number(n);
    std::iota(number.begin(), number.end(), 0);
    number_.assign(in_machine_order<int>(number));
    joined.resize(n);

    const int nodes = setup.discretisation.blocks.node_count;
    std::vector<int> a(pairs), b(pairs);
    ContactsOfNodes of_pairs(nodes);
    for (int i = 0; i < pairs; ++i) {
      a[i] = clusters_.node_a[clusters_.pair[i]];
      b[i] = clusters_.node_b[clusters_.pair[i]];
      of_pairs.add(a[i], i);
      of_pairs.add(b[i], -1 - i);
    }
    of_pairs.finish();
    node_a_.assign(a);
    node_b_.assign(b);
    node_.assign(of_pairs.node);
    node_first_.assign(of_pairs.first);
    node_contact_.assign(of_pairs.contact);
    pairs_ = {.contact_count = pairs,
              .node_count = static_cast<int>(of_pairs.node.size()),
              .node_a = node_a_.data(),
              .node_b = node_b_.data(),
              .normal = normal_.data(),
              .area = area_.data(),
              .normal_stiffness = normal_stiffness_.data(),
              .shear_stiffness = shear_stiffness_.data(),
              .initial_gap = c.has_initial_gap() ? initial_gap.data() : nullptr,
              .strength = c.strength.empty() ? nullptr : strength_.data(),
              .interface = interface_.data(),
              .laws = laws_.data(),
              .state = state.data(),
              .slip = slip.data(),
              .damage = softens ? damage.data() : nullptr,
              .water = setup.crack_water ? water.data() : nullptr,
              .force = force_.data(),
              .node = node_.data(),
              .node_first = node_first_.data(),
              .node_contact = node_contact_.data()};
    if (pairs < n) set_overlaps(c, renumber, nodes);
  }
  const SpringView<Real>& pairs() const { return pairs_; }
  const OverlapView<Real>& overlaps() const { return overlaps_; }
  const Clusters& clusters() const { return clusters_; }
  /// Values of contact points, any number each, from the model's order.
  template <class T, class Values>
  std::vector<T> in_machine_order(const Values& values) const {
    std::vector<T> ordered(values.begin(), values.end());
    each_moved(values.size(), [&](std::size_t in_model, std::size_t here) { ordered[here] = values[in_model]; });
    return ordered;
  }
  std::vector<double> in_machine_order(std::span<const double> values) const {
    return in_machine_order<double, std::span<const double>>(values);
  }
  void to_model_order(std::span<double> values) const {
    const std::vector<double> here(values.begin(), values.end());
    each_moved(values.size(), [&](std::size_t in_model, std::size_t at) { values[in_model] = here[at]; });
  }
  /// [contact points] their numbers in the model.
  const int* number() { return number_.data(); }
  /// Damage of contact points from the first one on; null: nothing softens.
  Real* damage_from(int first) { return damage.size() > 0 ? damage.data() + first : nullptr; }
  void weaken(double factor) {
    std::vector<SpringLaw<Real>> laws;
    for (const auto& law : full_laws_) laws.push_back(law.weakened(factor).template as<Real>());
    laws_.upload(laws);
  }

 private:
  template <class T>
  using Array = typename Exec::template Array<T>;
  static Clusters clusters_of(const Setup& setup) {
    const std::vector<int>& renumber = setup.discretisation.blocks.new_node;
    std::vector<int> a, b;
    for (const int n : setup.contacts.node_a) a.push_back(renumber[n]);
    for (const int n : setup.contacts.node_b) b.push_back(renumber[n]);
    return {setup.discretisation.blocks.node_count, std::move(a), std::move(b)};
  }
  template <class Work>
  void each_moved(std::size_t size, const Work& work) const {
    const std::size_t each = points_ > 0 ? size / points_ : 0;  // numbers of a point
    for (std::size_t i = 0; i < clusters_.pair.size(); ++i)
      for (std::size_t k = 0; k < each; ++k) work(each * clusters_.pair[i] + k, each * i + k);
  }
  static std::vector<Real> real(const std::vector<double>& values) { return {values.begin(), values.end()}; }

  void set_overlaps(const ContactPoints& c, const std::vector<int>& renumber, int nodes) {
    const int pairs = c.pair_count();
    std::vector<int> end_node;
    for (const int n : c.end_node) end_node.push_back(renumber[n]);
    ContactsOfNodes of_overlaps(nodes);
    for (int i = 0; i < c.count() - pairs; ++i)
      for (int j = c.first_end[i]; j < c.first_end[i + 1]; ++j) of_overlaps.add(end_node[j], i, c.end_weight[j]);
    of_overlaps.finish();
    first_end_.assign(c.first_end);
    end_node_.assign(end_node);
    end_weight_.assign(real(c.end_weight));
    overlap_node_.assign(of_overlaps.node);
    overlap_first_.assign(of_overlaps.first);
    overlap_contact_.assign(of_overlaps.contact);
    overlap_weight_.assign(real(of_overlaps.weight));

    static_cast<SpringView<Real>&>(overlaps_) = pairs_;
    overlaps_.contact_count = c.count() - pairs;
    overlaps_.node_a = overlaps_.node_b = nullptr;
    overlaps_.normal += 3 * pairs;
    overlaps_.area += pairs;
    overlaps_.normal_stiffness += pairs;
    overlaps_.shear_stiffness += pairs;
    if (overlaps_.initial_gap) overlaps_.initial_gap += 3 * pairs;
    if (overlaps_.strength) overlaps_.strength += pairs;
    overlaps_.interface += pairs;
    overlaps_.state += pairs;
    overlaps_.slip += 3 * pairs;
    if (overlaps_.damage) overlaps_.damage += pairs;
    if (overlaps_.water) overlaps_.water += pairs;
    overlaps_.force += 3 * pairs;
    overlaps_.node_count = static_cast<int>(of_overlaps.node.size());
    overlaps_.node = overlap_node_.data();
    overlaps_.node_first = overlap_first_.data();
    overlaps_.node_contact = overlap_contact_.data();
    overlaps_.node_weight = overlap_weight_.data();
    overlaps_.first_end = first_end_.data();
    overlaps_.end_node = end_node_.data();
    overlaps_.end_weight = end_weight_.data();
  }

  Clusters clusters_;
  int points_;
  Array<int> node_a_, node_b_, number_, interface_, node_, node_first_, node_contact_;
  Array<int> first_end_, end_node_, overlap_node_, overlap_first_, overlap_contact_;
  Array<Real> normal_, area_, normal_stiffness_, shear_stiffness_, force_;
  Array<Real> end_weight_, overlap_weight_, strength_;
  Array<SpringLaw<Real>> laws_;
  std::vector<SpringLaw<double>> full_laws_;
  SpringView<Real> pairs_;
  OverlapView<Real> overlaps_;

 public:
  Array<ContactState> state;
  Array<Real> slip, damage, initial_gap, water;
  Array<std::uint8_t> joined;
};

}  // namespace ashlar
