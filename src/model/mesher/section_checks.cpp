#include "model/mesher/section_checks.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <numeric>
#include <optional>

namespace ashlar {

namespace {

constexpr const char* how_to_divide =
    "this release meshes logical quads: outlines with four corners, sides may be polylines; divide a section with "
    "re-entrant corners or holes into several extrudes that share edges (a name each)";

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
  const double length = distance(a, b);
  double along = ((p[0] - a[0]) * (b[0] - a[0]) + (p[1] - a[1]) * (b[1] - a[1])) / (length * length);
  along = std::clamp(along, 0.0, 1.0);
  return distance({a[0] + along * (b[0] - a[0]), a[1] + along * (b[1] - a[1])}, p);
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
  if (!(extrude.grade >= 1) || !std::isfinite(extrude.grade))
    complaints.add(extrude.where, name + "'grade' is the growth from one element to the next, 1 or more");
  for (const auto& [side, count] : extrude.divisions) {
    if (side < 1 || side > 4)
      complaints.add(extrude.where, name + "'divisions' of side " + std::to_string(side) +
                                        ": a section has sides 1 to 4, " +
                                        "side 1 from its first corner to its second");
    if (count < 1)
      complaints.add(extrude.where, name + "'divisions' of side " + std::to_string(side) + " must be 1 or more");
  }
}

}  // namespace

void check_outline(const Extrude& extrude, double tolerance) {
  const std::string name = "extrude '" + extrude.name + "': ";
  const auto& section = extrude.section;
  const int n = static_cast<int>(section.size());
  Complaints complaints;
  check_numbers(extrude, complaints);
  if (n < 3) complaints.add(extrude.where, name + "a section needs at least 3 points, got " + std::to_string(n));
  for (int i = 0; i < n; ++i)
    if (!std::isfinite(section[i][0]) || !std::isfinite(section[i][1]))
      complaints.add(extrude.where, name + "point " + std::to_string(i + 1) + " of the section is not finite");
  complaints.raise();

  const auto point = [&](int i) { return std::to_string(i % n + 1) + " " + plane_place(section[i % n]); };
  for (int i = 0; i < n; ++i)
    for (int j = i + 1; j < n; ++j)
      if (distance(section[i], section[j]) <= tolerance)
        complaints.add(extrude.where, name + "points " + point(i) + " and " + point(j) +
                                          " of the section are the same; the outline closes by itself");
  complaints.raise();
  for (int i = 0; i < n; ++i)
    for (int j = i + 1; j < n; ++j) {
      const auto &a = section[i], &b = section[(i + 1) % n], &c = section[j], &d = section[(j + 1) % n];
      const bool neighbours = j == i + 1 || (i == 0 && j == n - 1);
      const bool touches =
          neighbours ? distance_to_segment(a, b, j == i + 1 ? d : c) <= tolerance ||
                           distance_to_segment(c, d, j == i + 1 ? a : b) <= tolerance
                     : cross_properly(a, b, c, d, tolerance) || distance_to_segment(a, b, c) <= tolerance ||
                           distance_to_segment(a, b, d) <= tolerance || distance_to_segment(c, d, a) <= tolerance ||
                           distance_to_segment(c, d, b) <= tolerance;
      if (touches)
        complaints.add(extrude.where, name + "the outline crosses or touches itself: edge " + point(i) + " - " +
                                          point(i + 1) + " and edge " + point(j) + " - " + point(j + 1));
    }
  complaints.raise();
}

std::array<int, 4> choose_corners(const Extrude& extrude) {
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
    return {given[0] - 1, given[1] - 1, given[2] - 1, given[3] - 1};
  }
  if (n < 4)
    throw DeckError(extrude.where, name + "a section of " + std::to_string(n) + " points has no four corners; " +
                                       "cut off its tip (a crest has a width); " + how_to_divide);

  double twice_area = 0;
  for (int i = 1; i + 1 < n; ++i) twice_area += turn(section[0], section[i], section[i + 1]);
  std::vector<double> angles;  // inside the section, degrees
  for (int i = 0; i < n; ++i) {
    const auto &p = section[(i + n - 1) % n], &q = section[i], &r = section[(i + 1) % n];
    const double along = (q[0] - p[0]) * (r[0] - q[0]) + (q[1] - p[1]) * (r[1] - q[1]);
    const double turned = std::atan2(turn(p, q, r), along) * (twice_area < 0 ? -1 : 1);
    angles.push_back(180 - turned * 180 / std::numbers::pi);
  }
  std::vector<int> order(n);
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return angles[a] < angles[b]; });
  const bool clear =
      n == 4 ? angles[order[3]] < 179 : angles[order[3]] < 170 && angles[order[4]] - angles[order[3]] > 10;
  if (!clear) {
    std::string list;
    for (int i = 0; i < n; ++i) {
      char text[32];
      std::snprintf(text, sizeof text, "%s%.0f", i ? ", " : "", angles[i]);
      list += text;
    }
    throw DeckError(extrude.where, name + "cannot tell the four corners of the section; its angles are " + list +
                                       " degrees; name them, corners = {i, j, k, l}; " + how_to_divide);
  }
  std::array<int, 4> corners{order[0], order[1], order[2], order[3]};
  std::sort(corners.begin(), corners.end());
  return corners;
}

namespace {

bool strictly_inside(const SectionGraph& graph, const Section& section, const PlanePoint& p, double tolerance) {
  bool inside = false;
  const std::size_t n = section.outline.size();
  for (std::size_t i = 0; i < n; ++i) {
    const auto &a = graph.points[section.outline[i]], &b = graph.points[section.outline[(i + 1) % n]];
    if (distance_to_segment(a, b, p) <= tolerance) return false;
    if ((a[1] > p[1]) != (b[1] > p[1]) && p[0] < a[0] + (p[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0])) inside = !inside;
  }
  return inside;
}

/// A point that both sections hold; empty if they share no area.
std::optional<PlanePoint> shared_place(const SectionGraph& graph, const Section& s, const Section& t,
                                       double tolerance) {
  for (std::size_t i = 0; i < s.outline.size(); ++i) {
    const int a = s.outline[i], b = s.outline[(i + 1) % s.outline.size()];
    const auto &p = graph.points[a], &q = graph.points[b];
    const PlanePoint middle{0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1])};
    if (strictly_inside(graph, t, middle, tolerance)) return middle;
    for (std::size_t j = 0; j < t.outline.size(); ++j) {
      const int c = t.outline[j], d = t.outline[(j + 1) % t.outline.size()];
      // An edge that both run along in the same direction has both areas on its left.
      if (a == c && b == d) return middle;
      if (cross_properly(p, q, graph.points[c], graph.points[d], tolerance)) return middle;
    }
  }
  for (std::size_t j = 0; j < t.outline.size(); ++j) {
    const auto &p = graph.points[t.outline[j]], &q = graph.points[t.outline[(j + 1) % t.outline.size()]];
    const PlanePoint middle{0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1])};
    if (strictly_inside(graph, s, middle, tolerance)) return middle;
  }
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
