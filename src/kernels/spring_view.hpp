#pragma once
#include <cstdint>

#include "model/summed.hpp"
#include "physics/interface_laws/spring.hpp"

namespace ashlar {

/// What a kernel sees of the springs: contact points in the model's order, structure of arrays. Block nodes as the body
/// numbers them.
template <class Real>
struct SpringView {
  int contact_count = 0;
  int node_count = 0;                      ///< block nodes that have springs
  const int* node_a = nullptr;             ///< [contacts]
  const int* node_b = nullptr;             ///< [contacts]
  const Real* normal = nullptr;            ///< [3 * contacts], unit, from a to b
  const Real* area = nullptr;              ///< [contacts] m^2
  const Real* normal_stiffness = nullptr;  ///< [contacts] Pa/m
  const Real* shear_stiffness = nullptr;   ///< [contacts] Pa/m
  const Real* initial_gap = nullptr;       ///< [3 * contacts] m, what the initial stress has stretched; null: nothing
  const Real* strength = nullptr;          ///< [contacts] share of the law's strength; null: all of it
  const int* interface = nullptr;          ///< [contacts], index into laws
  const SpringLaw<Real>* laws = nullptr;
  ContactState* state = nullptr;  ///< [contacts]
  const Real* slip = nullptr;     ///< [3 * contacts] m, at the last kept equilibrium
  const Real* damage = nullptr;   ///< [contacts] broken share at the last kept equilibrium; null: nothing softens
  const Real* water = nullptr;    ///< [contacts] Pa, pressure where they are open; null: all is dry
  Real* force = nullptr;          ///< [3 * contacts] N, on side a; side b gets the opposite

  /// Springs of a node: entries node_first[i] .. node_first[i+1]-1 of node_contact, contacts ascending.
  const int* node = nullptr;          ///< [nodes with springs] the block node
  const int* node_first = nullptr;    ///< [nodes with springs + 1]
  const int* node_contact = nullptr;  ///< contact c where the node is side a, -1 - c where it is side b

  ASHLAR_HD Vec3<Real> normal_of(int c) const { return {normal[3 * c], normal[3 * c + 1], normal[3 * c + 2]}; }
  ASHLAR_HD Vec3<Real> slip_of(int c) const { return {slip[3 * c], slip[3 * c + 1], slip[3 * c + 2]}; }
  ASHLAR_HD SpringStiffness<Real> stiffness_of(int c) const { return {normal_stiffness[c], shear_stiffness[c]}; }
  ASHLAR_HD SpringLaw<Real> law_of(int c) const {
    const SpringLaw<Real>& law = laws[interface[c]];
    return strength ? law.with_strength(strength[c]) : law;
  }
  /// Of a nodal field: displacement (Summed) or velocity.
  template <class Field>
  ASHLAR_HD Vec3<Real> gap(const Field& u, int c) const {
    const int a = 3 * node_a[c], b = 3 * node_b[c];
    return {difference(u[b], u[a]), difference(u[b + 1], u[a + 1]), difference(u[b + 2], u[a + 2])};
  }
  ASHLAR_HD Vec3<Real> stretch(const Vec3<Real>& moved, int c) const {
    if (!initial_gap) return moved;
    return moved + Vec3<Real>{initial_gap[3 * c], initial_gap[3 * c + 1], initial_gap[3 * c + 2]};
  }
  /// Traction of contact c at displacement u, and the slip that goes with it.
  ASHLAR_HD SpringAnswer<Real> answer(const Summed<Real>& u, int c) const {
    return answer_to(stretch(gap(u, c), c), c);
  }
  /// The same where its faces have moved apart by `stretched`, m.
  ASHLAR_HD SpringAnswer<Real> answer_to(const Vec3<Real>& stretched, int c) const {
    const auto law = law_of(c);
    if (damage && law.softens()) return softening_answer_to(law, stretched, c);
    const bool holds = law.holds(state[c]);  // such a spring has never slid
    return spring_traction(holds, law.tan_friction, stiffness_of(c), split(stretched, normal_of(c)),
                           holds ? Vec3<Real>{} : slip_of(c));
  }
  /// Force on side a, N: traction, and the water in what is open.
  ASHLAR_HD Vec3<Real> force_on_a(SpringAnswer<Real> answer, int c) const {
    if (water) answer.traction.normal = fma(-answer.damage, water[c], answer.traction.normal);
    return area[c] * joined(answer.traction, normal_of(c));
  }
  ASHLAR_HD SofteningAnswer<Real> softening_answer_to(const SpringLaw<Real>& law, const Vec3<Real>& stretched,
                                                      int c) const {
    return softening_traction(law, stiffness_of(c), split(stretched, normal_of(c)), slip_of(c), damage[c], state[c]);
  }
};

/// The contact points of overlaps: every array of theirs from its first. What differs is between which nodes they are.
template <class Real>
struct OverlapView : SpringView<Real> {
  const int* first_end = nullptr;    ///< [overlap points + 1] into end_node
  const int* end_node = nullptr;     ///< block nodes, side a first
  const Real* end_weight = nullptr;  ///< shape functions, side a negative; they sum to zero

  /// Overlap points of a node: entries node_first[i] .. node_first[i+1]-1 of node_contact, which holds the points.
  const Real* node_weight = nullptr;  ///< beside node_contact: weight of the node in the point's gap

  /// From differences to the first node, which stay exact where everything moves.
  template <class Field>
  ASHLAR_HD Vec3<Real> gap(const Field& u, int c) const {
    const int base = 3 * end_node[first_end[c]];
    Vec3<Real> sum;
    for (int j = first_end[c] + 1; j < first_end[c + 1]; ++j) {
      const int node = 3 * end_node[j];
      for (int i = 0; i < 3; ++i) sum[i] = fma(end_weight[j], difference(u[node + i], u[base + i]), sum[i]);
    }
    return sum;
  }
  ASHLAR_HD SpringAnswer<Real> answer(const Summed<Real>& u, int c) const {
    return this->answer_to(this->stretch(gap(u, c), c), c);
  }
};

}  // namespace ashlar
