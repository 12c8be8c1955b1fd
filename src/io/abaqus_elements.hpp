#pragma once
#include <vector>

#include "model/mesh.hpp"

namespace ashlar {

/// Corners of the faces S1, S2, ... (Abaqus and CalculiX manuals, three-dimensional solid elements).
inline std::vector<std::vector<int>> abaqus_faces(Shape shape) {
  if (shape == Shape::hex8) return {{0, 1, 2, 3}, {4, 7, 6, 5}, {0, 4, 5, 1}, {1, 5, 6, 2}, {2, 6, 7, 3}, {3, 7, 4, 0}};
  if (shape == Shape::wedge6) return {{0, 1, 2}, {3, 5, 4}, {0, 3, 4, 1}, {1, 4, 5, 2}, {2, 5, 3, 0}};
  return {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}};
}

/// Face number `label` (S1 is 0) of Abaqus as a face of Shape; -1 if there is none.
int abaqus_face(Shape shape, int label);

}  // namespace ashlar
