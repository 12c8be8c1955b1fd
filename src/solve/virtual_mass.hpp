#pragma once
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
/// To be set again when contact points have cracked.
void set_virtual_mass(const Problem& problem, Backend& backend, const Relaxation& relaxation);

}  // namespace ashlar
