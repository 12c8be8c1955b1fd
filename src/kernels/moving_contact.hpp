#pragma once
#include "base/tensor.hpp"
#include "model/view.hpp"

/// Phase moving_contacts: contacts of blocks that move far, found anew in every step among the candidates of the last
/// search. A probe is a node with those of its faces that look one way; it presses on triangles of other blocks.
namespace ashlar {

/// Frictional contact between two regions, of one of the two sides that look for each other.
template <class Real>
struct MovingLaw {
  Real normal_stiffness = 0, shear_stiffness = 0;  ///< Pa/m, half of the interface's
  Real tan_friction = 0;
};

/// What a probe remembers from step to step.
template <class Real>
struct ProbeMemory {
  Real triangle = -2;  ///< that it is near to; -1: none, -2: it never looked
  Real law = 0;
  Real area = 0;     ///< m^2 that it presses with, of the moment when it began to press
  Real offset = 0;   ///< m, gap from which on it presses: not above 0, below where it came in from the side
  Real pressed = 0;  ///< m, how far beyond that
  Vec3<Real> shear;  ///< m, elastic part of the movement along the triangle
};
inline constexpr int probe_numbers = 8;

template <class Real>
struct MovingContactView {
  int probe_count = 0, node_count = 0;
  const Real* x = nullptr;                ///< [3 * block nodes] m, undeformed
  const int* probe_node = nullptr;        ///< [probes]
  const int* corner = nullptr;            ///< [3 * triangles] block nodes, counter-clockwise from outside
  const MovingLaw<Real>* laws = nullptr;  ///< [interfaces]
  const int* first = nullptr;             ///< [probes + 1] into the candidates
  const int* triangle = nullptr;          ///< [candidates]
  const int* law = nullptr;               ///< [candidates] index into laws
  const Real* area = nullptr;             ///< [candidates] m^2, what the probe presses with on this triangle
  Real reach = 0;                         ///< m, depth up to which a node is behind a triangle
  ProbeMemory<Real>* memory = nullptr;    ///< [probes]
  int* active = nullptr;                  ///< [probes] candidate that the probe is at; -1: none
  Real* weight = nullptr;                 ///< [3 * probes] shape functions of that triangle
  Real* force = nullptr;                  ///< [3 * probes] N, on the node
  Real* resisting = nullptr;              ///< [3 * probes] N on the node, by damping
  double* stored = nullptr;               ///< [probes] J
  double* lost = nullptr;                 ///< [probes] J since the stage began: friction, contacts that ended pressed

  /// Where a node touches what: entries node_first[i] .. node_first[i+1]-1.
  const int* node = nullptr;             ///< [nodes with entries]
  const int* node_first = nullptr;       ///< [nodes with entries + 1]
  const int* entry_probe = nullptr;      ///< [entries]
  const int* entry_candidate = nullptr;  ///< [entries] counted when the probe is at it; -1: the node is the probe's own
  const int* entry_corner = nullptr;     ///< [entries] of the candidate's triangle
};

/// One probe -> the triangle it is at, its force and what it remembers. Normals are the present ones and the foot of
/// the node moves with it, so the normal force has a potential and crosses edges between triangles without a jump. A
/// contact begins without force, at whatever depth the node comes in; what it stores when it ends is booked as lost.
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
    Real weight[3];
  };

  ASHLAR_HD void operator()(int p) const {
    ProbeMemory<Real> now = contacts.memory[p];
    const Foot foot = nearest(p, now);
    const double stored_before = stored(now);
    const bool fresh = now.triangle == Real(-2), touches = foot.candidate >= 0;
    const int law_index = touches ? contacts.law[foot.candidate] : -1;
    double lost = 0;
    if (!fresh && (!touches || now.triangle < Real(0) || now.law != Real(law_index))) {
      lost += stored_before;
      now.pressed = 0;
      now.shear = {};
      now.offset = foot.gap < Real(0) ? foot.gap : Real(0);
    }
    Vec3<Real> force, resisting;
    now.triangle = Real(-1);
    if (touches) {
      now.triangle = Real(contacts.triangle[foot.candidate]);
      now.law = Real(law_index);
      if (now.pressed == Real(0)) now.area = contacts.area[foot.candidate];
      const MovingLaw<Real> law = contacts.laws[law_index];
      const Real normal_stiffness = law.normal_stiffness * now.area, shear_stiffness = law.shear_stiffness * now.area;
      const Vec3<Real> speed = relative_speed(p, foot), sliding = flat(speed, foot.normal);
      lost += press(now, foot, Real(2) * step * norm(speed), fresh, normal_stiffness);
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
    contacts.memory[p] = now;
    contacts.active[p] = foot.candidate;
    contacts.stored[p] = stored(now);
    contacts.lost[p] += lost;
    for (int i = 0; i < 3; ++i) {
      contacts.weight[3 * p + i] = foot.weight[i];
      contacts.force[3 * p + i] = force[i];
      contacts.resisting[3 * p + i] = resisting[i];
    }
  }

 private:
  /// J
  ASHLAR_HD double stored(const ProbeMemory<Real>& m) const {
    if (m.triangle < Real(0)) return 0;
    const MovingLaw<Real> law = contacts.laws[int(m.law)];
    const double normal = double(law.normal_stiffness) * double(m.pressed) * double(m.pressed);
    return 0.5 * double(m.area) * (normal + double(law.shear_stiffness) * double(dot(m.shear, m.shear)));
  }
  /// The depth beyond the offset at the present gap. It changes by what can have moved in the step: where the probe has
  /// come to a triangle that lies another way it begins without force, and what it stored beyond is lost, J.
  ASHLAR_HD double press(ProbeMemory<Real>& now, const Foot& foot, Real moved, bool fresh, Real stiffness) const {
    const Real before = now.pressed;
    if (foot.gap > now.offset) now.offset = foot.gap < Real(0) ? foot.gap : Real(0);
    const Real most = before + moved + Real(1e-9) * contacts.reach;
    if (!fresh && now.offset - foot.gap > most) now.offset = foot.gap + most;
    now.pressed = now.offset - foot.gap;
    if (now.pressed < Real(0)) now.pressed = 0;
    if (fresh || before - now.pressed <= moved + Real(1e-9) * contacts.reach) return 0;
    return 0.5 * double(stiffness) * (double(before) * double(before) - double(now.pressed) * double(now.pressed));
  }
  ASHLAR_HD static Vec3<Real> flat(const Vec3<Real>& a, const Vec3<Real>& n) { return a - dot(a, n) * n; }
  /// From the probe's node to another one.
  ASHLAR_HD Vec3<Real> way(int from, int to) const {
    Vec3<Real> r;
    for (int i = 0; i < 3; ++i)
      r[i] = (contacts.x[3 * to + i] - contacts.x[3 * from + i]) + difference(u[3 * to + i], u[3 * from + i]);
    return r;
  }
  ASHLAR_HD Vec3<Real> relative_speed(int p, const Foot& foot) const {
    const int node = 3 * contacts.probe_node[p];
    const int* const corner = contacts.corner + 3 * contacts.triangle[foot.candidate];
    Vec3<Real> speed{v[node], v[node + 1], v[node + 2]};
    for (int k = 0; k < 3; ++k)
      for (int i = 0; i < 3; ++i) speed[i] = fma(-foot.weight[k], v[3 * corner[k] + i], speed[i]);
    return speed;
  }
  ASHLAR_HD Foot foot_on(int node, int triangle) const {
    const int* const corner = contacts.corner + 3 * triangle;
    const Vec3<Real> a = way(node, corner[0]), b = way(node, corner[1]), c = way(node, corner[2]);
    const Vec3<Real> across = cross(b - a, c - a);
    const Real twice = norm(across);
    Foot foot;
    foot.normal = (Real(1) / twice) * across;
    foot.gap = -dot(a, foot.normal);
    foot.weight[0] = dot(cross(b, c), foot.normal) / twice;
    foot.weight[1] = dot(cross(c, a), foot.normal) / twice;
    foot.weight[2] = Real(1) - foot.weight[0] - foot.weight[1];
    return foot;
  }
  /// Of the triangles that the node lies over or behind the nearest one; one that pressed stays on what looks the same
  /// way.
  ASHLAR_HD Foot nearest(int p, const ProbeMemory<Real>& memory) const {
    constexpr Real beside = Real(-1e-4), same_way = Real(0.9);
    const int node = contacts.probe_node[p];
    const bool pressed = memory.pressed > Real(0);
    const Vec3<Real> last = pressed ? foot_on(node, int(memory.triangle)).normal : Vec3<Real>{};
    Foot best;
    for (int i = 0; i < 3; ++i) best.weight[i] = Real(0);
    Real least = Real(0);
    for (int j = contacts.first[p]; j < contacts.first[p + 1]; ++j) {
      Foot foot = foot_on(node, contacts.triangle[j]);
      const Real distance = foot.gap < Real(0) ? -foot.gap : foot.gap;
      if (foot.weight[0] < beside || foot.weight[1] < beside || foot.weight[2] < beside || distance > contacts.reach)
        continue;
      const Real cost = pressed && dot(foot.normal, last) > same_way ? distance - Real(2) * contacts.reach : distance;
      if (best.candidate >= 0 && cost >= least) continue;
      least = cost;
      best = foot;
      best.candidate = j;
    }
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
      const Real share = candidate < 0 ? Real(-1) : contacts.weight[3 * p + contacts.entry_corner[j]];
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
