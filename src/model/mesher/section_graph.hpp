#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "model/model.hpp"

/// The sections of all extrudes as one planar graph in x-z: a vertex or an edge that two sections share exists once.
namespace ashlar {

using PlanePoint = std::array<double, 2>;  ///< x, z, m

inline double distance(const PlanePoint& a, const PlanePoint& b) { return std::hypot(b[0] - a[0], b[1] - a[1]); }
/// Twice the area of the triangle a, b, c; positive if it turns left (x right, z up).
inline double turn(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}
/// Twice the area of a polygon, positive if it runs counter-clockwise.
double twice_area(const std::vector<PlanePoint>& loop);
/// Place of p along the segment a-b, from 0 to 1 within it, and its distance from the line.
struct Foot {
  double along, off;
};
Foot foot_on(const PlanePoint& a, const PlanePoint& b, const PlanePoint& p);
/// Point of the segment a-b at the place `along`, 0..1.
inline PlanePoint between(const PlanePoint& a, const PlanePoint& b, double along) {
  return {a[0] + along * (b[0] - a[0]), a[1] + along * (b[1] - a[1])};
}
/// Point of the segment a-b nearest to p.
inline PlanePoint nearest_on(const PlanePoint& a, const PlanePoint& b, const PlanePoint& p) {
  return between(a, b, std::clamp(foot_on(a, b, p).along, 0.0, 1.0));
}
/// Whether the ray from p along +x crosses the segment a-b. Of a polygon that holds p it crosses an odd number, of its
/// holes' edges and its own together.
inline bool ray_crosses(const PlanePoint& a, const PlanePoint& b, const PlanePoint& p) {
  return (a[1] > p[1]) != (b[1] > p[1]) && p[0] < a[0] + (p[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]);
}
/// "(12.5, -3)" for messages.
std::string plane_place(const PlanePoint& p);

using Edge = std::pair<int, int>;  ///< two vertices, the smaller number first
inline Edge edge_of(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

/// The section of one extrude: a logical quad, meshed in rows, or any outline with holes, meshed free.
struct Section {
  const Extrude* extrude = nullptr;
  /// Closed loops of vertices, with those that neighbours put on them; the section lies left of each: its outline,
  /// counter-clockwise (x right, z up), then its holes, clockwise.
  std::vector<std::vector<int>> loops;
  bool free = false;  ///< no logical quad, or not to be meshed as one: corners, divisions and deck_side have no meaning
  std::array<int, 4>
      corners{};  ///< vertices, counter-clockwise; the side from corners[0] to corners[1] faces down most
  std::array<int, 4> divisions{};  ///< asked for side k, corners[k] to corners[k + 1]; 0: by size
  std::array<int, 4> deck_side{};  ///< number of side k in the deck, from 1

  const std::vector<int>& outline() const { return loops.front(); }
  /// Whether free triangles become three quads each, which halves every edge of the section.
  bool halves_edges() const { return free && extrude->shape == Shape::hex8; }
  /// Vertices from corner 0 to 1 (k = 0), 1 to 2 (k = 1), 3 to 2 (k = 2), 0 to 3 (k = 3): opposite sides, 0 and 2, 1
  /// and 3, run in the same direction.
  std::vector<int> side(int k) const;
};

struct SectionGraph {
  std::vector<PlanePoint> points;
  std::vector<Section> sections;  ///< parallel to the extrudes

  /// Calls visit(a, b) for every edge of a section, the section on its left.
  template <class Visit>
  static void for_each_edge(const Section& section, Visit visit) {
    for (const auto& loop : section.loops)
      for (std::size_t i = 0; i < loop.size(); ++i) visit(loop[i], loop[(i + 1) % loop.size()]);
  }

  /// Puts a vertex on the edge between vertices a and b of every section that has this edge.
  void insert_on_edge(int a, int b, int vertex);
};

/// Lengths below this count as zero in the plane of the sections, m: a millionth of their extent.
double section_tolerance(const std::vector<Extrude>& extrudes);
/// Whether the extrusions share a range of y, or at least a plane.
bool touch_along_y(const Extrude& a, const Extrude& b, double tolerance);

/// Throws DeckError: outlines that are degenerate, cross themselves, overlap one another or nearly touch; holes that do
/// not lie inside their section; divisions or corners of a section that is no logical quad.
SectionGraph join_sections(const std::vector<Extrude>& extrudes);

}  // namespace ashlar
