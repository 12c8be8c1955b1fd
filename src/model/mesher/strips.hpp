#pragma once
#include <map>
#include <utility>
#include <vector>

#include "model/mesher/free_sizes.hpp"
#include "model/mesher/section_graph.hpp"

/// Opposite edges of a logical quad have equal divisions; so have the opposite edges of its neighbour across a shared
/// edge, and so on: such edges form a strip through the sections. Strips make any set of sections conform.
namespace ashlar {

/// Places of points of two opposite sides along them, 0..1, so that points of equal place face each other: by height
/// (or x, for sides that run along x) where both sides rise steadily, which keeps rows level and columns upright;
/// else by arc length.
struct FacingPlaces {
  std::vector<double> a, b;
};
FacingPlaces facing_places(const std::vector<PlanePoint>& a, const std::vector<PlanePoint>& b);

/// Puts vertices on sides so that every vertex of a side faces one on the opposite side, in all sections.
/// Vertices that face each other within half an element are taken as a pair. Throws DeckError if there is no end to it.
void match_opposite_sides(SectionGraph& graph);

/// Points along every edge of the graph, keyed by (smaller vertex, larger vertex), in that direction, ends included.
using EdgePoints = std::map<Edge, std::vector<PlanePoint>>;

/// Divides all edges: those of logical quads strip by strip, by the finest size on it, graded, or as `divisions` asks;
/// then those of sections meshed free, whose sizes follow the strips beside them.
/// Throws DeckError where `divisions` contradict each other.
EdgePoints divide_edges(const SectionGraph& graph, FreeSizes& free);

}  // namespace ashlar
