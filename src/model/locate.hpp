#pragma once
#include <optional>
#include <vector>

#include "model/mesh.hpp"

namespace ashlar {

/// A point of the body as weights on corners, for reading fields off there.
struct Location {
  int element = -1;             ///< lowest element that contains the point
  std::vector<double> weights;  ///< shape functions at the element's corners
  int node = -1;                ///< the mesh node at this place, or -1
};

/// The element that contains `point`, by Newton's method on the isoparametric map; empty if the point is outside the
/// mesh.
std::optional<Location> locate(const Mesh& mesh, const Vec3<double>& point);

struct NodeInside {
  int node, element;
};
/// A node that lies well inside an element that is not its own, if there is one: bodies drawn into each other.
/// @param touching [regions * regions] below 0: never mind nodes of the one region in the other
std::optional<NodeInside> node_inside(const Mesh& mesh, const std::vector<int>& touching);

/// Mesh node nearest to a point.
int nearest_node(const Mesh& mesh, const Vec3<double>& point);

}  // namespace ashlar
