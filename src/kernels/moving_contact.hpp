#pragma once
#include "base/tensor.hpp"
#include "model/view.hpp"
#include "physics/edge_crossing.hpp"

/// Phase moving_contacts: contacts of blocks that move far, found anew in every step among the candidates of the last
/// search. A node with those of its faces that look one way presses on triangles of other blocks; long sharp edges
/// press on each other, in pairs, where a piece of one crosses a piece of the other.
namespace ashlar {

/// Frictional contact between two regions.
template <class Real>
struct MovingLaw {
  Real normal_stiffness = 0, shear_stiffness = 0;  ///< Pa/m
  Real tan_friction = 0;
};

/// What a probe or a pair of long edges remembers from step to step.
template <class Real>
struct ProbeMemory {
  Real own = 0;      ///< node or edge that is near to the target
  Real target = -2;  ///< triangle or edge; -1: none, -2: it never looked
  Real law = 0;
  Real area = 0;     ///< m^2 that it presses with, of the moment when it began to press
  Real offset = 0;   ///< m, gap from which on it presses: not above 0, below where it came in from the side
  Real pressed = 0;  ///< m, how far beyond that
  Vec3<Real> shear;  ///< m, elastic part of the movement along the triangle
};
inline constexpr int probe_numbers = 9;

template <class Real>
struct MovingContactView {
  int probe_count = 0, node_count = 0;
  int first_pair = 0;                     ///< probes from here on are pairs of long edges
  const Real* x = nullptr;                ///< [3 * block nodes] m, undeformed
  const int* rim_first = nullptr;         ///< [first_pair + 1]
  const int* rim = nullptr;               ///< [..] nodes at the other ends of those edges of its faces that meet at it
  const Real* may_dip = nullptr;          ///< [first_pair] sine by which a rim may dip into a triangle
  const int* corner = nullptr;            ///< [3 * triangles] block nodes, counter-clockwise from outside
  const int* edge = nullptr;              ///< [4 * edges] two nodes, a further one of the face on each side
  const int* edge_ends = nullptr;         ///< [2 * edges] 1: the long edge ends there, too
  const MovingLaw<Real>* laws = nullptr;  ///< [interfaces]
  const int* first = nullptr;             ///< [probes + 1] into the candidates
  const int* own = nullptr;               ///< [candidates] node or edge
  const int* target = nullptr;            ///< [candidates] triangle or edge
  const int* law = nullptr;               ///< [candidates] index into laws
  const Real* area = nullptr;             ///< [candidates] m^2, what the probe presses with on this target
  Real reach = 0;                         ///< m, depth up to which a node is behind a triangle
  ProbeMemory<Real>* memory = nullptr;    ///< [probes]
  int* active = nullptr;                  ///< [probes] candidate that the probe is at; -1: none
  Real* weight = nullptr;                 ///< [4 * probes] share of the force that each node of contact bears
  Real* force = nullptr;                  ///< [3 * probes] N, on the probe
  Real* resisting = nullptr;              ///< [3 * probes] N on the probe, by damping
  double* stored = nullptr;               ///< [probes] J
  double* lost = nullptr;                 ///< [probes] J since the stage began: friction, contacts that ended pressed

  /// Where a node touches what: entries node_first[i] .. node_first[i+1]-1.
  const int* node = nullptr;             ///< [nodes with entries]
  const int* node_first = nullptr;       ///< [nodes with entries + 1]
  const int* entry_probe = nullptr;      ///< [entries]
  const int* entry_candidate = nullptr;  ///< [entries] counted when the probe is at it; -1: always
  const int* entry_corner = nullptr;     ///< [entries] which of the nodes of contact it is
};

/// The nodes of one contact: of a triangle and the probe, or of the other edge and the own one.
inline constexpr int contact_nodes = 4;
ASHLAR_HD void nodes_of_contact(int probe_node, const int* triangle, int (&node)[contact_nodes]) {
  for (int i = 0; i < 3; ++i) node[i] = triangle[i];
  node[3] = probe_node;
}
ASHLAR_HD void nodes_of_crossing(const int* own, const int* other, int (&node)[contact_nodes]) {
  for (int i = 0; i < 2; ++i) {
    node[i] = other[i];
    node[2 + i] = own[i];
  }
}

/// One probe -> the target it is at, its force and what it remembers. Normals are the present ones and the foot of
/// the node moves with it, so the normal force has a potential. A contact begins without force, at whatever depth the
/// node comes in, and goes on from piece to piece with the force it has; what it stores when it ends is booked as lost.
template <class Real>
struct MoveContact {
  MovingContactView<Real> contacts;
  Summed<Real> u;
  const Real* v;
  Real step;     ///< s from the last displacement to this one; 0: nothing has moved
  Real damping;  ///< s, force of a speed over that of a distance

  struct Foot {
    int candidate = -1;
    Real gap = 0;
    Vec3<Real> normal;
    Vec3<Real> normal_before, moved_before;  ///< of what it pressed on; m that it moved over that in the last step
    bool beside = false;                     ///< it lies neither over nor behind the target
    Real weight[contact_nodes];
  };

  ASHLAR_HD void operator()(int p) const {
    ProbeMemory<Real> now = contacts.memory[p];
    const Foot foot = nearest(p, now);
    const double stored_before = stored(now);
    const bool fresh = now.target == Real(-2), touches = foot.candidate >= 0;
    const int law_index = touches ? contacts.law[foot.candidate] : -1;
    double lost = 0;
    if (!fresh && (!touches || now.target < Real(0) || now.law != Real(law_index))) {
      lost += stored_before + half_step(now, foot);
      now.pressed = 0;
      now.shear = {};
      now.offset = foot.gap < Real(0) ? foot.gap : Real(0);
    }
    Vec3<Real> force, resisting;
    if (!touches) now.target = Real(-1);
    if (touches) {
      const int own = contacts.own[foot.candidate], target = contacts.target[foot.candidate];
      now.law = Real(law_index);
      if (now.pressed == Real(0)) now.area = contacts.area[foot.candidate];
      const MovingLaw<Real> law = contacts.laws[law_index];
      const Real normal_stiffness = law.normal_stiffness * now.area, shear_stiffness = law.shear_stiffness * now.area;
      const Vec3<Real> speed = relative_speed(p, own, target, foot), sliding = flat(speed, foot.normal);
      if (!fresh && (now.own != Real(own) || now.target != Real(target))) {
        const Real sinks = -step * dot(speed, foot.normal), sank = -dot(foot.moved_before, foot.normal_before);
        lost += hand_over(now, foot.gap, now.pressed > Real(0) ? Real(0.5) * (sinks + sank) : sinks, normal_stiffness);
      }
      now.own = Real(own);
      now.target = Real(target);
      press(now, foot.gap);
      const Real push = normal_stiffness * now.pressed, limit = push * law.tan_friction;

      const Vec3<Real> before = flat(now.shear, foot.normal), trial = before + step * sliding;
      const Real turned = dot(now.shear, now.shear) - dot(before, before);
      const Real size = shear_stiffness * norm(trial);
      const bool slides = size > limit;
      now.shear = slides ? (limit / size) * trial : trial;
      const Real slid = dot(before + now.shear, trial - now.shear);
      lost += 0.5 * double(shear_stiffness) * (double(turned) + double(slid));
      force = push * foot.normal - shear_stiffness * now.shear;

      if (damping > Real(0) && now.pressed > Real(0)) {
        Real resists = -damping * normal_stiffness * dot(speed, foot.normal);
        if (resists < -push) resists = -push;  // nothing pulls
        resisting = resists * foot.normal;
        if (!slides) {
          const Vec3<Real> drag = (-damping * shear_stiffness) * sliding;
          const Real room = limit - size, wanted = norm(drag);
          resisting = resisting + (wanted > room ? room / wanted : Real(1)) * drag;
        }
      }
    }
    now.offset = now.offset + Real(0);  // of two zeros a device's compiler chooses the other
    contacts.memory[p] = now;
    contacts.active[p] = foot.candidate;
    contacts.stored[p] = stored(now);
    contacts.lost[p] += lost;
    for (int i = 0; i < contact_nodes; ++i) contacts.weight[contact_nodes * p + i] = foot.weight[i];
    for (int i = 0; i < 3; ++i) {
      contacts.force[3 * p + i] = force[i];
      contacts.resisting[3 * p + i] = resisting[i];
    }
  }

 private:
  /// J
  ASHLAR_HD double stored(const ProbeMemory<Real>& m) const {
    if (m.target < Real(0)) return 0;
    const MovingLaw<Real> law = contacts.laws[int(m.law)];
    const double normal = double(law.normal_stiffness) * double(m.pressed) * double(m.pressed);
    return 0.5 * double(m.area) * (normal + double(law.shear_stiffness) * double(dot(m.shear, m.shear)));
  }
  /// Work of the last force over the half of the last step, J.
  ASHLAR_HD double half_step(const ProbeMemory<Real>& m, const Foot& foot) const {
    if (!(m.pressed > Real(0))) return 0;
    const MovingLaw<Real> law = contacts.laws[int(m.law)];
    const double normal =
        -double(law.normal_stiffness) * double(m.pressed * dot(foot.moved_before, foot.normal_before));
    return 0.5 * double(m.area) * (normal + double(law.shear_stiffness) * double(dot(m.shear, foot.moved_before)));
  }
  /// On another piece than before it lies as deep as it did and the step has brought: a step between two pieces becomes
  /// offset. What does not lie that deep there has lost the difference, J.
  ASHLAR_HD static double hand_over(ProbeMemory<Real>& now, Real gap, Real sinks, Real stiffness) {
    const Real pressed = now.pressed + sinks > Real(0) ? now.pressed + sinks : Real(0);
    const Real deepest = gap < Real(0) ? -gap : Real(0);
    now.offset = pressed < deepest ? gap + pressed : Real(0);
    if (!(now.pressed > Real(0) && pressed > deepest)) return 0;
    return 0.5 * double(stiffness) * (double(pressed) * double(pressed) - double(deepest) * double(deepest));
  }
  /// The depth beyond the offset at the present gap.
  ASHLAR_HD static void press(ProbeMemory<Real>& now, Real gap) {
    if (gap > now.offset) now.offset = gap < Real(0) ? gap : Real(0);
    now.pressed = now.offset - gap;
    if (now.pressed < Real(0)) now.pressed = 0;
  }
  ASHLAR_HD static Vec3<Real> flat(const Vec3<Real>& a, const Vec3<Real>& n) { return a - dot(a, n) * n; }
  /// From the probe's node to another one.
  ASHLAR_HD Vec3<Real> way(int from, int to) const {
    Vec3<Real> r;
    for (int i = 0; i < 3; ++i)
      r[i] = (contacts.x[3 * to + i] - contacts.x[3 * from + i]) + difference(u[3 * to + i], u[3 * from + i]);
    return r;
  }
  ASHLAR_HD Vec3<Real> relative_speed(int p, int own, int target, const Foot& foot) const {
    int node[contact_nodes];
    if (p < contacts.first_pair)
      nodes_of_contact(own, contacts.corner + 3 * target, node);
    else
      nodes_of_crossing(contacts.edge + 4 * own, contacts.edge + 4 * target, node);
    Vec3<Real> speed;
    for (int k = 0; k < contact_nodes; ++k)
      for (int i = 0; i < 3; ++i) speed[i] = fma(-foot.weight[k], v[3 * node[k] + i], speed[i]);
    return speed;
  }
  ASHLAR_HD Foot foot_on(int p, int own, int target) const {
    return p < contacts.first_pair ? on_triangle(p, own, contacts.corner + 3 * target) : on_edge(own, target);
  }
  /// A node bears only on what none of its own rims dips into: otherwise something else of the two bodies touches.
  ASHLAR_HD Foot on_triangle(int p, int node, const int* corner) const {
    constexpr Real outside = Real(-1e-4);
    const Vec3<Real> a = way(node, corner[0]), b = way(node, corner[1]), c = way(node, corner[2]);
    const Vec3<Real> across = cross(b - a, c - a);
    const Real twice = norm(across);
    Foot foot;
    foot.normal = (Real(1) / twice) * across;
    foot.gap = -dot(a, foot.normal);
    foot.weight[0] = dot(cross(b, c), foot.normal) / twice;
    foot.weight[1] = dot(cross(c, a), foot.normal) / twice;
    foot.weight[2] = Real(1) - foot.weight[0] - foot.weight[1];
    foot.weight[3] = Real(-1);
    foot.beside = foot.weight[0] < outside || foot.weight[1] < outside || foot.weight[2] < outside;
    for (int i = contacts.rim_first[p]; i < contacts.rim_first[p + 1] && !foot.beside; ++i) {
      const Vec3<Real> rim = way(node, contacts.rim[i]);
      foot.beside = dot(rim, foot.normal) < -contacts.may_dip[p] * norm(rim);
    }
    return foot;
  }
  /// Edges touch at their ends only where nodes do. Where faces lie flat on each other edges bear, too: of a block that
  /// lies across another one no node may lie on a face.
  ASHLAR_HD Foot on_edge(int e, int target) const {
    constexpr Real flat_sine = Real(2e-3);
    const int* const own = contacts.edge + 4 * e;
    const int* const other = contacts.edge + 4 * target;
    const int o = other[0];
    const EdgeCrossing<Real> crossing = cross_edges(way(o, own[0]), way(o, own[1]), way(o, own[2]), way(o, own[3]),
                                                    way(o, other[1]), way(o, other[2]), way(o, other[3]));
    Foot foot;
    foot.normal = crossing.normal;
    foot.gap = crossing.gap;
    foot.weight[0] = Real(1) - crossing.other;
    foot.weight[1] = crossing.other;
    foot.weight[2] = crossing.own - Real(1);
    foot.weight[3] = -crossing.own;
    const bool away = crossing.own_leans > flat_sine || crossing.other_leans > flat_sine;
    foot.beside = crossing.parallel || away || beyond(e, 0, crossing.own) || beyond(e, 1, Real(1) - crossing.own) ||
                  beyond(target, 0, crossing.other) || beyond(target, 1, Real(1) - crossing.other);
    return foot;
  }
  /// Whether a place, counted from one end of an edge, is none of this edge. Pieces of a long edge have a bit of each
  /// other, so that nothing falls between them.
  ASHLAR_HD bool beyond(int e, int end, Real from_end) const {
    return from_end < (contacts.edge_ends[2 * e + end] == 1 ? Real(1e-3) : Real(-1e-3));
  }
  /// Of the targets that the probe lies over or behind the nearest one; one that pressed stays where it was, or else on
  /// what looks the same way, until another face comes to be as near: the force's potential goes on over it.
  ASHLAR_HD Foot nearest(int p, const ProbeMemory<Real>& memory) const {
    constexpr Real same_way = Real(0.9);
    const bool pressed = memory.pressed > Real(0);
    const int own = int(memory.own), target = int(memory.target);
    Foot best, last;
    Real moved = Real(0);
    Vec3<Real> moved_before;
    if (pressed) {
      last = foot_on(p, own, target);
      moved_before = step * relative_speed(p, own, target, last);
      moved = Real(2) * norm(moved_before);
    }
    for (int i = 0; i < contact_nodes; ++i) best.weight[i] = Real(0);
    Real least = Real(0);
    for (int j = contacts.first[p]; j < contacts.first[p + 1]; ++j) {
      Foot foot = foot_on(p, contacts.own[j], contacts.target[j]);
      const Real distance = foot.gap < Real(0) ? -foot.gap : foot.gap;
      if (foot.beside || distance > contacts.reach) continue;
      Real cost = distance;
      if (pressed && contacts.own[j] == own && contacts.target[j] == target)
        cost = distance - Real(4) * contacts.reach;
      else if (pressed && dot(foot.normal, last.normal) > same_way)
        cost = distance - Real(2) * contacts.reach;
      else if (pressed && foot.gap < Real(0) && foot.gap > last.gap && foot.gap <= last.gap + moved)
        cost = distance - Real(6) * contacts.reach;
      if (best.candidate >= 0 && cost >= least) continue;
      least = cost;
      best = foot;
      best.candidate = j;
    }
    best.normal_before = last.normal;
    best.moved_before = moved_before;
    return best;
  }
};

/// One node -> force of its probes and of those that press on it, added to its internal force; that of damping.
template <class Real>
struct GatherMovingContact {
  MovingContactView<Real> contacts;
  Real* force;      ///< [3 * block nodes] N
  Real* resisting;  ///< [3 * block nodes] N; null: nothing is damped

  ASHLAR_HD void operator()(int i) const {
    const int at = 3 * contacts.node[i];
    Vec3<Real> sum{force[at], force[at + 1], force[at + 2]}, damped;
    for (int j = contacts.node_first[i]; j < contacts.node_first[i + 1]; ++j) {
      const int p = contacts.entry_probe[j], candidate = contacts.entry_candidate[j];
      if (candidate >= 0 && candidate != contacts.active[p]) continue;
      const Real share = contacts.weight[contact_nodes * p + contacts.entry_corner[j]];
      for (int k = 0; k < 3; ++k) {
        sum[k] = fma(share, contacts.force[3 * p + k], sum[k]);
        damped[k] = fma(share, contacts.resisting[3 * p + k], damped[k]);
      }
    }
    for (int k = 0; k < 3; ++k) {
      force[at + k] = sum[k];
      if (resisting) resisting[at + k] = damped[k];
    }
  }
};

enum MovingContactSum : int { moving_stored, moving_lost, moving_contact_sum_count };
/// One probe -> its energies, J.
template <class Real>
struct MovingContactSums {
  MovingContactView<Real> contacts;
  ASHLAR_HD void operator()(int p, double (&s)[moving_contact_sum_count]) const {
    s[moving_stored] = contacts.stored[p];
    s[moving_lost] = contacts.lost[p];
  }
};

/// One probe -> 1 where its node has moved further than `limit` since the last search, or could within `ahead` seconds.
template <class Real>
struct MovedFar {
  const int* probe_node;
  Summed<Real> u;
  const Real* searched;  ///< [3 * block nodes] m, displacement of the last search
  const Real* v;
  Real ahead, limit;
  ASHLAR_HD void operator()(int p, double (&s)[1]) const {
    const int node = 3 * probe_node[p];
    Vec3<Real> moved;
    for (int i = 0; i < 3; ++i) moved[i] = u.above(node + i, searched[node + i]);
    const Vec3<Real> speed{v[node], v[node + 1], v[node + 2]};
    s[0] = norm(moved) + ahead * norm(speed) > limit ? 1 : 0;
  }
};

}  // namespace ashlar
