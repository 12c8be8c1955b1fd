#pragma once
#include <vector>

#include "solve/problem.hpp"

namespace ashlar {

/// Virtual mass for relaxation with unit steps: M >= 1.05 (1 + alpha) / 4 * K in every motion, alpha the local damping,
/// divided by step_factor^2 (numerics 3). D is the row-sum bound of the blocks' stiffness, S that of the springs, 2 A
/// max(k_n, k_s) each.
///
/// A node without bonded springs has the mass of D + S. Copies of one mesh node that intact, bonded springs tie form a
/// group: its mean motion v does not strain those springs and moves with the mass of D (and of cracked springs to other
/// groups); motion r against each other has the mass of D + S. Since (v + r) K (v + r) <= (1 + 1/t) v K v + (1 + t) r K
/// r for any t > 0, the two masses carry the factors 1 + 1/t and 1 + t; t = 4. So a fully crackable body relaxes nearly
/// as fast as a continuous one, however stiff its contacts are, where one mass a node would make it slower by the root
/// of (D + S) / D.
///
/// Local damping scales forces node by node, which the bound on a group's mean motion does not survive: with it every
/// node has the mass of D + S.
///
class VirtualMass {
 public:
  /// `problem` and `backend` outlive this; laws keep their stiffness.
  VirtualMass(const Problem& problem, Backend& backend, const Relaxation& relaxation);
  /// Sets it by the contact points that are bonded now. After the first time only groups that lost a bond are looked at.
  void set();

 private:
  void join_all();
  void part(const std::vector<int>& cracked);
  int root(int node);
  void join(int contact);
  void find_between(int node);
  void write();

  const Problem& problem_;
  Backend& backend_;
  double factor_;
  bool grouped_;                       ///< bonded springs make groups
  bool set_before_ = false;
  std::vector<double> blocks_;         ///< [nodes] D, N/m
  std::vector<double> springs_;        ///< [nodes] S of all springs
  std::vector<double> of_overlaps_;    ///< [nodes] S of contact points between more than two nodes
  std::vector<double> between_;        ///< [nodes] S of springs to other groups
  std::vector<int> a_, b_;             ///< [pairs] nodes, the machine's numbering
  std::vector<double> stiffness_;      ///< [pairs] 2 A max(k_n, k_s)
  std::vector<char> bonded_;           ///< [pairs]
  std::vector<int> first_pair_, pair_; ///< pairs of every node, ascending
  std::vector<int> group_;             ///< [nodes] lowest node of its group
  std::vector<int> next_;              ///< [nodes] next higher node of its group, -1: none
};

/// The same, once.
inline void set_virtual_mass(const Problem& problem, Backend& backend, const Relaxation& relaxation) {
  VirtualMass(problem, backend, relaxation).set();
}

}  // namespace ashlar
