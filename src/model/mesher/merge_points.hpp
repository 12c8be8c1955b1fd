#pragma once
#include <utility>
#include <vector>

#include "base/tensor.hpp"

namespace ashlar {

/// Points of several meshes after coincident ones have become one node.
struct MergedPoints {
  std::vector<int> node;                      ///< [points given] node of each point
  std::vector<Vec3<double>> points;           ///< [nodes], m; in the order of the first point of each node
  std::vector<std::pair<int, int>> repeated;  ///< points of one source at the same place: not merged
};

/// Merges points of different sources within a billionth of their extent. The first of them gives its coordinates.
/// @param source [points] which mesh each point comes from. Points that are not finite stay alone.
MergedPoints merge_points(const std::vector<Vec3<double>>& points, const std::vector<int>& source);

}  // namespace ashlar
