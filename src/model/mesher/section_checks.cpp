#include "model/mesher/section_checks.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <numeric>
#include <optional>

namespace ashlar {

namespace {

/// Whether the segments a-b and c-d cross at a point inside both.
bool cross_properly(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c, const PlanePoint& d,
                    double tolerance) {
  const auto apart = [&](const PlanePoint& p, const PlanePoint& q, const PlanePoint& r, const PlanePoint& s) {
    const double length = distance(p, q), first = turn(p, q, r) / length, second = turn(p, q, s) / length;
    return (first > tolerance && second < -tolerance) || (first < -tolerance && second > tolerance);
  };
  return apart(a, b, c, d) && apart(c, d, a, b);
}

double distance_to_segment(const PlanePoint& a, const PlanePoint& b, const PlanePoint& p) {
  return distance(nearest_on(a, b, p), p);
}

/// Whether two segments cross or come within the tolerance of each other.
bool touch(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c, const PlanePoint& d, double tolerance) {
  return cross_properly(a, b, c, d, tolerance) || distance_to_segment(a, b, c) <= tolerance ||
         distance_to_segment(a, b, d) <= tolerance || distance_to_segment(c, d, a) <= tolerance ||
         distance_to_segment(c, d, b) <= tolerance;
}

void check_numbers(const Extrude& extrude, Complaints& complaints) {
  const std::string name = "extrude '" + extrude.name + "': ";
  const auto positive = [&](const char* key, double value) {
    if (!std::isfinite(value) || value <= 0)
      complaints.add(extrude.where, name + "'" + key + "' must be greater than 0 m");
  };
  positive("length", extrude.length);
  positive("size", extrude.size);
  if (!std::isfinite(extrude.y0)) complaints.add(extrude.where, name + "its start along y is not finite");
  if (!std::isfinite(extrude.layer_size) || extrude.layer_size < 0 || extrude.layers < 0)
    complaints.add(extrude.where, name + "layers along y cannot be negative");
  if (extrude.hole_size != 0) positive("hole_size", extrude.hole_size);
  if (extrude.hole_size > extrude.size)
    complaints.add(extrude.where, name + "'hole_size' is the element size around holes, at most 'size'");
  if (extrude.grow != 0 && !(extrude.grow >= 1 && extrude.grow <= 2))
    complaints.add(extrude.where, name + "'grow' is the growth from one element to the next, from 1 to 2");
  for (const auto& [side, count] : extrude.divisions) {
    if (side < 1 || side > 4)
      complaints.add(extrude.where, name + "'divisions' of side " + std::to_string(side) +
                                        ": a section has sides 1 to 4, " +
                                        "side 1 from its first corner to its second");
    if (count < 1)
      complaints.add(extrude.where, name + "'divisions' of side " + std::to_string(side) + " must be 1 or more");
  }
}

using Loop = std::vector<PlanePoint>;

std::string numbered(const Loop& loop, std::size_t i) {
  return std::to_string(i % loop.size() + 1) + " " + plane_place(loop[i % loop.size()]);
}
std::string edge_text(const Loop& loop, std::size_t i) { return numbered(loop, i) + " - " + numbered(loop, i + 1); }

/// One outline by itself. @param what "the section" or "hole 2"
void check_loop(const Extrude& extrude, const Loop& loop, const std::string& what, double tolerance) {
  const std::string name = "extrude '" + extrude.name + "': ";
  const std::size_t n = loop.size();
  Complaints complaints;
  if (n < 3) complaints.add(extrude.where, name + what + " needs at least 3 points, got " + std::to_string(n));
  for (std::size_t i = 0; i < n; ++i)
    if (!std::isfinite(loop[i][0]) || !std::isfinite(loop[i][1]))
      complaints.add(extrude.where, name + "point " + std::to_string(i + 1) + " of " + what + " is not finite");
  complaints.raise();

  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j)
      if (distance(loop[i], loop[j]) <= tolerance)
        complaints.add(extrude.where, name + "points " + numbered(loop, i) + " and " + numbered(loop, j) + " of " +
                                          what + " are the same; an outline closes by itself");
  complaints.raise();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j) {
      const auto &a = loop[i], &b = loop[(i + 1) % n], &c = loop[j], &d = loop[(j + 1) % n];
      const bool neighbours = j == i + 1 || (i == 0 && j == n - 1);
      const bool touches = neighbours ? distance_to_segment(a, b, j == i + 1 ? d : c) <= tolerance ||
                                            distance_to_segment(c, d, j == i + 1 ? a : b) <= tolerance
                                      : touch(a, b, c, d, tolerance);
      if (touches)
        complaints.add(extrude.where, name + "the outline of " + what + " crosses or touches itself: edge " +
                                          edge_text(loop, i) + " and edge " + edge_text(loop, j));
    }
  complaints.raise();
}

/// The first edges of two outlines that cross or touch, as text; empty if they are apart.
std::string where_they_touch(const Loop& p, const Loop& q, double tolerance) {
  for (std::size_t i = 0; i < p.size(); ++i)
    for (std::size_t j = 0; j < q.size(); ++j)
      if (touch(p[i], p[(i + 1) % p.size()], q[j], q[(j + 1) % q.size()], tolerance))
        return "edge " + edge_text(p, i) + " and edge " + edge_text(q, j);
  return "";
}

bool holds(const Loop& loop, const PlanePoint& p) {
  bool inside = false;
  for (std::size_t i = 0; i < loop.size(); ++i) inside ^= ray_crosses(loop[i], loop[(i + 1) % loop.size()], p);
  return inside;
}

void check_holes(const Extrude& extrude, double tolerance) {
  const std::string name = "extrude '" + extrude.name + "': ";
  Complaints complaints;
  for (std::size_t h = 0; h < extrude.holes.size(); ++h) {
    const auto& hole = extrude.holes[h];
    const std::string own = "hole " + std::to_string(h + 1);
    const auto at_outline = where_they_touch(hole, extrude.section, tolerance);
    if (!at_outline.empty())
      complaints.add(extrude.where, name + own + " crosses or touches the outline of the section: " + at_outline +
                                        "; leave material around it, or draw it as a notch of the section");
    else if (!holds(extrude.section, hole[0]))
      complaints.add(extrude.where, name + own + " at " + plane_place(hole[0]) + " lies outside the section");
    for (std::size_t g = 0; g < h; ++g) {
      const auto& other = extrude.holes[g];
      const auto place = where_they_touch(hole, other, tolerance);
      if (!place.empty() || holds(other, hole[0]) || holds(hole, other[0]))
        complaints.add(extrude.where, name + own + " and hole " + std::to_string(g + 1) +
                                          (place.empty() ? " lie one in the other" : " cross or touch: " + place) +
                                          "; holes must be apart");
    }
  }
  complaints.raise();
}

/// Why a section is meshed free whatever its corners; empty if its corners decide.
std::string reason_to_mesh_free(const Extrude& extrude) {
  return !extrude.structured ? "structured = false" : !extrude.holes.empty() ? "it has holes" : "";
}

/// Throws DeckError if keys that only rows can meet are given for a section that is meshed free.
void refuse_keys_of_rows(const Extrude& extrude, const std::string& reason) {
  const char* key = !extrude.corners.empty() ? "corners" : !extrude.divisions.empty() ? "divisions" : nullptr;
  if (key)
    throw DeckError(extrude.where, "extrude '" + extrude.name + "': '" + key +
                                       "' has a meaning only in a section that is meshed in rows between four " +
                                       "corners; this one is not: " + reason);
}

}  // namespace

void check_outline(const Extrude& extrude, double tolerance) {
  Complaints complaints;
  check_numbers(extrude, complaints);
  complaints.raise();
  check_loop(extrude, extrude.section, "the section", tolerance);
  for (std::size_t h = 0; h < extrude.holes.size(); ++h)
    check_loop(extrude, extrude.holes[h], "hole " + std::to_string(h + 1), tolerance);
  check_holes(extrude, tolerance);
}

std::optional<std::array<int, 4>> choose_corners(const Extrude& extrude) {
  const auto reason = reason_to_mesh_free(extrude);
  if (!reason.empty()) {
    refuse_keys_of_rows(extrude, reason);
    return std::nullopt;
  }
  const std::string name = "extrude '" + extrude.name + "': ";
  const auto& section = extrude.section;
  const int n = static_cast<int>(section.size());
  if (!extrude.corners.empty()) {
    const auto& given = extrude.corners;
    bool valid = given.size() == 4 && std::all_of(given.begin(), given.end(), [&](int c) { return c >= 1 && c <= n; });
    int forward = 0;  // along the outline, once round
    for (int k = 0; valid && k < 4; ++k) {
      const int step = (given[(k + 1) % 4] - given[k] + n) % n;
      forward += step;
      valid = step > 0;
    }
    if (!valid || forward != n)
      throw DeckError(extrude.where, name +
                                         "'corners' must name four different points of the section, in its order, by " +
                                         "number from 1 to " + std::to_string(n));
    return std::array{given[0] - 1, given[1] - 1, given[2] - 1, given[3] - 1};
  }
  if (n < 4) {
    refuse_keys_of_rows(extrude, "it has three points");
    return std::nullopt;
  }

  std::vector<double> angles;  // inside the section, degrees
  for (int i = 0; i < n; ++i) {
    const auto &p = section[(i + n - 1) % n], &q = section[i], &r = section[(i + 1) % n];
    const double along = (q[0] - p[0]) * (r[0] - q[0]) + (q[1] - p[1]) * (r[1] - q[1]);
    const double turned = std::atan2(turn(p, q, r), along) * (twice_area(section) < 0 ? -1 : 1);
    angles.push_back(180 - turned * 180 / std::numbers::pi);
  }
  std::vector<int> order(n);
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return angles[a] < angles[b]; });
  const bool clear =
      n == 4 ? angles[order[3]] < 179 : angles[order[3]] < 140 && angles[order[4]] - angles[order[3]] > 20;
  if (!clear) {
    std::string list;
    for (int i = 0; i < n; ++i) {
      char text[32];
      std::snprintf(text, sizeof text, "%s%.0f", i ? ", " : "", angles[i]);
      list += text;
    }
    refuse_keys_of_rows(extrude, "four corners cannot be told from its angles, " + list +
                                     " degrees; name them, corners = {i, j, k, l}");
    return std::nullopt;
  }
  std::array<int, 4> corners{order[0], order[1], order[2], order[3]};
  std::sort(corners.begin(), corners.end());
  return corners;
}

namespace {

bool strictly_inside(const SectionGraph& graph, const Section& section, const PlanePoint& p, double tolerance) {
  bool inside = false, near = false;
  SectionGraph::for_each_edge(section, [&](int i, int j) {
    const auto &a = graph.points[i], &b = graph.points[j];
    near |= distance_to_segment(a, b, p) <= tolerance;
    inside ^= ray_crosses(a, b, p);
  });
  return inside && !near;
}

std::vector<std::pair<int, int>> edges_of(const Section& section) {
  std::vector<std::pair<int, int>> edges;
  SectionGraph::for_each_edge(section, [&](int a, int b) { edges.push_back({a, b}); });
  return edges;
}

/// A point that both sections hold; empty if they share no area.
std::optional<PlanePoint> shared_place(const SectionGraph& graph, const Section& s, const Section& t,
                                       double tolerance) {
  const auto middle = [&](const std::pair<int, int>& edge) {
    return between(graph.points[edge.first], graph.points[edge.second], 0.5);
  };
  const auto edges = edges_of(s), others = edges_of(t);
  for (const auto& own : edges) {
    if (strictly_inside(graph, t, middle(own), tolerance)) return middle(own);
    for (const auto& other : others) {
      // An edge that both run along in the same direction has both areas on its left.
      if (own == other) return middle(own);
      if (cross_properly(graph.points[own.first], graph.points[own.second], graph.points[other.first],
                         graph.points[other.second], tolerance))
        return middle(own);
    }
  }
  for (const auto& other : others)
    if (strictly_inside(graph, s, middle(other), tolerance)) return middle(other);
  return std::nullopt;
}

}  // namespace

void check_overlaps(const SectionGraph& graph, double tolerance) {
  Complaints complaints;
  for (std::size_t i = 0; i < graph.sections.size(); ++i)
    for (std::size_t j = i + 1; j < graph.sections.size(); ++j) {
      const Extrude &a = *graph.sections[i].extrude, &b = *graph.sections[j].extrude;
      const bool along_y = a.y0 + tolerance < b.y0 + b.length && b.y0 + tolerance < a.y0 + a.length;
      if (!along_y) continue;
      const auto place = shared_place(graph, graph.sections[i], graph.sections[j], tolerance);
      if (place)
        complaints.add(b.where, "extrude '" + b.name + "': its section overlaps that of '" + a.name + "' near " +
                                    plane_place(*place) + "; sections may share edges, not area");
    }
  complaints.raise();
}

}  // namespace ashlar
