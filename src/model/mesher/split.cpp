#include <algorithm>
#include <tuple>

#include "model/mesher/lattice.hpp"

namespace ashlar {

namespace {

using Hex = std::array<int, 8>;

/// Corners of the hex turned so that its first face lies in the x-z plane, seen from +y, starting at corner `start`.
Hex turned_to_section(const Hex& h, int start) {
  constexpr int front[4] = {0, 4, 5, 1}, back[4] = {3, 7, 6, 2};
  Hex turned;
  for (int i = 0; i < 4; ++i) {
    turned[i] = h[front[(i + start) % 4]];
    turned[i + 4] = h[back[(i + start) % 4]];
  }
  return turned;
}

/// The shorter diagonal of the section's quad; of two equal ones that through the smallest point (x, then z), so that
/// sections that lie one behind the other are cut alike whatever their node numbers.
int diagonal_start(const Mesh& mesh, const Hex& h) {
  const Hex t = turned_to_section(h, 0);
  const auto length = [&](int a, int b) { return norm(mesh.points[t[a]] - mesh.points[t[b]]); };
  const double first = length(0, 2), second = length(1, 3);
  if (std::abs(first - second) > 1e-9 * (first + second)) return first < second ? 0 : 1;
  int smallest = 0;
  for (int i = 1; i < 4; ++i) {
    const auto &p = mesh.points[t[i]], &q = mesh.points[t[smallest]];
    if (std::tie(p.x, p.z) < std::tie(q.x, q.z)) smallest = i;
  }
  return smallest % 2;
}

void add_wedges(Mesh& mesh, const Hex& h, int region, long& source_id) {
  mesh.add_element(Shape::wedge6, std::array{h[0], h[1], h[2], h[4], h[5], h[6]}, region, ++source_id);
  mesh.add_element(Shape::wedge6, std::array{h[0], h[2], h[3], h[4], h[6], h[7]}, region, ++source_id);
}

/// Six tetrahedra: the smallest node is joined to the three faces that do not hold it, each cut from its own smallest
/// node. The faces that hold it are thereby cut from it too, so every face is cut from its smallest node.
void add_tetrahedra(Mesh& mesh, const Hex& h, int region, long& source_id) {
  const int apex = *std::min_element(h.begin(), h.end());
  for (int f = 0; f < 6; ++f) {
    std::array<int, 4> quad;
    for (int i = 0; i < 4; ++i) quad[i] = h[face_corners(Shape::hex8, f)[i]];
    if (std::find(quad.begin(), quad.end(), apex) != quad.end()) continue;
    std::rotate(quad.begin(), std::min_element(quad.begin(), quad.end()), quad.end());
    mesh.add_element(Shape::tet4, std::array{quad[0], quad[2], quad[1], apex}, region, ++source_id);
    mesh.add_element(Shape::tet4, std::array{quad[0], quad[3], quad[2], apex}, region, ++source_id);
  }
}

}  // namespace

void add_cells(Mesh& mesh, const Lattice& lattice, const std::vector<int>& node, int region) {
  long source_id = 0;
  for (int k = 0; k < lattice.nz; ++k)
    for (int j = 0; j < lattice.ny; ++j)
      for (int i = 0; i < lattice.nx; ++i) {
        Hex hex = lattice.cell(i, j, k);
        for (int& corner : hex) corner = node[corner];
        switch (lattice.shape) {
          case Shape::hex8: mesh.add_element(Shape::hex8, hex, region, ++source_id); break;
          case Shape::wedge6:
            if (lattice.wedges_along_y) hex = turned_to_section(hex, diagonal_start(mesh, hex));
            add_wedges(mesh, hex, region, source_id);
            break;
          case Shape::tet4: add_tetrahedra(mesh, hex, region, source_id); break;
        }
      }
}

}  // namespace ashlar
