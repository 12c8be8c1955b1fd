#include "model/mesher/closed_surface.hpp"

#include <algorithm>
#include <map>
#include <numeric>

#include "model/place_text.hpp"

namespace ashlar {

namespace {

/// One edge of one triangle, under the key that both its triangles find.
struct TriangleEdge {
  std::pair<int, int> nodes;  ///< the smaller number first
  int triangle;
  bool forward;  ///< runs from the smaller number to the larger in its triangle
};

class Check {
 public:
  Check(const FacetSurface& surface, const Where& where, const std::string& title)
      : surface_(surface), where_(where), title_(title), count_(static_cast<int>(surface.triangles.size())) {}

  void run() {
    areas();
    repeated_facets();
    edges();
    orientation();
    shells();
    pinched_points();
    crossings();
  }

 private:
  std::string facet(int t) const {
    return "facet " + std::to_string(surface_.facets[t]) + " at " + place_text(centre(t));
  }
  Vec3<double> centre(int t) const {
    const auto& [a, b, c] = surface_.triangles[t];
    return (1.0 / 3) * (surface_.points[a] + surface_.points[b] + surface_.points[c]);
  }
  std::string edge(const std::pair<int, int>& nodes) const {
    return place_text(surface_.points[nodes.first]) + " to " + place_text(surface_.points[nodes.second]);
  }
  void complain(const std::string& message) {
    constexpr int most = 10;
    if (++complaints_ <= most) lines_.add(where_, title_ + ": " + message);
  }
  /// Ends a step: what follows relies on it.
  void raise(const std::string& remedy) {
    if (!complaints_) return;
    constexpr int most = 10;
    if (complaints_ > most) lines_.add(where_, title_ + ": ... and " + std::to_string(complaints_ - most) + " more");
    lines_.add(where_, title_ + ": " + remedy);
    lines_.raise();
  }

  void areas() {
    Vec3<double> low = surface_.points[0], high = low;
    for (const auto& p : surface_.points)
      for (int a = 0; a < 3; ++a) {
        low[a] = std::min(low[a], p[a]);
        high[a] = std::max(high[a], p[a]);
      }
    const double extent = norm(high - low);
    for (int t = 0; t < count_; ++t) {
      const auto& corners = surface_.triangles[t];
      double longest = 0;
      for (int i = 0; i < 3; ++i)
        longest = std::max(longest, norm(surface_.points[corners[i]] - surface_.points[corners[(i + 1) % 3]]));
      const double height = longest > 0 ? norm(twice_area(surface_, t)) / longest : 0;
      constexpr double smallest = 1e-9;
      if (height <= smallest * extent)
        complain(facet(t) + " has no area: its corners lie on a line, " + place_text(surface_.points[corners[0]]) +
                 ", " + place_text(surface_.points[corners[1]]) + ", " + place_text(surface_.points[corners[2]]));
    }
    raise("remove facets without area where the surface was made");
  }

  void repeated_facets() {
    std::map<std::array<int, 3>, int> first;
    for (int t = 0; t < count_; ++t) {
      auto key = surface_.triangles[t];
      std::sort(key.begin(), key.end());
      const auto [at, fresh] = first.try_emplace(key, t);
      if (!fresh) complain(facet(t) + " has the same corners as facet " + std::to_string(surface_.facets[at->second]));
    }
    raise("give every facet once");
  }

  void edges() {
    for (int t = 0; t < count_; ++t)
      for (int i = 0; i < 3; ++i) {
        const int a = surface_.triangles[t][i], b = surface_.triangles[t][(i + 1) % 3];
        edges_.push_back({{std::min(a, b), std::max(a, b)}, t, a < b});
      }
    std::stable_sort(edges_.begin(), edges_.end(),
                     [](const TriangleEdge& a, const TriangleEdge& b) { return a.nodes < b.nodes; });
    for (std::size_t i = 0, end; i < edges_.size(); i = end) {
      for (end = i + 1; end < edges_.size() && edges_[end].nodes == edges_[i].nodes;) ++end;
      if (end - i == 1)
        complain("the surface is open: " + facet(edges_[i].triangle) + " has no neighbour along its edge from " +
                 edge(edges_[i].nodes));
      else if (end - i > 2)
        complain(std::to_string(end - i) + " facets meet at the edge from " + edge(edges_[i].nodes) +
                 ", the first is " + facet(edges_[i].triangle));
    }
    raise("every edge of a closed surface joins two facets, whose corners have the same coordinates to the last digit");
  }

  /// Whether two neighbours look to the same side of the surface: each runs along the edge its own way.
  static bool agree(const TriangleEdge& a, const TriangleEdge& b) { return a.forward != b.forward; }

  /// Shells, and in each the facets that look to the other side than most.
  void orientation() {
    std::vector<std::vector<std::pair<int, bool>>> neighbours(count_);
    for (std::size_t i = 0; i < edges_.size(); i += 2) {
      const auto &a = edges_[i], &b = edges_[i + 1];
      neighbours[a.triangle].emplace_back(b.triangle, agree(a, b));
      neighbours[b.triangle].emplace_back(a.triangle, agree(a, b));
    }
    shell_.assign(count_, -1);
    std::vector<char> as_first(count_, 0);
    for (int start = 0; start < count_; ++start) {
      if (shell_[start] >= 0) continue;
      std::vector<int> reached{start};
      shell_[start] = shells_found_;
      as_first[start] = 1;
      for (std::size_t k = 0; k < reached.size(); ++k)
        for (const auto& [t, same] : neighbours[reached[k]]) {
          const char side = same ? as_first[reached[k]] : static_cast<char>(1 - as_first[reached[k]]);
          if (shell_[t] < 0) {
            shell_[t] = shells_found_;
            as_first[t] = side;
            reached.push_back(t);
          } else if (as_first[t] != side) {
            complain("no outside can be told: the surface turns over on itself next to " + facet(t));
            raise("a body has a surface with an inside and an outside");
          }
        }
      const auto agreeing = std::count_if(reached.begin(), reached.end(), [&](int t) { return as_first[t] != 0; });
      const char most = 2 * agreeing >= static_cast<long>(reached.size()) ? 1 : 0;
      std::sort(reached.begin(), reached.end());
      for (const int t : reached)
        if (as_first[t] != most)
          complain(facet(t) + " is turned over: its corners run against those of its neighbours");
      ++shells_found_;
    }
    raise("order the corners of every facet counter-clockwise seen from outside");
  }

  void shells() {
    if (shells_found_ == 1) return;
    for (int shell = 1; shell < shells_found_; ++shell) {
      const int t = static_cast<int>(std::find(shell_.begin(), shell_.end(), shell) - shell_.begin());
      complain("shell " + std::to_string(shell + 1) + " of " + std::to_string(shells_found_) + " begins with " +
               facet(t));
    }
    raise("a solid is one closed shell, without cavities; give every shell its own file and solid");
  }

  /// Points where the surface touches itself: their facets form more than one fan.
  void pinched_points() {
    std::vector<std::vector<int>> around(surface_.points.size());
    for (int t = 0; t < count_; ++t)
      for (const int p : surface_.triangles[t]) around[p].push_back(t);
    // A walk from facet to facet over the edges at p reaches all of a fan.
    for (std::size_t p = 0; p < around.size(); ++p) {
      std::vector<int> reached{around[p][0]};
      for (std::size_t k = 0; k < reached.size(); ++k)
        for (const int t : around[p])
          if (std::find(reached.begin(), reached.end(), t) == reached.end() &&
              share_two(reached[k], t, static_cast<int>(p)))
            reached.push_back(t);
      if (reached.size() < around[p].size())
        complain("the surface touches itself at the point " + place_text(surface_.points[p]) + " of " +
                 facet(around[p][0]));
    }
    raise("move such parts apart or join them along a face");
  }
  /// Whether two triangles share the point p and another.
  bool share_two(int s, int t, int p) const {
    for (const int a : surface_.triangles[s])
      if (a != p && std::count(surface_.triangles[t].begin(), surface_.triangles[t].end(), a)) return true;
    return false;
  }

  void crossings() {
    for (const auto& [a, b] : self_intersections(surface_))
      complain("the surface crosses itself: " + facet(a) + " cuts " + facet(b));
    raise("repair the surface where it was made");
  }

  const FacetSurface& surface_;
  Where where_;
  std::string title_;
  int count_;
  std::vector<TriangleEdge> edges_;  ///< sorted by nodes
  std::vector<int> shell_;           ///< [triangles]
  int shells_found_ = 0;
  int complaints_ = 0;
  Complaints lines_;
};

}  // namespace

Vec3<double> twice_area(const FacetSurface& surface, int triangle) {
  const auto& [a, b, c] = surface.triangles[triangle];
  return cross(surface.points[b] - surface.points[a], surface.points[c] - surface.points[a]);
}

double enclosed_volume(const FacetSurface& surface) {
  double sum = 0;
  const auto& origin = surface.points[0];
  for (int t = 0; t < static_cast<int>(surface.triangles.size()); ++t)
    sum += dot(surface.points[surface.triangles[t][0]] - origin, twice_area(surface, t));
  return sum / 6;
}

double total_area(const FacetSurface& surface) {
  double sum = 0;
  for (int t = 0; t < static_cast<int>(surface.triangles.size()); ++t) sum += norm(twice_area(surface, t));
  return sum / 2;
}

bool check_closed(FacetSurface& surface, const Where& where, const std::string& title) {
  Check(surface, where, title).run();
  if (enclosed_volume(surface) > 0) return false;
  for (auto& triangle : surface.triangles) std::swap(triangle[1], triangle[2]);
  return true;
}

}  // namespace ashlar
