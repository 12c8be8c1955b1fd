#include "model/mesher/strips.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "model/mesher/spacing.hpp"

namespace ashlar {

namespace {

using Edge = std::pair<int, int>;  // smaller vertex first
Edge edge_of(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

/// Edges in groups that run in step, with the direction of each relative to its group's first (union-find).
class EdgeGroups {
 public:
  struct Member {
    int group;
    bool reversed;
  };
  int number(const Edge& edge) {
    const auto [at, added] = numbers_.try_emplace(edge, static_cast<int>(parents_.size()));
    if (added) parents_.push_back({at->second, false});
    return at->second;
  }
  const std::map<Edge, int>& numbers() const { return numbers_; }
  Member find(int e) const {
    bool reversed = false;
    while (parents_[e].group != e) {
      reversed ^= parents_[e].reversed;
      e = parents_[e].group;
    }
    return {e, reversed};
  }
  void join(int a, int b, bool opposed) {
    const Member p = find(a), q = find(b);
    if (p.group == q.group) return;
    const int low = std::min(p.group, q.group), high = std::max(p.group, q.group);
    parents_[high] = {low, static_cast<bool>(p.reversed ^ q.reversed ^ opposed)};
  }

 private:
  std::map<Edge, int> numbers_;
  std::vector<Member> parents_;
};

/// One strip: the spacing of the section that needs most elements on it, or the divisions asked.
struct Strip {
  Spacing spacing;  // in the direction of the group's first edge
  int asked = 0;
  const Section* asking = nullptr;
  int asking_side = 0;
  int count() const { return asked ? asked : spacing.count(); }
};

/// `divisions` of one side, over the strips that cross it.
struct Demand {
  const Section* section;
  int side;
  int count;
  std::vector<int> strips;
};

class Dividing {
 public:
  explicit Dividing(const SectionGraph& graph) : graph_(graph) {}

  EdgePoints run() {
    group_edges();
    measure_vertices();
    for (const auto& section : graph_.sections)
      for (int side = 0; side < 2; ++side) need(section, side);
    grant_demands();
    EdgePoints points;
    for (const auto& [edge, number] : groups_.numbers()) points[edge] = divide(edge, groups_.find(number));
    return points;
  }

 private:
  void group_edges() {
    for (const auto& section : graph_.sections)
      for (int side = 0; side < 2; ++side) {
        const auto a = section.side(side), b = section.side(side + 2);
        for (std::size_t i = 0; i + 1 < a.size(); ++i)
          groups_.join(groups_.number(edge_of(a[i], a[i + 1])), groups_.number(edge_of(b[i], b[i + 1])),
                       (a[i] < a[i + 1]) != (b[i] < b[i + 1]));
      }
  }

  /// The finest size of the sections at each vertex.
  void measure_vertices() {
    vertex_size_.assign(graph_.points.size(), std::numeric_limits<double>::infinity());
    for (const auto& section : graph_.sections)
      for (const int v : section.outline) vertex_size_[v] = std::min(vertex_size_[v], section.extrude->size);
  }
  double finest(const std::vector<int>& vertices) const {
    double size = std::numeric_limits<double>::infinity();
    for (const int v : vertices) size = std::min(size, vertex_size_[v]);
    return size;
  }

  /// What one section needs on the strips that cross its sides `side` and `side + 2`.
  void need(const Section& section, int side) {
    const auto a = section.side(side), b = section.side(side + 2);
    const double start = finest(section.side(side == 0 ? 3 : 0)), end = finest(section.side(side == 0 ? 1 : 2));
    std::vector<int> strips;
    for (std::size_t i = 0; i + 1 < a.size(); ++i) {
      const auto size_between = [&](std::size_t k) {
        return k == 0 ? start : k + 1 == a.size() ? end : finest({a[k], b[k]});
      };
      const auto member = groups_.find(groups_.number(edge_of(a[i], a[i + 1])));
      const double length = std::max(distance(graph_.points[a[i]], graph_.points[a[i + 1]]),
                                     distance(graph_.points[b[i]], graph_.points[b[i + 1]]));
      Spacing spacing{length, section.extrude->size, size_between(i), size_between(i + 1), section.extrude->grade};
      if ((a[i] > a[i + 1]) != member.reversed) spacing = spacing.reversed();
      auto& strip = strips_[member.group];
      if (strip.spacing.length == 0 || spacing.natural_count() > strip.spacing.natural_count()) strip.spacing = spacing;
      strips.push_back(member.group);
    }
    for (const int k : {side, side + 2})
      if (section.divisions[k]) demands_.push_back({&section, k, section.divisions[k], strips});
  }

  void grant_demands() {
    // A side crossed by one strip leaves no choice, so it goes first.
    std::stable_sort(demands_.begin(), demands_.end(),
                     [](const Demand& p, const Demand& q) { return p.strips.size() < q.strips.size(); });
    for (const auto& demand : demands_) {
      std::vector<int> free;
      int rest = demand.count;
      for (const int s : demand.strips)
        if (strips_[s].asked)
          rest -= strips_[s].asked;
        else
          free.push_back(s);
      if (rest < static_cast<int>(free.size()) || (free.empty() && rest != 0)) refuse(demand);
      share_out(rest, free, demand);
    }
    for (const auto& demand : demands_) {
      int sum = 0;
      for (const int s : demand.strips) sum += strips_[s].asked;
      if (sum != demand.count) refuse(demand);
    }
  }

  /// Divides `count` over the strips in proportion to their natural counts, at least one each.
  void share_out(int count, const std::vector<int>& strips, const Demand& demand) {
    double natural = 0;
    for (const int s : strips) natural += strips_[s].spacing.natural_count();
    int behind = static_cast<int>(strips.size());
    for (const int s : strips) {
      auto& strip = strips_[s];
      const double share = count * strip.spacing.natural_count() / natural;
      strip.asked = std::clamp(static_cast<int>(std::lround(share)), 1, count - --behind);
      strip.asking = demand.section;
      strip.asking_side = demand.side;
      count -= strip.asked;
      natural -= strip.spacing.natural_count();
    }
  }

  [[noreturn]] void refuse(const Demand& demand) {
    std::string others;
    for (const int s : demand.strips)
      if (const auto& strip = strips_[s]; strip.asking)
        others += (others.empty() ? "" : ", ") + std::to_string(strip.asked) + " on side " +
                  std::to_string(strip.asking->deck_side[strip.asking_side]) + " of '" + strip.asking->extrude->name +
                  "'";
    throw DeckError(
        demand.section->extrude->where,
        "extrude '" + demand.section->extrude->name + "': divisions = " + std::to_string(demand.count) + " on side " +
            std::to_string(demand.section->deck_side[demand.side]) + " cannot be met: the side has " +
            std::to_string(demand.strips.size()) + (demand.strips.size() == 1 ? " piece" : " pieces") +
            ", at least one division each" +
            (others.empty() ? "" : "; opposite sides and neighbours divide alike, and already given are " + others));
  }

  std::vector<PlanePoint> divide(const Edge& edge, const EdgeGroups::Member& member) {
    const auto& strip = strips_.at(member.group);
    const int n = strip.count();
    if (n > 100000)
      throw DeckError(graph_.sections[0].extrude->where, "the edge from " + plane_place(graph_.points[edge.first]) +
                                                             " to " + plane_place(graph_.points[edge.second]) +
                                                             " would have " + std::to_string(n) +
                                                             " elements; is 'size' in metres?");
    const auto places = (member.reversed ? strip.spacing.reversed() : strip.spacing).places(n);
    const auto &p = graph_.points[edge.first], &q = graph_.points[edge.second];
    std::vector<PlanePoint> points{p};
    for (int k = 1; k < n; ++k) points.push_back({p[0] + places[k] * (q[0] - p[0]), p[1] + places[k] * (q[1] - p[1])});
    points.push_back(q);
    return points;
  }

  const SectionGraph& graph_;
  EdgeGroups groups_;
  std::vector<double> vertex_size_;
  std::map<int, Strip> strips_;
  std::vector<Demand> demands_;
};

}  // namespace

EdgePoints divide_edges(const SectionGraph& graph) { return Dividing(graph).run(); }

}  // namespace ashlar
