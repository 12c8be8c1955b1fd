#pragma once
#include <map>
#include <vector>

#include "model/mesher/size_field.hpp"

namespace ashlar {

/// How elements of varying size follow each other along an edge.
class EdgeProfile {
 public:
  /// @param counts (place 0..1, elements up to there, not rounded), from (0, 0) to place 1
  explicit EdgeProfile(std::vector<std::pair<double, double>> counts) : counts_(std::move(counts)) {}
  double natural_count() const { return counts_.back().second; }
  /// The n + 1 places, from 0 to 1, of n elements in these proportions.
  std::vector<double> places(int n) const;
  /// Seen from the other end.
  EdgeProfile reversed() const;

 private:
  std::vector<std::pair<double, double>> counts_;
};

/// Element sizes in the sections that are meshed free: `size`, or `hole_size` around holes, less where an edge of the
/// outline is shorter, where little material is left between two edges, and where a neighbour is finer; growing away
/// from there by `grow`.
class FreeSizes {
 public:
  /// Throws DeckError where a section is too thin for its size.
  explicit FreeSizes(const SectionGraph& graph);

  bool has(const Edge& edge) const { return owners_.contains(edge); }
  /// Whether a free section halves the edge: it must be divided into an even number.
  bool even(const Edge& edge) const;
  /// Elements along an edge of free sections, none larger than `largest`, m.
  EdgeProfile profile(const Edge& edge, double largest = HUGE_VAL) const;
  /// Size at a vertex of free sections, m.
  double at_vertex(int vertex) const;
  /// Size in a free section, m.
  double at(int section, const PlanePoint& p) const { return fields_[section].at(p); }

  /// Takes an edge as it has been divided, by neighbours that are meshed in rows.
  void take(const Edge& edge, const std::vector<PlanePoint>& points);
  /// Sizes follow what has been taken.
  void update();
  /// Points along an edge of free sections, ends included, in the direction of the edge.
  std::vector<PlanePoint> divide(const Edge& edge) const;

 private:
  double at(const Edge& edge, const PlanePoint& p) const;
  const SectionGraph& graph_;
  std::map<Edge, std::vector<int>> owners_;    ///< free sections of each edge
  std::map<int, std::vector<int>> at_vertex_;  ///< free sections of each vertex
  std::vector<std::vector<SizeAt>> places_;    ///< [sections]
  std::vector<SizeField> fields_;              ///< [sections]
};

}  // namespace ashlar
