#include <algorithm>
#include <cmath>
#include <set>

#include "model/mesher/extrude.hpp"

namespace ashlar {

namespace {

bool share_vertex(const Section& a, const Section& b) {
  const auto has = [](const Section& section, int v) {
    return std::any_of(section.loops.begin(), section.loops.end(),
                       [&](const auto& loop) { return std::find(loop.begin(), loop.end(), v) != loop.end(); });
  };
  return std::any_of(a.loops.begin(), a.loops.end(), [&](const auto& loop) {
    return std::any_of(loop.begin(), loop.end(), [&](int v) { return has(b, v); });
  });
}

/// Sections that touch, directly or through others: the first section of its group, for each.
std::vector<int> touching_groups(const SectionGraph& graph, double tolerance) {
  const int n = static_cast<int>(graph.sections.size());
  std::vector<int> group(n, -1);
  for (int s = 0; s < n; ++s) {
    if (group[s] >= 0) continue;
    std::vector<int> open{s};
    group[s] = s;
    while (!open.empty()) {
      const auto& here = graph.sections[open.back()];
      open.pop_back();
      for (int t = 0; t < n; ++t)
        if (group[t] < 0 && touch_along_y(*here.extrude, *graph.sections[t].extrude, tolerance) &&
            share_vertex(here, graph.sections[t])) {
          group[t] = s;
          open.push_back(t);
        }
    }
  }
  return group;
}

/// Layers that one extrude wants between two planes.
int layers_between(const Extrude& extrude, double from, double to) {
  if (extrude.layers > 0)
    return std::max(1, static_cast<int>(std::lround(extrude.layers * (to - from) / extrude.length)));
  const double size = extrude.layer_size > 0 ? extrude.layer_size : extrude.size;
  return static_cast<int>(std::clamp(std::ceil((to - from) / size - 0.05), 1.0, 1e6));
}

/// Planes of all extrudes of one group, ascending.
std::vector<double> planes_of_group(const std::vector<const Extrude*>& group, double tolerance) {
  std::vector<double> ends;
  for (const auto* extrude : group)
    for (const double y : {extrude->y0, extrude->y0 + extrude->length})
      if (std::none_of(ends.begin(), ends.end(), [&](double known) { return std::abs(known - y) <= tolerance; }))
        ends.push_back(y);
  std::sort(ends.begin(), ends.end());
  std::vector<double> planes;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    const double from = ends[i], to = ends[i + 1], middle = 0.5 * (from + to);
    int asked = 0, by_size = 0;
    for (const auto* extrude : group)
      if (extrude->y0 < middle && middle < extrude->y0 + extrude->length) {
        int& count = extrude->layers > 0 ? asked : by_size;
        count = std::max(count, layers_between(*extrude, from, to));
      }
    const int layers = asked > 0 ? asked : std::max(1, by_size);
    for (int k = 0; k < layers; ++k) planes.push_back(from + (to - from) * k / layers);
  }
  planes.push_back(ends.back());
  return planes;
}

}  // namespace

std::vector<std::vector<double>> layer_planes(const SectionGraph& graph) {
  double extent = 0;
  for (const auto& section : graph.sections)
    extent = std::max({extent, std::abs(section.extrude->y0), section.extrude->length});
  const double tolerance = 1e-6 * extent;
  const auto groups = touching_groups(graph, tolerance);
  std::vector<std::vector<double>> planes(graph.sections.size());
  for (const int first : std::set<int>(groups.begin(), groups.end())) {
    std::vector<const Extrude*> members;
    for (std::size_t s = 0; s < groups.size(); ++s)
      if (groups[s] == first) members.push_back(graph.sections[s].extrude);
    const auto all = planes_of_group(members, tolerance);
    for (std::size_t s = 0; s < groups.size(); ++s)
      if (groups[s] == first)
        for (const double y : all)
          if (y >= graph.sections[s].extrude->y0 - tolerance &&
              y <= graph.sections[s].extrude->y0 + graph.sections[s].extrude->length + tolerance)
            planes[s].push_back(y);
  }
  return planes;
}

}  // namespace ashlar
