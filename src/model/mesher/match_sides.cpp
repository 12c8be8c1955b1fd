#include <algorithm>
#include <cmath>

#include "model/mesher/strips.hpp"

namespace ashlar {

namespace {

/// Places by one coordinate; empty if it does not rise (or fall) steadily.
std::vector<double> places_by_axis(const std::vector<PlanePoint>& side, int axis) {
  const double from = side.front()[axis], span = side.back()[axis] - from;
  std::vector<double> places;
  for (const auto& p : side) {
    places.push_back((p[axis] - from) / span);
    if (places.size() > 1 && !(places.back() > places[places.size() - 2] + 1e-6)) return {};
  }
  places.back() = 1;
  return places;
}

std::vector<double> places_by_length(const std::vector<PlanePoint>& side) {
  std::vector<double> places{0};
  for (std::size_t i = 1; i < side.size(); ++i) places.push_back(places.back() + distance(side[i - 1], side[i]));
  for (double& place : places) place /= places.back();
  return places;
}

std::vector<PlanePoint> points_of(const SectionGraph& graph, const std::vector<int>& vertices) {
  std::vector<PlanePoint> points;
  for (const int v : vertices) points.push_back(graph.points[v]);
  return points;
}

int nearest_place(const std::vector<double>& places, double place) {
  int nearest = 0;
  for (int i = 1; i < static_cast<int>(places.size()); ++i)
    if (std::abs(places[i] - place) < std::abs(places[nearest] - place)) nearest = i;
  return nearest;
}

/// Whether vertex i of one side and some vertex of the other face each other.
bool has_partner(const std::vector<double>& own, const std::vector<double>& other, int i, double reach) {
  const int j = nearest_place(other, own[i]);
  const bool at_end = j == 0 || j + 1 == static_cast<int>(other.size());
  return !at_end && std::abs(other[j] - own[i]) <= reach && nearest_place(own, other[j]) == i;
}

/// The first vertex of `from` without a partner gets one on `onto`. Returns false if all have partners.
bool put_partner(SectionGraph& graph, const std::vector<double>& from, const std::vector<int>& onto_vertices,
                 const std::vector<double>& onto, double reach) {
  for (int i = 1; i + 1 < static_cast<int>(from.size()); ++i) {
    if (has_partner(from, onto, i, reach)) continue;
    const std::size_t after = std::upper_bound(onto.begin() + 1, onto.end() - 1, from[i]) - onto.begin();
    const double along = (from[i] - onto[after - 1]) / (onto[after] - onto[after - 1]);
    const int a = onto_vertices[after - 1], b = onto_vertices[after];
    const auto p = graph.points[a], q = graph.points[b];
    graph.points.push_back({p[0] + along * (q[0] - p[0]), p[1] + along * (q[1] - p[1])});
    graph.insert_on_edge(a, b, static_cast<int>(graph.points.size()) - 1);
    return true;
  }
  return false;
}

bool match_pair(SectionGraph& graph, int section, int side) {
  const auto a = graph.sections[section].side(side), b = graph.sections[section].side(side + 2);
  if (a.size() == 2 && b.size() == 2) return false;
  const auto a_points = points_of(graph, a), b_points = points_of(graph, b);
  const auto places = facing_places(a_points, b_points);
  const double length =
      std::max(distance(a_points.front(), a_points.back()), distance(b_points.front(), b_points.back()));
  const double reach = 0.5 * graph.sections[section].extrude->size / length;
  return put_partner(graph, places.a, b, places.b, reach) || put_partner(graph, places.b, a, places.a, reach);
}

}  // namespace

FacingPlaces facing_places(const std::vector<PlanePoint>& a, const std::vector<PlanePoint>& b) {
  PlanePoint direction{0, 0};
  for (const auto* side : {&a, &b})
    for (int axis = 0; axis < 2; ++axis)
      direction[axis] += (side->back()[axis] - side->front()[axis]) / distance(side->front(), side->back());
  const int axis = std::abs(direction[0]) > std::abs(direction[1]) ? 0 : 1;
  FacingPlaces places{places_by_axis(a, axis), places_by_axis(b, axis)};
  if (places.a.empty() || places.b.empty()) places = {places_by_length(a), places_by_length(b)};
  return places;
}

void match_opposite_sides(SectionGraph& graph) {
  const std::size_t limit = 200 + 20 * graph.points.size();
  bool changed = true;
  while (changed) {
    changed = false;
    for (int s = 0; s < static_cast<int>(graph.sections.size()); ++s)
      for (int side = 0; side < 2 && !graph.sections[s].free; ++side)
        while (match_pair(graph, s, side)) {
          changed = true;
          if (graph.points.size() > limit)
            throw DeckError(graph.sections[s].extrude->where,
                            "extrude '" + graph.sections[s].extrude->name +
                                "': the rows of this section and its neighbours never close; name the corners of the "
                                "sections, corners = {i, j, k, l}, so that rows run straight through");
        }
  }
}

}  // namespace ashlar
