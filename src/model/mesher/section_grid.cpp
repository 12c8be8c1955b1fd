#include <algorithm>

#include "model/mesher/extrude.hpp"

namespace ashlar {

namespace {

std::vector<PlanePoint> divided_side(const Section& section, int side, const EdgePoints& edges) {
  const auto vertices = section.side(side);
  std::vector<PlanePoint> points;
  for (std::size_t i = 0; i + 1 < vertices.size(); ++i) {
    const int a = vertices[i], b = vertices[i + 1];
    auto piece = edges.at({std::min(a, b), std::max(a, b)});
    if (a > b) std::reverse(piece.begin(), piece.end());
    points.insert(points.end(), piece.begin() + (i > 0), piece.end());
  }
  return points;
}

std::vector<double> mean_places(const std::vector<PlanePoint>& a, const std::vector<PlanePoint>& b) {
  const auto places = facing_places(a, b);
  std::vector<double> mean(places.a.size());
  for (std::size_t i = 0; i < mean.size(); ++i) mean[i] = 0.5 * (places.a[i] + places.b[i]);
  return mean;
}

void check_cells(const SectionGraph& graph, const Section& section, const SectionGrid& grid) {
  const auto at = [&](int i, int j) { return grid.points[j * (grid.columns + 1) + i]; };
  for (int j = 0; j < grid.rows; ++j)
    for (int i = 0; i < grid.columns; ++i) {
      const std::array<PlanePoint, 4> cell{at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)};
      for (int k = 0; k < 4; ++k) {
        const auto &before = cell[(k + 3) % 4], &corner = cell[k], &after = cell[(k + 1) % 4];
        if (turn(before, corner, after) > 1e-6 * distance(before, corner) * distance(corner, after)) continue;
        std::string corners;
        for (const int v : section.corners) corners += (corners.empty() ? "" : ", ") + plane_place(graph.points[v]);
        throw DeckError(section.extrude->where,
                        "extrude '" + section.extrude->name + "': the grid between the corners " + corners +
                            " folds at " + plane_place(corner) +
                            "; the outline is no logical quad with these corners: name others, corners = {i, j, k, l}, "
                            "divide the section into several extrudes that share edges, or mesh it free of rows, "
                            "structured = false");
      }
    }
}

}  // namespace

SectionGrid fill_section(const SectionGraph& graph, const Section& section, const EdgePoints& edges) {
  const auto bottom = divided_side(section, 0, edges), right = divided_side(section, 1, edges);
  const auto top = divided_side(section, 2, edges), left = divided_side(section, 3, edges);
  const auto us = mean_places(bottom, top), vs = mean_places(left, right);
  SectionGrid grid{static_cast<int>(bottom.size()) - 1, static_cast<int>(left.size()) - 1, {}};
  check_cell_count(section.extrude->where, "extrude '" + section.extrude->name + "'", grid.columns, 1, grid.rows);
  for (int j = 0; j <= grid.rows; ++j)
    for (int i = 0; i <= grid.columns; ++i) {
      const double u = us[i], v = vs[j];
      PlanePoint p;
      // Gordon and Hall (1973): the two ruled surfaces less the one between the corners.
      for (int a = 0; a < 2; ++a)
        p[a] = (1 - v) * bottom[i][a] + v * top[i][a] + (1 - u) * left[j][a] + u * right[j][a] -
               ((1 - v) * ((1 - u) * bottom.front()[a] + u * bottom.back()[a]) +
                v * ((1 - u) * top.front()[a] + u * top.back()[a]));
      // Points of the sides are those of the neighbour, bit for bit.
      if (j == 0) p = bottom[i];
      if (j == grid.rows) p = top[i];
      if (i == 0) p = left[j];
      if (i == grid.columns) p = right[j];
      grid.points.push_back(p);
    }
  check_cells(graph, section, grid);
  return grid;
}

}  // namespace ashlar
