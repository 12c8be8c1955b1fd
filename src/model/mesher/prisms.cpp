#include "model/mesher/prisms.hpp"

#include <algorithm>

namespace ashlar {

namespace {

using Wedge = std::array<int, 6>;

/// Three tetrahedra: the smallest node is joined to the two faces that do not hold it, the quad cut from its own
/// smallest node. The quads that hold it are thereby cut from it too.
void add_tetrahedra(Mesh& mesh, const Wedge& w, int region, long& source_id) {
  const int apex = *std::min_element(w.begin(), w.end());
  const auto add = [&](int a, int b, int c) {
    mesh.add_element(Shape::tet4, std::array{a, c, b, apex}, region, ++source_id);
  };
  for (int f = 0; f < face_count(Shape::wedge6); ++f) {
    std::vector<int> face;
    for (const int corner : face_corners(Shape::wedge6, f)) face.push_back(w[corner]);
    if (std::find(face.begin(), face.end(), apex) != face.end()) continue;
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
    add(face[0], face[1], face[2]);
    if (face.size() == 4) add(face[0], face[2], face[3]);
  }
}

}  // namespace

void add_cells(Mesh& mesh, const Prisms& prisms, const std::vector<int>& node, int region) {
  long source_id = 0;
  for (int layer = 0; layer < prisms.layers; ++layer)
    for (const auto& cell : prisms.cells) {
      const auto at = [&](int corner, int plane) {
        return node[(layer + plane) * prisms.section_points + cell[corner]];
      };
      // Counter-clockwise in x-z is clockwise seen from +y, where the extrusion goes: corners run backwards.
      if (cell[3] >= 0) {
        mesh.add_element(Shape::hex8,
                         std::array{at(0, 0), at(3, 0), at(2, 0), at(1, 0), at(0, 1), at(3, 1), at(2, 1), at(1, 1)},
                         region, ++source_id);
        continue;
      }
      const Wedge wedge{at(0, 0), at(2, 0), at(1, 0), at(0, 1), at(2, 1), at(1, 1)};
      if (prisms.shape == Shape::tet4)
        add_tetrahedra(mesh, wedge, region, source_id);
      else
        mesh.add_element(Shape::wedge6, wedge, region, ++source_id);
    }
}

}  // namespace ashlar
