#include "model/mesher/section_graph.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "model/mesher/section_checks.hpp"

namespace ashlar {

std::string plane_place(const PlanePoint& p) {
  char text[64];
  std::snprintf(text, sizeof text, "(%.6g, %.6g)", p[0], p[1]);
  return text;
}

double twice_area(const std::vector<PlanePoint>& loop) {
  double sum = 0;
  for (std::size_t i = 1; i + 1 < loop.size(); ++i) sum += turn(loop[0], loop[i], loop[i + 1]);
  return sum;
}

double section_tolerance(const std::vector<Extrude>& extrudes) {
  PlanePoint low{HUGE_VAL, HUGE_VAL}, high{-HUGE_VAL, -HUGE_VAL};
  for (const auto& extrude : extrudes)
    for (const auto& p : extrude.section)
      for (int a = 0; a < 2; ++a) {
        low[a] = std::min(low[a], p[a]);
        high[a] = std::max(high[a], p[a]);
      }
  return 1e-6 * distance(low, high);
}

Foot foot_on(const PlanePoint& a, const PlanePoint& b, const PlanePoint& p) {
  const double length = distance(a, b);
  const double along = ((p[0] - a[0]) * (b[0] - a[0]) + (p[1] - a[1]) * (b[1] - a[1])) / (length * length);
  return {along, std::abs(turn(a, b, p)) / length};
}

bool touch_along_y(const Extrude& a, const Extrude& b, double tolerance) {
  return a.y0 <= b.y0 + b.length + tolerance && b.y0 <= a.y0 + a.length + tolerance;
}

std::vector<int> Section::side(int k) const {
  const bool forward = k < 2;
  const int from = corners[k], to = corners[(k + 1) % 4];
  const auto& around = outline();
  const std::size_t n = around.size();
  std::size_t at = std::find(around.begin(), around.end(), from) - around.begin();
  std::vector<int> vertices{from};
  while (around[at] != to) {
    at = (at + 1) % n;
    vertices.push_back(around[at]);
  }
  if (!forward) std::reverse(vertices.begin(), vertices.end());
  return vertices;
}

void SectionGraph::insert_on_edge(int a, int b, int vertex) {
  for (auto& section : sections)
    for (auto& loop : section.loops)
      for (std::size_t i = 0; i < loop.size(); ++i)
        if (edge_of(loop[i], loop[(i + 1) % loop.size()]) == edge_of(a, b)) {
          loop.insert(loop.begin() + static_cast<long>(i) + 1, vertex);
          break;
        }
}

namespace {

class Joining {
 public:
  explicit Joining(const std::vector<Extrude>& extrudes)
      : extrudes_(extrudes), tolerance_(section_tolerance(extrudes)) {}

  SectionGraph run() {
    for (const auto& extrude : extrudes_) check_outline(extrude, tolerance_);
    for (const auto& extrude : extrudes_) add_section(extrude);
    share_edges();
    check_overlaps(graph_, tolerance_);
    return std::move(graph_);
  }

 private:
  int vertex_at(const PlanePoint& p) {
    for (std::size_t v = 0; v < graph_.points.size(); ++v)
      if (distance(graph_.points[v], p) <= tolerance_) return static_cast<int>(v);
    graph_.points.push_back(p);
    return static_cast<int>(graph_.points.size()) - 1;
  }

  void add_section(const Extrude& extrude) {
    Section section;
    section.extrude = &extrude;
    const bool clockwise = twice_area(extrude.section) < 0;
    const auto vertices = vertices_at(extrude.section);  // in the deck's order
    section.loops.push_back(turned(vertices, clockwise));
    for (const auto& hole : extrude.holes) section.loops.push_back(turned(vertices_at(hole), twice_area(hole) > 0));

    const auto chosen = choose_corners(extrude);
    section.free = !chosen;
    if (chosen) choose_sides(section, *chosen, vertices, clockwise);
    graph_.sections.push_back(section);
  }

  std::vector<int> vertices_at(const std::vector<PlanePoint>& points) {
    std::vector<int> vertices;
    for (const auto& p : points) vertices.push_back(vertex_at(p));
    return vertices;
  }
  static std::vector<int> turned(std::vector<int> vertices, bool turn) {
    if (turn) std::reverse(vertices.begin(), vertices.end());
    return vertices;
  }

  void choose_sides(Section& section, const std::array<int, 4>& chosen, const std::vector<int>& vertices,
                    bool clockwise) {
    const Extrude& extrude = *section.extrude;
    std::array<int, 4> deck;
    for (int k = 0; k < 4; ++k) deck[k] = vertices[chosen[k]];
    // Corner 0 is chosen so that the first side faces down most: its direction, counter-clockwise, is along +x.
    const auto downward = [&](int k) {
      const int from = clockwise ? deck[(k + 1) % 4] : deck[k], to = clockwise ? deck[k] : deck[(k + 1) % 4];
      const auto &p = graph_.points[from], &q = graph_.points[to];
      return (q[0] - p[0]) / distance(p, q);
    };
    int first = 0;
    for (int k = 1; k < 4; ++k)
      if (downward(k) > downward(first) + 1e-9) first = k;
    for (int k = 0; k < 4; ++k) {
      const int deck_side = clockwise ? (first - k + 4) % 4 : (first + k) % 4;
      section.corners[k] = clockwise ? deck[(deck_side + 1) % 4] : deck[deck_side];
      section.deck_side[k] = deck_side + 1;
      const auto asked = extrude.divisions.find(deck_side + 1);
      section.divisions[k] = asked == extrude.divisions.end() ? 0 : asked->second;
    }
  }

  /// Vertices of one section that lie on an edge of another become vertices of both; those that nearly do are errors.
  void share_edges() {
    Complaints complaints;
    for (std::size_t s = 0; s < graph_.sections.size(); ++s) {
      std::vector<int> vertices;
      for (const auto& loop : graph_.sections[s].loops) vertices.insert(vertices.end(), loop.begin(), loop.end());
      for (std::size_t t = 0; t < graph_.sections.size(); ++t) {
        const Extrude &own = *graph_.sections[s].extrude, &other = *graph_.sections[t].extrude;
        if (s == t || !touch_along_y(own, other, tolerance_)) continue;
        for (const int v : vertices) share_vertex(v, own, static_cast<int>(t), complaints);
      }
    }
    complaints.raise();
  }

  void share_vertex(int v, const Extrude& own, int t, Complaints& complaints) {
    std::vector<std::pair<int, int>> edges;
    SectionGraph::for_each_edge(graph_.sections[t], [&](int a, int b) { edges.push_back({a, b}); });
    if (std::any_of(edges.begin(), edges.end(), [&](const auto& edge) { return edge.first == v; })) return;
    const Extrude& other = *graph_.sections[t].extrude;
    const double near = 0.01 * std::min(own.size, other.size);
    const auto& p = graph_.points[v];
    for (const auto& [a, b] : edges) {
      const auto foot = foot_on(graph_.points[a], graph_.points[b], p);
      const double to_corner = distance(graph_.points[a], p);
      const bool beside = foot.along > 0 && foot.along < 1;
      if (beside && foot.off <= tolerance_) {
        graph_.insert_on_edge(a, b, v);
        return;
      }
      if ((beside && foot.off < near) || to_corner < near) {
        char gap[32];
        std::snprintf(gap, sizeof gap, "%.3g", beside ? std::min(foot.off, to_corner) : to_corner);
        complaints.add(own.where, "extrude '" + own.name + "': its point " + plane_place(p) + " lies " + gap +
                                      " m beside the outline of '" + other.name +
                                      "'; sections that touch must share the point: give both the same one");
        return;
      }
    }
  }

  const std::vector<Extrude>& extrudes_;
  double tolerance_;
  SectionGraph graph_;
};

}  // namespace

SectionGraph join_sections(const std::vector<Extrude>& extrudes) { return Joining(extrudes).run(); }

}  // namespace ashlar
