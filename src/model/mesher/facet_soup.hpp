#pragma once
#include <string>
#include <vector>

#include "base/tensor.hpp"

namespace ashlar {

/// Facets as a file gives them.
struct FacetSoup {
  std::vector<Vec3<double>> points;
  std::vector<std::vector<long>> facets;  ///< corners, from 0
};

/// Reads .stl, .obj or .ply by CGAL, which believes what a header announces; no facets if that fails.
FacetSoup read_facet_soup(const std::string& path);

}  // namespace ashlar
