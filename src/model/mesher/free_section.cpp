#include <algorithm>
#include <cmath>
#include <map>

#include "model/mesher/extrude.hpp"
#include "model/mesher/triangulate.hpp"

namespace ashlar {

namespace {

/// Every point of a loop of edges, in the loop's direction.
std::vector<PlanePoint> divided_loop(const std::vector<int>& loop, const EdgePoints& edges) {
  std::vector<PlanePoint> points;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const int a = loop[i], b = loop[(i + 1) % loop.size()];
    auto piece = edges.at(edge_of(a, b));
    if (a > b) std::reverse(piece.begin(), piece.end());
    points.insert(points.end(), piece.begin(), piece.end() - 1);
  }
  return points;
}

/// Triangles that elements of these sizes make at the least, from sizes on a coarse raster over the section.
double expected_triangles(const std::vector<std::vector<PlanePoint>>& loops, const FreeSizes& sizes, int section) {
  PlanePoint low = loops[0][0], high = low;
  for (const auto& p : loops[0])
    for (int a = 0; a < 2; ++a) {
      low[a] = std::min(low[a], p[a]);
      high[a] = std::max(high[a], p[a]);
    }
  double area = 0, raster_area = 0, triangles = 0;
  for (const auto& loop : loops) area += 0.5 * twice_area(loop);
  constexpr int n = 32;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const PlanePoint p{low[0] + (i + 0.5) / n * (high[0] - low[0]), low[1] + (j + 0.5) / n * (high[1] - low[1])};
      const double size = sizes.at(section, p);
      raster_area += 1;
      triangles += 1 / (0.5 * size * size);
    }
  return area * triangles / raster_area;
}

/// 1 in an equilateral triangle, 0 in a flat one, negative in one that is turned over.
double shape_quality(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) {
  const double ab = distance(a, b), bc = distance(b, c), ca = distance(c, a);
  return 2 * std::sqrt(3.0) * turn(a, b, c) / (ab * ab + bc * bc + ca * ca);
}

/// Moves inner points to the middle of their neighbours wherever that betters the worst triangle around them.
void smooth(Triangulated& mesh, int fixed_points) {
  const int n = static_cast<int>(mesh.points.size());
  std::vector<std::vector<int>> around(n);  // triangles of each point
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t)
    for (const int p : mesh.triangles[t]) around[p].push_back(t);
  const auto worst = [&](int p) {
    double quality = 1;
    for (const int t : around[p]) {
      const auto& [a, b, c] = mesh.triangles[t];
      quality = std::min(quality, shape_quality(mesh.points[a], mesh.points[b], mesh.points[c]));
    }
    return quality;
  };
  constexpr int sweeps = 8;
  for (int sweep = 0; sweep < sweeps; ++sweep)
    for (int p = fixed_points; p < n; ++p) {
      PlanePoint middle{0, 0};
      for (const int t : around[p])
        for (const int q : mesh.triangles[t])
          if (q != p)
            for (int a = 0; a < 2; ++a) middle[a] += mesh.points[q][a] / (2.0 * static_cast<double>(around[p].size()));
      const auto before = mesh.points[p];
      const double quality = worst(p);
      mesh.points[p] = middle;
      if (!(worst(p) > quality)) mesh.points[p] = before;
    }
}

/// Three quads a triangle: corner, middle of an edge, centroid, middle of another edge.
SectionCells split_into_quads(const Triangulated& mesh, const std::map<Edge, PlanePoint>& boundary_middles) {
  SectionCells quads{mesh.points, {}};
  std::map<Edge, int> middles;
  const auto middle = [&](int a, int b) {
    const auto [at, added] = middles.try_emplace(edge_of(a, b), static_cast<int>(quads.points.size()));
    if (added) {
      const auto given = boundary_middles.find(at->first);
      quads.points.push_back(given != boundary_middles.end() ? given->second
                                                             : between(mesh.points[a], mesh.points[b], 0.5));
    }
    return at->second;
  };
  for (const auto& [a, b, c] : mesh.triangles) {
    const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a), centre = static_cast<int>(quads.points.size());
    quads.points.push_back({(mesh.points[a][0] + mesh.points[b][0] + mesh.points[c][0]) / 3,
                            (mesh.points[a][1] + mesh.points[b][1] + mesh.points[c][1]) / 3});
    quads.cells.push_back({a, ab, centre, ca});
    quads.cells.push_back({b, bc, centre, ab});
    quads.cells.push_back({c, ca, centre, bc});
  }
  return quads;
}

}  // namespace

SectionCells fill_free_section(const SectionGraph& graph, int number, const EdgePoints& edges, const FreeSizes& sizes,
                               int layers) {
  const auto& section = graph.sections[number];
  const bool quads = section.halves_edges();
  std::vector<std::vector<PlanePoint>> loops;
  for (const auto& loop : section.loops) loops.push_back(divided_loop(loop, edges));
  const double cells = expected_triangles(loops, sizes, number) * (quads ? 0.75 : 1);
  check_cell_count(section.extrude->where, "extrude '" + section.extrude->name + "'",
                   static_cast<int>(std::min(cells, 1e9)), layers, 1);

  // Triangles that are to become quads join every other point of the loops.
  std::map<Edge, PlanePoint> boundary_middles;
  int fixed_points = 0;
  for (auto& loop : loops) {
    if (quads) {
      std::vector<PlanePoint> coarse;
      const int n = static_cast<int>(loop.size()) / 2;
      for (int i = 0; i < n; ++i) {
        coarse.push_back(loop[2 * i]);
        boundary_middles[edge_of(fixed_points + i, fixed_points + (i + 1) % n)] = loop[2 * i + 1];
      }
      loop = coarse;
    }
    fixed_points += static_cast<int>(loop.size());
  }
  auto mesh = triangulate(loops, [&](const PlanePoint& p) { return (quads ? 2 : 1) * sizes.at(number, p); });
  smooth(mesh, fixed_points);
  if (quads) return split_into_quads(mesh, boundary_middles);
  SectionCells triangles{mesh.points, {}};
  for (const auto& [a, b, c] : mesh.triangles) triangles.cells.push_back({a, b, c, -1});
  return triangles;
}

}  // namespace ashlar
