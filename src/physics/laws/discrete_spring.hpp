#pragma once
#include "physics/laws/elastic.hpp"

namespace ashlar {

/// The discrete spring model of the paper: nearly rigid blocks, and springs between them that are given the body's
/// elasticity. Blocks are `rigidity` times stiffer than springs, and springs are as much stiffer than the body as makes
/// up for that, one in a row with the other.
struct DiscreteSpring : Elastic {
  double packing = 0, rigidity = 10;

  static constexpr const char* packings[] = {"bricks", "irregular"};
  static constexpr const char* name = "discrete_spring";
  static constexpr const char* doc =
      "Nearly rigid blocks that give way at the springs between them only, whose stiffness follows from young and "
      "poisson; `crackable` cuts the region into such blocks, and its law says how springs break. A body of broken "
      "rock or masonry.";
  static inline const LawKey<DiscreteSpring> keys[] = {
      young_key<DiscreteSpring>,
      poisson_key<DiscreteSpring>,
      expansion_key<DiscreteSpring>,
      {"packing", &DiscreteSpring::packing, dimension::none, range::any, 0.0,
       "bricks: rows of hex8, young along the rows, the shear modulus between them, no lateral strain; irregular: "
       "faces in all directions (tet4), where all blocks strain alike, which they do nearly for poisson up to 0.1 "
       "(given 0.15 they have 0.2, and young is 9 % less)",
       packings},
      {"rigidity", &DiscreteSpring::rigidity, dimension::none, Range{2, 1e4}, 10.0,
       "how many times stiffer blocks are than the body; more takes more steps"},
  };

  /// Normal traction over strain across a face, and shear traction over the shear of its plane, of springs and blocks
  /// together, Pa. Irregular: Cusatis et al. 2011, Cem. Concr. Compos. 33, from equal work under uniform strain.
  double normal_modulus() const { return packing == 0 ? young : young / (1 - 2 * poisson); }
  double shear_modulus() const {
    return packing == 0 ? young / (1 + poisson) : normal_modulus() * (1 - 4 * poisson) / (1 + poisson);
  }
  double block_modulus() const { return rigidity * normal_modulus(); }
  /// Of the springs in a length between centres, m^2/N: all less what the blocks give way.
  double normal_compliance() const { return 1 / normal_modulus() - 1 / block_modulus(); }
  double shear_compliance() const { return 1 / shear_modulus() - 1 / block_modulus(); }

  template <class Real>
  Point<Real> prepare() const {
    return {Real(0), Real(block_modulus() / 2), Real(expansion)};
  }
  std::vector<LawComplaint> complaints() const {
    if (packing == 1 && poisson > 0.15)
      return {{"poisson", "blocks of an irregular packing do not strain alike beyond 0.15, and would be much softer than "
                          "asked; give at most 0.15, or packing = \"bricks\""}};
    if (shear_modulus() >= block_modulus())
      return {{"rigidity", "blocks would be softer than their springs; give a larger rigidity, or poisson above -0.5"}};
    return {};
  }
  DiscreteSpring weakened(double) const { return *this; }
};

}  // namespace ashlar
