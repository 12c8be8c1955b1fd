#pragma once
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
      laws.push_back({Real(law.normal_stiffness / 2), Real(law.shear_stiffness / 2), Real(law.friction)});
    std::vector<Real> x;
    for (const Vec3<double>& p : setup.discretisation.block_points)
      x.insert(x.end(), {Real(p.x), Real(p.y), Real(p.z)});
    const auto probes = static_cast<std::size_t>(s.probe_count() + s.edge_count());
    std::vector<Real> fresh(probe_numbers * probes);
    for (std::size_t p = 0; p < probes; ++p) fresh[probe_numbers * p] = ProbeMemory<Real>{}.target;
    x_.assign(x);
    probe_node_.assign(probes_ = s.probe_node);
    corner_.assign(corners_ = s.corner);
    edge_.assign(edges_ = s.edge);
    edge_goes_on_.assign(s.edge_goes_on);
    laws_.assign(laws);
    active_.resize(probes);
    weight_.resize(contact_nodes * probes);
    for (auto* vectors : {&force_, &resisting_}) vectors->resize(3 * probes);
    stored_.resize(probes);
    lost.resize(probes);
    memory.assign(fresh);
    reach_ = Real(s.skin);
  }

  void start() { lost.resize(lost.size()); }
  void write(const ContactCandidates& c, const std::vector<double>& displacement) {
    struct Entry {
      int probe, candidate, corner;
    };
    std::vector<std::vector<Entry>> of_node(displacement.size() / 3);
    const int corners = static_cast<int>(probes_.size()), probes = static_cast<int>(c.first.size()) - 1;
    for (int p = 0; p < probes; ++p)
      for (int j = c.first[p]; j < c.first[p + 1]; ++j) {
        const int targets = p < corners ? 3 : 2;  // the others are the probe's own
        int at[contact_nodes];
        if (p < corners)
          nodes_of_contact(probes_[p], &corners_[3 * c.target[j]], at);
        else
          nodes_of_crossing(&edges_[4 * (p - corners)], &edges_[4 * c.target[j]], at);
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
    first_.assign(c.first);
    target_.assign(c.target);
    law_.assign(c.law);
    area_.assign(std::vector<Real>(c.area.begin(), c.area.end()));
    node_.assign(node);
    node_first_.assign(first);
    entry_probe_.assign(probe);
    entry_candidate_.assign(candidate);
    entry_corner_.assign(corner);
    static_assert(sizeof(ProbeMemory<Real>) == probe_numbers * sizeof(Real));
    view_ = {.probe_count = probes,
             .node_count = static_cast<int>(node.size()),
             .first_edge = corners,
             .x = x_.data(),
             .probe_node = probe_node_.data(),
             .corner = corner_.data(),
             .edge = edge_.data(),
             .edge_goes_on = edge_goes_on_.data(),
             .laws = laws_.data(),
             .first = first_.data(),
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
    return exec.template combine<1>(view_.first_edge, MovedFar<Real>{probe_node_.data(), body.u, searched_.data(),
                                                                     body.v, Real(ahead), Real(limit)})[0] > 0;
  }

 private:
  template <class T>
  using Array = typename Exec::template Array<T>;
  std::vector<int> probes_, corners_, edges_;
  Array<int> probe_node_, corner_, edge_, edge_goes_on_, active_, first_, target_, law_, node_, node_first_,
      entry_probe_, entry_candidate_, entry_corner_;
  Array<Real> x_, area_, weight_, force_, resisting_, searched_;
  Array<MovingLaw<Real>> laws_;
  Array<double> stored_;
  Real reach_ = 0;
  MovingContactView<Real> view_;

 public:
  Array<Real> memory;  ///< [numbers * probes]
  Array<double> lost;  ///< [probes] J
};

}  // namespace ashlar
