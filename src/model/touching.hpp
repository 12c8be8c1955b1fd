#pragma once
#include <vector>

#include "model/mesh.hpp"

namespace ashlar {

/// Outer faces whose centroid lies on another outer face that looks the other way: bodies that touch there without
/// sharing nodes, so nothing holds them together. First is the face whose centroid it is. In the order of
/// `faces.outer`.
std::vector<FacePair> find_touching(const Mesh& mesh, const FaceGraph& faces);

}  // namespace ashlar
