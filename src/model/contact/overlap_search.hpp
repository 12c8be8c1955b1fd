#pragma once
#include <array>
#include <span>
#include <vector>

#include "base/tensor.hpp"

/// Geometry behind contacts of facets that do not share their corners (CGAL).
namespace ashlar {

/// A box along the axes, m.
struct Box3 {
  Vec3<double> low, high;
};

/// Which boxes of `a` meet which of `b`, as index pairs in ascending order.
std::vector<std::array<int, 2>> meeting_boxes(std::span<const Box3> a, std::span<const Box3> b);

using Point2 = std::array<double, 2>;

/// What two convex polygons share, counter-clockwise as they are; empty if nothing. Sides of edges are decided exactly,
/// corners are rounded.
std::vector<Point2> convex_overlap(std::span<const Point2> p, std::span<const Point2> q);

}  // namespace ashlar
