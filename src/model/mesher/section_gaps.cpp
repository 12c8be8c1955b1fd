#include "model/mesher/section_gaps.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace ashlar {

namespace {

/// One edge with its place along its loop.
struct LoopEdge {
  int loop;
  PlanePoint a, b;
  double start, length;  ///< along the loop, m
};

class Gaps {
 public:
  Gaps(const SectionGraph& graph, const Section& section) : extrude_(*section.extrude) {
    for (std::size_t l = 0; l < section.loops.size(); ++l) {
      const auto& loop = section.loops[l];
      double along = 0;
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const auto &a = graph.points[loop[i]], &b = graph.points[loop[(i + 1) % loop.size()]];
        edges_.push_back({static_cast<int>(l), a, b, along, distance(a, b)});
        along += edges_.back().length;
      }
      perimeters_.push_back(along);
    }
    // Where each triangle becomes three quads, its edges hold two elements.
    elements_across_ = section.halves_edges() ? 2 : 1;
  }

  std::vector<SizeAt> run() {
    std::vector<SizeAt> places;
    for (const auto& edge : edges_) {
      const double wanted = edge.loop > 0 && extrude_.hole_size > 0 ? extrude_.hole_size : extrude_.size;
      for (const double along : samples(edge, wanted)) {
        const auto p = between(edge.a, edge.b, along);
        const double gap = gap_at(edge, p, wanted);
        places.push_back({p, std::min({wanted, edge.length / elements_across_, gap / elements_across_})});
      }
    }
    return places;
  }

 private:
  /// Even places, and those that corners of other edges face: the gap is narrowest at one of them.
  std::vector<double> samples(const LoopEdge& edge, double wanted) const {
    const int n = static_cast<int>(std::clamp(std::ceil(2 * edge.length / wanted), 2.0, 200.0));
    std::vector<double> places;
    for (int i = 0; i <= n; ++i) places.push_back(static_cast<double>(i) / n);
    for (const auto& other : edges_) {
      const auto foot = foot_on(edge.a, edge.b, other.a);
      if (foot.along > 0 && foot.along < 1 && foot.off < wanted * elements_across_) places.push_back(foot.along);
    }
    return places;
  }

  /// Distance across the section to the nearest edge that is far away along the outline.
  double gap_at(const LoopEdge& edge, const PlanePoint& p, double wanted) const {
    double narrowest = wanted * elements_across_;
    for (const auto& other : edges_) {
      const auto foot = nearest_on(other.a, other.b, p);
      const double gap = distance(p, foot);
      if (gap >= narrowest || adjacent(edge, other) || path(edge, p, other, foot) <= 4 * gap) continue;
      if (!inside(between(p, foot, 0.5))) continue;
      narrowest = gap;
      if (gap < wanted / 50) refuse(p, foot, gap, wanted);
    }
    return narrowest;
  }

  bool adjacent(const LoopEdge& p, const LoopEdge& q) const {
    return p.loop == q.loop && (p.b == q.a || q.b == p.a || p.a == q.a);
  }
  /// Length of the way along the outline.
  double path(const LoopEdge& edge, const PlanePoint& p, const LoopEdge& other, const PlanePoint& q) const {
    if (edge.loop != other.loop) return HUGE_VAL;
    const double way = std::abs(edge.start + distance(edge.a, p) - other.start - distance(other.a, q));
    return std::min(way, perimeters_[edge.loop] - way);
  }
  bool inside(const PlanePoint& p) const {
    bool odd = false;
    for (const auto& edge : edges_) odd ^= ray_crosses(edge.a, edge.b, p);
    return odd;
  }

  [[noreturn]] void refuse(const PlanePoint& p, const PlanePoint& q, double gap, double wanted) const {
    char text[96];
    std::snprintf(text, sizeof text, "only %.3g m thick, less than a fiftieth of its element size %.3g m", gap, wanted);
    throw DeckError(extrude_.where, "extrude '" + extrude_.name + "': between " + plane_place(p) + " and " +
                                        plane_place(q) + " the section is " + text +
                                        "; leave more material there or make the elements smaller");
  }

  const Extrude& extrude_;
  std::vector<LoopEdge> edges_;
  std::vector<double> perimeters_;  ///< [loops], m
  int elements_across_ = 1;
};

}  // namespace

std::vector<SizeAt> sizes_of_shape(const SectionGraph& graph, const Section& section) {
  return Gaps(graph, section).run();
}

}  // namespace ashlar
