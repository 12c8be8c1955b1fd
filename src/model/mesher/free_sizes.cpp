#include "model/mesher/free_sizes.hpp"

#include <algorithm>
#include <cmath>

#include "model/mesher/section_gaps.hpp"

namespace ashlar {

namespace {

constexpr double usual_growth = 1.3;
constexpr double most_elements = 100000;  // along one edge

SizeField field_of(const Section& section, const std::vector<SizeAt>& places) {
  const auto& extrude = *section.extrude;
  return {places, (extrude.grow > 0 ? extrude.grow : usual_growth) - 1, extrude.size};
}

}  // namespace

std::vector<double> EdgeProfile::places(int n) const {
  std::vector<double> places{0};
  std::size_t at = 0;
  for (int k = 1; k < n; ++k) {
    const double wanted = natural_count() * k / n;
    while (counts_[at + 1].second < wanted) ++at;
    const auto& [place, count] = counts_[at];
    const auto& [next_place, next_count] = counts_[at + 1];
    places.push_back(place + (wanted - count) / (next_count - count) * (next_place - place));
  }
  places.push_back(1);
  return places;
}

EdgeProfile EdgeProfile::reversed() const {
  std::vector<std::pair<double, double>> counts;
  for (auto at = counts_.rbegin(); at != counts_.rend(); ++at)
    counts.push_back({1 - at->first, natural_count() - at->second});
  return EdgeProfile(std::move(counts));
}

FreeSizes::FreeSizes(const SectionGraph& graph) : graph_(graph), places_(graph.sections.size()) {
  for (int s = 0; s < static_cast<int>(graph.sections.size()); ++s) {
    const auto& section = graph.sections[s];
    if (!section.free) continue;
    SectionGraph::for_each_edge(section, [&](int a, int b) {
      owners_[edge_of(a, b)].push_back(s);
      at_vertex_[a].push_back(s);
    });
    places_[s] = sizes_of_shape(graph, section);
  }
  update();
}

void FreeSizes::update() {
  fields_.clear();
  for (std::size_t s = 0; s < graph_.sections.size(); ++s) fields_.push_back(field_of(graph_.sections[s], places_[s]));
}

bool FreeSizes::even(const Edge& edge) const {
  const auto& owners = owners_.at(edge);
  return std::any_of(owners.begin(), owners.end(), [&](int s) { return graph_.sections[s].halves_edges(); });
}

double FreeSizes::at(const Edge& edge, const PlanePoint& p) const {
  double size = HUGE_VAL;
  for (const int s : owners_.at(edge)) size = std::min(size, fields_[s].at(p));
  return size;
}

double FreeSizes::at_vertex(int vertex) const {
  const auto found = at_vertex_.find(vertex);
  double size = HUGE_VAL;
  if (found != at_vertex_.end())
    for (const int s : found->second) size = std::min(size, fields_[s].at(graph_.points[vertex]));
  return size;
}

EdgeProfile FreeSizes::profile(const Edge& edge, double largest) const {
  const auto &a = graph_.points[edge.first], &b = graph_.points[edge.second];
  const double length = distance(a, b);
  std::vector<std::pair<double, double>> counts{{0, 0}};
  double size = std::min(at(edge, a), largest);
  while (counts.back().first < 1) {
    const auto [place, count] = counts.back();
    const double next = std::min(1.0, place + 0.25 * size / length);
    const double next_size = std::min(at(edge, between(a, b, next)), largest);
    counts.push_back({next, count + (next - place) * length * 0.5 * (1 / size + 1 / next_size)});
    size = next_size;
    if (count > most_elements)
      throw DeckError(graph_.sections[owners_.at(edge).front()].extrude->where,
                      "the edge from " + plane_place(a) + " to " + plane_place(b) +
                          " would have more than 100000 elements; is 'size' in metres?");
  }
  return EdgeProfile(std::move(counts));
}

void FreeSizes::take(const Edge& edge, const std::vector<PlanePoint>& points) {
  for (const int s : owners_.at(edge))
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const double size = distance(points[i], points[i + 1]);
      for (const double along : {0.0, 0.5, 1.0}) places_[s].push_back({between(points[i], points[i + 1], along), size});
    }
}

std::vector<PlanePoint> FreeSizes::divide(const Edge& edge) const {
  const auto &a = graph_.points[edge.first], &b = graph_.points[edge.second];
  const auto elements = profile(edge);
  int n = std::max(1, static_cast<int>(std::ceil(elements.natural_count() - 0.05)));
  if (even(edge)) n += n % 2;
  const auto places = elements.places(n);
  std::vector<PlanePoint> points{a};
  for (int k = 1; k < n; ++k) points.push_back(between(a, b, places[k]));
  points.push_back(b);
  return points;
}

}  // namespace ashlar
