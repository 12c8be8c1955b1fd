#pragma once
#include <array>
#include <cmath>
#include <string>
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
/// "(12.5, -3)" for messages.
std::string plane_place(const PlanePoint& p);

/// A logical quad: an outline with four corners.
struct Section {
  const Extrude* extrude = nullptr;
  std::vector<int> outline;  ///< vertices, counter-clockwise (x right, z up), with those that neighbours put on it
  std::array<int, 4>
      corners{};  ///< vertices, counter-clockwise; the side from corners[0] to corners[1] faces down most
  std::array<int, 4> divisions{};  ///< asked for side k, corners[k] to corners[k + 1]; 0: by size
  std::array<int, 4> deck_side{};  ///< number of side k in the deck, from 1

  /// Vertices from corner 0 to 1 (k = 0), 1 to 2 (k = 1), 3 to 2 (k = 2), 0 to 3 (k = 3): opposite sides, 0 and 2, 1
  /// and 3, run in the same direction.
  std::vector<int> side(int k) const;
};

struct SectionGraph {
  std::vector<PlanePoint> points;
  std::vector<Section> sections;  ///< parallel to the extrudes

  /// Puts a vertex on the edge between vertices a and b of every section that has this edge.
  void insert_on_edge(int a, int b, int vertex);
};

/// Lengths below this count as zero in the plane of the sections, m: a millionth of their extent.
double section_tolerance(const std::vector<Extrude>& extrudes);
/// Whether the extrusions share a range of y, or at least a plane.
bool touch_along_y(const Extrude& a, const Extrude& b, double tolerance);

/// Throws DeckError: outlines that are degenerate, cross themselves, overlap one another or nearly touch; sections that
/// are no logical quads.
SectionGraph join_sections(const std::vector<Extrude>& extrudes);

}  // namespace ashlar
