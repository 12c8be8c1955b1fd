#include "model/contact/overlap_search.hpp"

#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>

namespace ashlar {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using NumberedBox = CGAL::Box_intersection_d::Box_with_info_d<double, 3, int>;

std::vector<NumberedBox> numbered(std::span<const Box3> boxes) {
  std::vector<NumberedBox> all;
  all.reserve(boxes.size());
  for (const Box3& box : boxes)
    all.emplace_back(CGAL::Bbox_3(box.low.x, box.low.y, box.low.z, box.high.x, box.high.y, box.high.z),
                     static_cast<int>(all.size()));
  return all;
}

Kernel::Point_2 point(const Point2& p) { return {p[0], p[1]}; }

/// Where the edge from p to r crosses the line through a and b; they lie on different sides of it.
Point2 crossing(const Point2& p, const Point2& r, const Point2& a, const Point2& b) {
  const auto beside = [&](const Point2& c) { return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]); };
  const double at_p = beside(p), at_r = beside(r);
  const double t = at_p == at_r ? 0.5 : std::clamp(at_p / (at_p - at_r), 0.0, 1.0);
  return {p[0] + t * (r[0] - p[0]), p[1] + t * (r[1] - p[1])};
}

}  // namespace

std::vector<std::array<int, 2>> meeting_boxes(std::span<const Box3> a, std::span<const Box3> b) {
  auto boxes_a = numbered(a), boxes_b = numbered(b);
  std::vector<std::array<int, 2>> pairs;
  CGAL::box_intersection_d(boxes_a.begin(), boxes_a.end(), boxes_b.begin(), boxes_b.end(),
                           [&](const NumberedBox& one, const NumberedBox& other) {
                             pairs.push_back({one.info(), other.info()});
                           });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

std::vector<Point2> convex_overlap(std::span<const Point2> p, std::span<const Point2> q) {
  std::vector<Point2> kept(p.begin(), p.end()), next;
  for (std::size_t i = 0; i < q.size() && !kept.empty(); ++i) {
    const Point2 &a = q[i], &b = q[(i + 1) % q.size()];
    const auto side = [&](const Point2& c) { return CGAL::orientation(point(a), point(b), point(c)); };
    next.clear();
    for (std::size_t k = 0; k < kept.size(); ++k) {
      const Point2 &from = kept[k], &to = kept[(k + 1) % kept.size()];
      const auto at_from = side(from), at_to = side(to);
      if (at_from != CGAL::RIGHT_TURN) next.push_back(from);
      if (at_from * at_to < 0) next.push_back(crossing(from, to, a, b));
    }
    kept.swap(next);
  }
  if (kept.size() < 3) kept.clear();
  return kept;
}

}  // namespace ashlar
