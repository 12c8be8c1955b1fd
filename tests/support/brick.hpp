#pragma once
#include <array>
#include <functional>

#include "model/mesh.hpp"

namespace ashlar {

/// Grid of nx x ny x nz cells over the unit cube, moved by `place`; every cell is a hex8, two wedge6 or six tet4 that
/// share the diagonal 0-6. One region "body"; the outer faces lie in the surfaces left right front back bottom top.
inline Mesh brick(std::array<int, 3> cells, const std::function<Vec3<double>(const Vec3<double>&)>& place,
                  Shape shape = Shape::hex8) {
  Mesh mesh;
  mesh.region_names = {"body"};
  const auto [nx, ny, nz] = cells;
  std::vector<Vec3<double>> unit;
  for (int k = 0; k <= nz; ++k)
    for (int j = 0; j <= ny; ++j)
      for (int i = 0; i <= nx; ++i) unit.push_back({double(i) / nx, double(j) / ny, double(k) / nz});
  for (const auto& p : unit) mesh.points.push_back(place(p));
  const std::vector<std::vector<int>> split =
      shape == Shape::hex8     ? std::vector<std::vector<int>>{{0, 1, 2, 3, 4, 5, 6, 7}}
      : shape == Shape::wedge6 ? std::vector<std::vector<int>>{{0, 1, 2, 4, 5, 6}, {0, 2, 3, 4, 6, 7}}
                               : std::vector<std::vector<int>>{{0, 1, 2, 6}, {0, 2, 3, 6}, {0, 3, 7, 6},
                                                               {0, 7, 4, 6}, {0, 4, 5, 6}, {0, 5, 1, 6}};
  const auto node = [nx = nx, ny = ny](int i, int j, int k) { return (k * (ny + 1) + j) * (nx + 1) + i; };
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i) {
        const int cell[8] = {
            node(i, j, k),     node(i + 1, j, k),     node(i + 1, j + 1, k),     node(i, j + 1, k),
            node(i, j, k + 1), node(i + 1, j, k + 1), node(i + 1, j + 1, k + 1), node(i, j + 1, k + 1)};
        for (const auto& local : split) {
          std::vector<int> nodes;
          for (const int l : local) nodes.push_back(cell[l]);
          mesh.add_element(shape, nodes, 0, mesh.element_count() + 1);
        }
      }
  const char* names[6] = {"left", "right", "front", "back", "bottom", "top"};
  for (int side = 0; side < 6; ++side) mesh.surfaces.push_back({names[side], {}});
  for (const Facet& facet : find_faces(mesh).outer)
    for (int side = 0; side < 6; ++side) {
      bool on = true;
      for (const int n : mesh.facet_nodes(facet)) on = on && unit[n][side / 2] == side % 2;
      if (on) mesh.surfaces[side].facets.push_back(facet);
    }
  return mesh;
}

/// A box from the origin.
inline Mesh brick(std::array<int, 3> cells, const Vec3<double>& size, Shape shape = Shape::hex8) {
  return brick(
      cells,
      [size](const Vec3<double>& p) {
        return Vec3<double>{size.x * p.x, size.y * p.y, size.z * p.z};
      },
      shape);
}

}  // namespace ashlar
