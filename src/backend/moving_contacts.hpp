#pragma once
#include <algorithm>
#include <array>
#include <map>
#include <vector>

#include "backend/backend.hpp"
#include "kernels/moving_contact.hpp"
#include "kernels/sum.hpp"

namespace ashlar {

/// Contacts of large displacement in a machine's memory: the surface from the start, candidates of the last search.
template <class Exec, class Real>
class MovingContacts {
 public:
  explicit MovingContacts(const Setup& setup) {
    if (!setup.surface || setup.surface->empty()) return;
    const ContactSurface& s = *setup.surface;
    std::vector<MovingLaw<Real>> laws;
    for (const ContactLaw& law : s.laws)
      laws.push_back({Real(law.normal_stiffness), Real(law.shear_stiffness), Real(law.friction)});
    std::vector<Real> x;
    for (const Vec3<double>& p : setup.discretisation.block_points)
      x.insert(x.end(), {Real(p.x), Real(p.y), Real(p.z)});
    const auto probes = static_cast<std::size_t>(s.probe_count());
    x_.assign(x);
    probe_node_.assign(s.probe_node);
    rim_first_.assign(s.first_rim);
    rim_.assign(s.rim);
    may_dip_.assign(std::vector<Real>(s.may_dip.begin(), s.may_dip.end()));
    corner_.assign(corners_ = s.corner);
    edge_.assign(edges_ = s.edge);
    edge_ends_.assign(s.edge_ends);
    long_edge_ = s.long_edge;
    laws_.assign(laws);
    first_pair_ = s.probe_count();
    lost.resize(probes);
    memory.assign(numbers_of(std::vector<ProbeMemory<Real>>(probes)));
    reach_ = Real(s.skin);
  }

  void start() { lost.resize(lost.size()); }
  /// Fields with as many entries as pairs at the search that they come from.
  void make_room(Field field, std::size_t size) {
    if (field == Field::probe_memory && memory.size() != size) memory.resize(size);
    if (field == Field::probe_loss && lost.size() != size) lost.resize(size);
  }
  void write(const ContactCandidates& c, const std::vector<double>& displacement) {
    struct Entry {
      int probe, candidate, corner;
    };
    std::vector<std::vector<Entry>> of_node(displacement.size() / 3);
    const int corners = first_pair_, probes = static_cast<int>(c.first.size()) - 1;
    for (int p = 0; p < probes; ++p)
      for (int j = c.first[p]; j < c.first[p + 1]; ++j) {
        const int targets = p < corners ? 3 : contact_nodes;  // the other one is the probe's own, whatever it is at
        int at[contact_nodes];
        if (p < corners)
          nodes_of_contact(c.own[j], &corners_[3 * c.target[j]], at);
        else
          nodes_of_crossing(&edges_[4 * c.own[j]], &edges_[4 * c.target[j]], at);
        for (int k = 0; k < contact_nodes; ++k)
          if (k < targets || j == c.first[p]) of_node[at[k]].push_back({p, k < targets ? j : -1, k});
      }
    std::vector<int> node, first{0}, probe, candidate, corner;
    for (int n = 0; n < static_cast<int>(of_node.size()); ++n) {
      if (of_node[n].empty()) continue;
      node.push_back(n);
      for (const Entry& e : of_node[n]) {
        probe.push_back(e.probe);
        candidate.push_back(e.candidate);
        corner.push_back(e.corner);
      }
      first.push_back(static_cast<int>(probe.size()));
    }
    keep_memory(c.pairs);
    active_.resize(probes);
    weight_.resize(static_cast<std::size_t>(contact_nodes) * probes);
    for (auto* vectors : {&force_, &resisting_}) vectors->resize(3 * static_cast<std::size_t>(probes));
    stored_.resize(probes);
    first_.assign(c.first);
    own_.assign(c.own);
    target_.assign(c.target);
    law_.assign(c.law);
    area_.assign(std::vector<Real>(c.area.begin(), c.area.end()));
    node_.assign(node);
    node_first_.assign(first);
    entry_probe_.assign(probe);
    entry_candidate_.assign(candidate);
    entry_corner_.assign(corner);
    view_ = {.probe_count = probes,
             .node_count = static_cast<int>(node.size()),
             .first_pair = corners,
             .x = x_.data(),
             .rim_first = rim_first_.data(),
             .rim = rim_.data(),
             .may_dip = may_dip_.data(),
             .corner = corner_.data(),
             .edge = edge_.data(),
             .edge_ends = edge_ends_.data(),
             .laws = laws_.data(),
             .first = first_.data(),
             .own = own_.data(),
             .target = target_.data(),
             .law = law_.data(),
             .area = area_.data(),
             .reach = reach_,
             .memory = reinterpret_cast<ProbeMemory<Real>*>(memory.data()),
             .active = active_.data(),
             .weight = weight_.data(),
             .force = force_.data(),
             .resisting = resisting_.data(),
             .stored = stored_.data(),
             .lost = lost.data(),
             .node = node_.data(),
             .node_first = node_first_.data(),
             .entry_probe = entry_probe_.data(),
             .entry_candidate = entry_candidate_.data(),
             .entry_corner = entry_corner_.data()};
    searched_.assign(std::vector<Real>(displacement.begin(), displacement.end()));
  }
  /// @param resisting [3 * nodes] N; null: nothing is damped
  void add_force(Exec& exec, const BodyView<Real>& body, double step, double damping, Real* resisting) {
    exec.for_each(view_.probe_count, MoveContact<Real>{view_, body.u, body.v, Real(step), Real(damping)});
    exec.for_each(view_.node_count, GatherMovingContact<Real>{view_, body.force, resisting});
  }
  void add_energies(Exec& exec, MotionMeasure& m) {
    if (view_.probe_count == 0) return;
    const auto s = exec.template combine<moving_contact_sum_count>(view_.probe_count, MovingContactSums<Real>{view_});
    m.potential += s[moving_stored];
    m.rubbed = s[moving_lost];
  }
  bool moved_far(Exec& exec, const BodyView<Real>& body, double limit, double ahead) {
    if (view_.probe_count == 0) return false;
    return exec.template combine<1>(first_pair_, MovedFar<Real>{probe_node_.data(), body.u, searched_.data(), body.v,
                                                                Real(ahead), Real(limit)})[0] > 0;
  }

 private:
  template <class T>
  using Array = typename Exec::template Array<T>;
  using Memory = ProbeMemory<Real>;
  static_assert(sizeof(Memory) == probe_numbers * sizeof(Real));

  static std::vector<Real> numbers_of(const std::vector<Memory>& of) {
    const Real* const first = reinterpret_cast<const Real*>(of.data());
    return {first, first + probe_numbers * of.size()};
  }
  /// Pairs of long edges that the last search found, too, go on as they were; what others stored or lost is booked with
  /// the first probe.
  void keep_memory(const std::vector<std::array<int, 2>>& pairs) {
    std::vector<Real> numbers(memory.size());
    memory.download(numbers);
    std::vector<Memory> before(numbers.size() / probe_numbers);
    std::copy(numbers.begin(), numbers.end(), reinterpret_cast<Real*>(before.data()));
    std::vector<double> losses(lost.size()), energy(stored_.size());
    lost.download(losses);
    stored_.download(energy);
    std::map<std::array<int, 2>, std::size_t> at;
    for (std::size_t i = first_pair_; i < before.size(); ++i)
      if (before[i].target >= 0) at[{long_edge_[int(before[i].own)], long_edge_[int(before[i].target)]}] = i;
    const auto corners = static_cast<std::size_t>(first_pair_), count = corners + pairs.size();
    std::vector<Memory> now(before.begin(), before.begin() + first_pair_);
    now.resize(count);
    std::vector<double> lost_now(losses.begin(), losses.begin() + first_pair_);
    lost_now.resize(count);
    for (std::size_t i = corners; i < count; ++i) {
      if (now[0].target != Memory{}.target) now[i].target = -1;
      const auto found = at.find(pairs[i - corners]);
      if (found == at.end()) continue;
      const std::size_t old = found->second;
      now[i] = before[old];
      if (old < energy.size()) energy[old] = 0;
    }
    for (std::size_t i = corners; i < losses.size(); ++i) lost_now[0] += losses[i];
    for (std::size_t i = corners; i < energy.size(); ++i) lost_now[0] += energy[i];
    memory.assign(numbers_of(now));
    lost.assign(lost_now);
  }

  std::vector<int> corners_, edges_, long_edge_;
  int first_pair_ = 0;
  Array<int> probe_node_, rim_first_, rim_, corner_, edge_, edge_ends_, active_, first_, own_, target_, law_, node_,
      node_first_, entry_probe_, entry_candidate_, entry_corner_;
  Array<Real> x_, may_dip_, area_, weight_, force_, resisting_, searched_;
  Array<MovingLaw<Real>> laws_;
  Array<double> stored_;
  Real reach_ = 0;
  MovingContactView<Real> view_;

 public:
  Array<Real> memory;  ///< [numbers * probes]
  Array<double> lost;  ///< [probes] J
};

}  // namespace ashlar
