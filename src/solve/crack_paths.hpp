#pragma once
#include <vector>

#include "solve/problem.hpp"

/// Cracks of `breakage` that keep a distance (crack_spacing): they grow from their ends, along their own planes, and
/// nothing opens beside them. Crack tracking after Cervera & Chiumenti 2006, with planes that are means over neighbours
/// (Gasser & Holzapfel 2006). Without it a band of cracked elements prefers the directions of the mesh.
namespace ashlar {

class CrackPaths {
 public:
  /// `problem` outlives this.
  explicit CrackPaths(const Problem& problem);

  /// Whether cracks of any material keep a distance.
  bool any() const { return !elements_.empty(); }

  /// At an equilibrium, in place of Phase::advance_history: moves histories on, takes back what opened beside a crack,
  /// and lets only the elements into which cracks lead open next. Whether elements cracked: then there is to be relaxed
  /// again. Nothing is kept here: a run goes on alike from any checkpoint.
  bool advance();

 private:
  /// One of a material whose cracks keep a distance.
  struct Element {
    int source;             ///< mesh element
    int first, step, points;  ///< into a number of the history: its first Gauss point, from one to the next, how many
    double spacing, volume, least_slip;
    Vec3<double> centre;
  };
  struct State;
  std::vector<int> around(int element) const;
  bool lies_ahead(int element, const State& state) const;
  bool far_from_cracks(int element, const State& state) const;

  const Problem& problem_;
  std::vector<Element> elements_;
  std::vector<int> first_, around_;  ///< elements around a mesh node
  int points_ = 0;                   ///< Gauss points that remember: from one number of the history to the next
};

}  // namespace ashlar
