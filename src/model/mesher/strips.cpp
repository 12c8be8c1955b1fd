#include "model/mesher/strips.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

#include "model/mesher/spacing.hpp"

namespace ashlar {

namespace {

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
  Spacing spacing;                     // in the direction of the group's first edge
  double size = HUGE_VAL;              // smallest of the sections in rows
  std::optional<EdgeProfile> profile;  // of a section meshed free that needs more; in the same direction
  bool even = false;                   // a section meshed free halves its edges
  int asked = 0;
  const Section* asking = nullptr;
  int asking_side = 0;

  double natural_count() const { return profile ? profile->natural_count() : spacing.natural_count(); }
  int count() const {
    const int n = asked ? asked : std::max(1, static_cast<int>(std::min(std::ceil(natural_count() - 0.05), 1e9)));
    return even ? n + n % 2 : n;
  }
  std::vector<double> places(int n, bool reversed) const {
    if (profile) return (reversed ? profile->reversed() : *profile).places(n);
    return (reversed ? spacing.reversed() : spacing).places(n);
  }
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
  Dividing(const SectionGraph& graph, FreeSizes& free) : graph_(graph), free_(free) {}

  EdgePoints run() {
    group_edges();
    measure_vertices();
    for (const auto& section : graph_.sections)
      for (int side = 0; side < 2 && !section.free; ++side) need(section, side);
    need_of_free_sections();
    grant_demands();
    EdgePoints points;
    for (const auto& [edge, number] : groups_.numbers()) points[edge] = divide(edge, groups_.find(number));
    for (const auto& [edge, places] : points)
      if (free_.has(edge)) free_.take(edge, places);
    free_.update();
    for (const auto& section : graph_.sections)
      SectionGraph::for_each_edge(section, [&](int a, int b) {
        if (const Edge edge = edge_of(a, b); !points.contains(edge)) points[edge] = free_.divide(edge);
      });
    return points;
  }

 private:
  void group_edges() {
    for (const auto& section : graph_.sections)
      for (int side = 0; side < 2 && !section.free; ++side) {
        const auto a = section.side(side), b = section.side(side + 2);
        for (std::size_t i = 0; i + 1 < a.size(); ++i)
          groups_.join(groups_.number(edge_of(a[i], a[i + 1])), groups_.number(edge_of(b[i], b[i + 1])),
                       (a[i] < a[i + 1]) != (b[i] < b[i + 1]));
      }
  }

  /// The finest size of the sections at each vertex.
  void measure_vertices() {
    for (int v = 0; v < static_cast<int>(graph_.points.size()); ++v) vertex_size_.push_back(free_.at_vertex(v));
    for (const auto& section : graph_.sections)
      if (!section.free)
        for (const int v : section.outline()) vertex_size_[v] = std::min(vertex_size_[v], section.extrude->size);
  }
  void need_of_free_sections() {
    for (const auto& [edge, number] : groups_.numbers()) {
      if (!free_.has(edge)) continue;
      const auto member = groups_.find(number);
      auto& strip = strips_.at(member.group);
      strip.even |= free_.even(edge);
      const auto profile = free_.profile(edge, strip.size);
      if (profile.natural_count() >= strip.natural_count())
        strip.profile = member.reversed ? profile.reversed() : profile;
    }
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
      Spacing spacing{length, section.extrude->size, size_between(i), size_between(i + 1),
                      std::max(1.0, section.extrude->grow)};
      if ((a[i] > a[i + 1]) != member.reversed) spacing = spacing.reversed();
      auto& strip = strips_[member.group];
      strip.size = std::min(strip.size, section.extrude->size);
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
    for (const auto& [group, strip] : strips_)
      if (strip.asked % 2 && strip.even)
        throw DeckError(
            strip.asking->extrude->where,
            "extrude '" + strip.asking->extrude->name + "': divisions on side " +
                std::to_string(strip.asking->deck_side[strip.asking_side]) + " put " + std::to_string(strip.asked) +
                " elements on an edge of a neighbour that is made of split " +
                "triangles, two elements an edge; give an even number, or the neighbour elements = " + "\"wedge6\"");
  }

  /// Divides `count` over the strips in proportion to their natural counts, at least one each.
  void share_out(int count, const std::vector<int>& strips, const Demand& demand) {
    double natural = 0;
    for (const int s : strips) natural += strips_[s].natural_count();
    int behind = static_cast<int>(strips.size());
    for (const int s : strips) {
      auto& strip = strips_[s];
      const double share = count * strip.natural_count() / natural;
      strip.asked = std::clamp(static_cast<int>(std::lround(share)), 1, count - --behind);
      strip.asking = demand.section;
      strip.asking_side = demand.side;
      count -= strip.asked;
      natural -= strip.natural_count();
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
    const auto places = strip.places(n, member.reversed);
    const auto &p = graph_.points[edge.first], &q = graph_.points[edge.second];
    std::vector<PlanePoint> points{p};
    for (int k = 1; k < n; ++k) points.push_back({p[0] + places[k] * (q[0] - p[0]), p[1] + places[k] * (q[1] - p[1])});
    points.push_back(q);
    return points;
  }

  const SectionGraph& graph_;
  FreeSizes& free_;
  EdgeGroups groups_;
  std::vector<double> vertex_size_;
  std::map<int, Strip> strips_;
  std::vector<Demand> demands_;
};

}  // namespace

EdgePoints divide_edges(const SectionGraph& graph, FreeSizes& free) { return Dividing(graph, free).run(); }

}  // namespace ashlar
