#include "model/contact/facing.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "model/contact/overlap_search.hpp"
#include "model/loads.hpp"

namespace ashlar {

namespace {

constexpr double default_tolerance = 1e-6;   // of the model's size
constexpr double least_facing = 0.95;        // cosine between normals, one turned around
constexpr double sight = 0.1;                // of a facet's size: how far away a facet is still noticed
constexpr double same_corner = 1e-6;         // of a facet's size
constexpr double least_overlap = 1e-9;       // of the smaller facet's area
constexpr double whole = 0.999, half = 0.5;  // of a facet's area

/// A free face as the search sees it.
struct Side {
  Facet facet;
  FacetCorners corners;
  int corner_count = 0;
  Vec3<double> area, centre;
  double size = 0;     ///< root of the area, m
  double covered = 0;  ///< m^2
  double too_far = 0;  ///< m, to the nearest face beyond the tolerance

  Side(const Mesh& mesh, const Facet& f)
      : facet(f),
        corners(facet_corners(mesh, f)),
        corner_count(static_cast<int>(face_corners(mesh.shapes[f.element], f.face).size())),
        area(mesh.facet_area(f)),
        centre(mesh.facet_centroid(f)),
        size(std::sqrt(norm(area))) {}

  Vec3<double> position(const Vec3<double>& p) const {
    const auto shape = corner_count == 3 ? triangle_shape_at(corners, p) : facet_shape_at(corners, p);
    Vec3<double> x;
    for (int i = 0; i < corner_count; ++i) x = x + shape[i] * corners[i];
    return x;
  }
  Box3 box(double wider) const {
    Box3 b{corners[0], corners[0]};
    for (int i = 1; i < corner_count; ++i)
      for (int c = 0; c < 3; ++c) {
        b.low[c] = std::min(b.low[c], corners[i][c]);
        b.high[c] = std::max(b.high[c], corners[i][c]);
      }
    for (int c = 0; c < 3; ++c) b.low[c] -= wider, b.high[c] += wider;
    return b;
  }
};

/// Directions e1, e2 that complete `normal` to a right-handed system.
struct Plane {
  Vec3<double> origin, normal, e1, e2;

  Plane(const Vec3<double>& o, const Vec3<double>& n) : origin(o), normal(n) {
    const Vec3<double> axis = std::abs(n.x) < 0.6 ? Vec3<double>{1, 0, 0} : Vec3<double>{0, 1, 0};
    e1 = cross(axis, n);
    e1 = (1 / norm(e1)) * e1;
    e2 = cross(n, e1);
  }
  Point2 flat(const Vec3<double>& p) const { return {dot(p - origin, e1), dot(p - origin, e2)}; }
  Vec3<double> place(const Point2& p) const { return origin + p[0] * e1 + p[1] * e2; }
};

double polygon_area(const std::vector<Point2>& p) {
  double twice = 0;
  for (std::size_t i = 1; i + 1 < p.size(); ++i)
    twice += (p[i][0] - p[0][0]) * (p[i + 1][1] - p[0][1]) - (p[i][1] - p[0][1]) * (p[i + 1][0] - p[0][0]);
  return twice / 2;
}

bool corners_meet(const Plane& plane, const Side& a, const Side& b) {
  if (a.corner_count != b.corner_count) return false;
  for (int i = 0; i < a.corner_count; ++i) {
    const Point2 p = plane.flat(a.corners[i]);
    bool met = false;
    for (int k = 0; k < b.corner_count; ++k) {
      const Point2 q = plane.flat(b.corners[k]);
      met = met || std::hypot(p[0] - q[0], p[1] - q[1]) <= same_corner * a.size;
    }
    if (!met) return false;
  }
  return true;
}

/// The faces of one joint.
class JointSearch {
 public:
  JointSearch(const Model& model, int interface, Facing& found)
      : model_(model), interface_(interface), found_(found), match_(found.matches[interface]) {
    const double given = model.interfaces[interface].tolerance;
    tolerance_ = given > 0 ? given : default_tolerance * model.mesh.extent();
  }

  void run(const std::vector<Facet>& of_one, const std::vector<Facet>& of_other) {
    std::vector<Side> one = sides(of_one), other = sides(of_other);
    if (one.empty() || other.empty()) return;
    keep_near(one, other);
    keep_near(other, one);
    std::vector<Box3> boxes_one, boxes_other;
    for (const Side& s : one) boxes_one.push_back(s.box(reach(s)));
    for (const Side& s : other) boxes_other.push_back(s.box(reach(s)));
    for (const auto& [i, k] : meeting_boxes(boxes_one, boxes_other)) {
      Side &a = one[i], &b = other[k];
      before(a.facet, b.facet) ? meet(a, b) : meet(b, a);
    }
    for (const auto* list : {&one, &other})
      for (const Side& s : *list) {
        const double share = s.covered / (s.size * s.size);
        const double free = s.size * s.size - s.covered;
        const bool part = share > 0 && share < whole, apart = s.too_far != 0 && share == 0;
        if (part) ++match_.partly_covered;
        if (apart) ++match_.too_far;
        if (part || apart) match_.unmatched.push_back({s.facet, free, apart ? s.too_far : 0});
        if (part && share > half) match_.inner_free += free;
        if (part && share <= half) match_.outer_joined += s.covered;
        if (share > half) found_.covered.push_back({s.facet, interface_});
      }
  }

 private:
  std::vector<Side> sides(const std::vector<Facet>& facets) const {
    std::vector<Side> all;
    all.reserve(facets.size());
    for (const Facet& f : facets) all.emplace_back(model_.mesh, f);
    return all;
  }
  double reach(const Side& s) const { return tolerance_ + sight * s.size; }

  /// Drops sides outside the box around the others.
  void keep_near(std::vector<Side>& sides, const std::vector<Side>& others) const {
    if (others.empty()) return sides.clear();
    Box3 around = others[0].box(reach(others[0]));
    for (const Side& s : others) {
      const Box3 b = s.box(reach(s));
      for (int c = 0; c < 3; ++c) {
        around.low[c] = std::min(around.low[c], b.low[c]);
        around.high[c] = std::max(around.high[c], b.high[c]);
      }
    }
    std::erase_if(sides, [&](const Side& s) {
      const Box3 b = s.box(reach(s));
      for (int c = 0; c < 3; ++c)
        if (b.low[c] > around.high[c] || b.high[c] < around.low[c]) return true;
      return false;
    });
  }

  void meet(Side& a, Side& b) {
    const double sizes = a.size * a.size * b.size * b.size;
    if (-dot(a.area, b.area) < least_facing * sizes) return;
    Vec3<double> normal = (1 / (a.size * a.size)) * a.area - (1 / (b.size * b.size)) * b.area;
    normal = (1 / norm(normal)) * normal;
    const Plane plane(a.centre, normal);
    std::vector<Point2> p, q;
    for (int i = 0; i < a.corner_count; ++i) p.push_back(plane.flat(a.corners[i]));
    for (int i = b.corner_count - 1; i >= 0; --i) q.push_back(plane.flat(b.corners[i]));
    const std::vector<Point2> shared = convex_overlap(p, q);
    const double area = polygon_area(shared);
    if (!(area > least_overlap * std::min(a.size * a.size, b.size * b.size))) return;

    Overlap overlap{{}, normal, area};
    Vec3<double> middle;
    for (const Point2& corner : shared) {
      overlap.polygon.push_back(plane.place(corner));
      middle = middle + (1 / double(shared.size())) * overlap.polygon.back();
    }
    const auto gap_at = [&](const Vec3<double>& x) { return dot(b.position(x) - a.position(x), normal); };
    const double gap = overlap.gap = gap_at(middle);
    if (std::abs(gap) > tolerance_) {
      if (std::abs(gap) > reach(a) && std::abs(gap) > reach(b)) return;
      if (match_.too_far_by == 0 || std::abs(gap) < std::abs(match_.too_far_by)) match_.too_far_by = gap;
      for (Side* s : {&a, &b})
        if (s->too_far == 0 || std::abs(gap) < std::abs(s->too_far)) s->too_far = gap;
      return;
    }
    for (const Vec3<double>& corner : overlap.polygon) {
      const double here = gap_at(corner);
      match_.largest_gap = std::max(match_.largest_gap, here);
      match_.largest_overlap = std::max(match_.largest_overlap, -here);
    }
    ++match_.joined;
    a.covered += area;
    b.covered += area;
    found_.faces.push_back({a.facet, b.facet, interface_, corners_meet(plane, a, b), std::move(overlap)});
  }

  const Model& model_;
  int interface_;
  Facing& found_;
  JointMatch& match_;
  double tolerance_;  ///< m
};

}  // namespace

Facing find_facing(const Model& model, const FaceGraph& graph) {
  const Mesh& mesh = model.mesh;
  Facing found;
  found.matches.resize(model.interfaces.size());
  std::map<int, std::vector<Facet>> free;  // outer faces of the regions of joints
  for (const Interface& i : model.interfaces)
    for (const auto& region : i.regions)
      if (!i.crackable) free[mesh.find_region(region)];
  free.erase(-1);
  for (const Facet& f : graph.outer)
    if (const auto at = free.find(mesh.regions[f.element]); at != free.end()) at->second.push_back(f);
  for (int i = 0; i < static_cast<int>(model.interfaces.size()); ++i) {
    const Interface& joint = model.interfaces[i];
    if (joint.crackable || joint.regions.size() != 2 || joint.regions[0] == joint.regions[1]) continue;
    const auto one = free.find(mesh.find_region(joint.regions[0])),
               other = free.find(mesh.find_region(joint.regions[1]));
    if (one == free.end() || other == free.end()) continue;
    JointSearch(model, i, found).run(one->second, other->second);
  }
  std::sort(found.faces.begin(), found.faces.end(), [](const FacingFaces& p, const FacingFaces& q) {
    return p.a == q.a ? before(p.b, q.b) : before(p.a, q.a);
  });
  std::sort(found.covered.begin(), found.covered.end(),
            [](const CoveredFace& p, const CoveredFace& q) { return before(p.facet, q.facet); });
  return found;
}

int corner_on_corner(const Mesh& mesh, int node, const std::vector<int>& others) {
  if (const auto same = std::find(others.begin(), others.end(), node); same != others.end())
    return static_cast<int>(same - others.begin());
  const auto away = [&](int other) { return norm(mesh.points[other] - mesh.points[node]); };
  const auto nearest = std::min_element(others.begin(), others.end(), [&](int p, int q) { return away(p) < away(q); });
  return static_cast<int>(nearest - others.begin());
}

}  // namespace ashlar
