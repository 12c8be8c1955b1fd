#pragma once
#include <array>
#include <string>
#include <vector>

#include "model/model.hpp"

/// Small models built by hand.
namespace ashlar::test {

/// nx * ny * nz unit cubes as hex8, x fastest. `regions`: one name per element in that order; empty: one region "body".
inline Mesh grid(int nx, int ny, int nz, const std::vector<std::string>& regions = {}) {
  Mesh mesh;
  for (int k = 0; k <= nz; ++k)
    for (int j = 0; j <= ny; ++j)
      for (int i = 0; i <= nx; ++i) mesh.points.push_back({double(i), double(j), double(k)});
  const auto node = [&](int i, int j, int k) { return (k * (ny + 1) + j) * (nx + 1) + i; };
  int element = 0;
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i, ++element) {
        const std::string region = regions.empty() ? "body" : regions[element];
        if (mesh.find_region(region) < 0) mesh.region_names.push_back(region);
        const std::array nodes{
            node(i, j, k),     node(i + 1, j, k),     node(i + 1, j + 1, k),     node(i, j + 1, k),
            node(i, j, k + 1), node(i + 1, j, k + 1), node(i + 1, j + 1, k + 1), node(i, j + 1, k + 1)};
        mesh.add_element(Shape::hex8, nodes, mesh.find_region(region), element + 1);
      }
  return mesh;
}

/// A crackable 'body' or a joint 'seam', elastic.
inline Interface interface_of(bool crackable, std::vector<std::string> regions) {
  return {crackable ? "body" : "seam", {}, crackable, std::move(regions), "elastic", {}};
}

inline Material elastic(std::vector<std::string> regions, double young, double poisson) {
  Material material;
  material.regions = std::move(regions);
  material.values = {{"young", young}, {"poisson", poisson}};
  return material;
}

}  // namespace ashlar::test
