#include "model/select_surface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

#include "base/nearest_name.hpp"
#include "model/place_text.hpp"
#include "model/silhouette.hpp"

namespace ashlar {

namespace {

constexpr double rounding = 1e-9;  // of an angle in rad, or of the model's size

std::string quoted(const std::vector<std::string>& names) {
  std::string list;
  for (const auto& name : names) list += (list.empty() ? "'" : ", '") + name + "'";
  return list;
}

/// Angle between two directions, rad; accurate for small angles too.
double angle_between(const Vec3<double>& a, const Vec3<double>& b) { return std::atan2(norm(cross(a, b)), dot(a, b)); }

double degrees(double rad) { return rad * 180 / std::numbers::pi; }

Vec3<double> side_direction(int side) {
  Vec3<double> direction;
  direction[side / 2] = side % 2 ? 1 : -1;
  return direction;
}

/// Those of `facets` that are turned to the side within 30 degrees and not hidden by any of `body`.
std::vector<Facet> seen_from(const Mesh& mesh, int side, const std::vector<Facet>& facets,
                             const std::vector<Facet>& body) {
  const Silhouette silhouette(mesh, body, side);
  std::vector<Facet> seen;
  for (const auto& f : facets)
    if (angle_between(mesh.facet_area(f), side_direction(side)) <= std::numbers::pi / 6 + rounding &&
        !silhouette.hides(mesh.facet_centroid(f)))
      seen.push_back(f);
  return seen;
}

std::vector<Facet> without_repeats(const std::vector<Facet>& facets) {
  std::set<std::pair<int, int>> known;
  std::vector<Facet> once;
  for (const auto& f : facets)
    if (known.insert({f.element, f.face}).second) once.push_back(f);
  return once;
}

class Selection {
 public:
  Selection(const Mesh& mesh, const FaceGraph& faces, const SurfaceChoice& choice,
            std::span<const Interface> interfaces, std::span<const CoveredFace> covered)
      : mesh_(mesh), faces_(faces), choice_(choice), interfaces_(interfaces), covered_(covered), size_(mesh.extent()) {}

  std::vector<Facet> run() {
    find_regions();
    take_candidates();
    if (facets_.empty()) refuse(nothing_to_choose_from());
    if (!choice_.side.empty()) keep_sides();
    if (choice_.facing) keep_facing();
    if (choice_.box) keep_in_box();
    if (choice_.plane) keep_on_plane();
    return facets_;
  }

 private:
  [[noreturn]] void refuse(const std::string& why) const {
    throw DeckError(choice_.where, "surface '" + choice_.name + "' selects nothing: " + why);
  }
  std::string candidates() const {
    return std::to_string(facets_.size()) + (choice_.group.empty() ? " outer" : "") +
           (facets_.size() == 1 ? " face" : " faces") + (choice_.of.empty() ? "" : " of " + quoted(choice_.of));
  }

  void find_regions() {
    listed_.assign(mesh_.region_names.size(), choice_.of.empty());
    Complaints complaints;
    for (const auto& name : choice_.of) {
      const int region = mesh_.find_region(name);
      if (region < 0)
        complaints.add(choice_.where, "surface '" + choice_.name + "': there is no region '" + name + "'" +
                                          suggest_name(name, mesh_.region_names));
      else
        listed_[region] = true;
    }
    complaints.raise();
  }
  bool listed(const Facet& f) const { return listed_[mesh_.regions[f.element]]; }

  /// The regions that the joint ties.
  std::array<int, 2> tied_regions() const {
    std::vector<std::string> names;
    for (const Interface& i : interfaces_) {
      if (i.crackable) continue;
      if (i.name == choice_.joint) return {mesh_.find_region(i.regions[0]), mesh_.find_region(i.regions[1])};
      names.push_back(i.name);
    }
    throw DeckError(choice_.where, "surface '" + choice_.name + "': there is no joint '" + choice_.joint + "'" +
                                       suggest_name(choice_.joint, names));
  }

  void take_faces_of_joint() {
    const auto [one, other] = tied_regions();
    for (const auto& [a, b] : faces_.inner) {
      const int at_a = mesh_.regions[a.element], at_b = mesh_.regions[b.element];
      if (!(at_a == one && at_b == other) && !(at_a == other && at_b == one)) continue;
      if (listed(a)) facets_.push_back(a);
      if (listed(b)) facets_.push_back(b);
    }
    for (const CoveredFace& face : covered_)
      if (interfaces_[face.interface].name == choice_.joint && listed(face.facet)) facets_.push_back(face.facet);
  }

  void take_candidates() {
    if (!choice_.joint.empty()) return take_faces_of_joint();
    if (choice_.group.empty()) {
      std::copy_if(faces_.outer.begin(), faces_.outer.end(), std::back_inserter(facets_),
                   [&](const Facet& f) { return listed(f); });
      return;
    }
    std::vector<std::string> groups;
    for (const auto& surface : mesh_.surfaces) groups.push_back(surface.name);
    for (const auto& name : choice_.group) {
      const Surface* group = mesh_.find_surface(name);
      if (!group)
        throw DeckError(choice_.where, "surface '" + choice_.name + "': the meshes have no surface group '" + name +
                                           "'" + suggest_name(name, groups));
      std::copy_if(group->facets.begin(), group->facets.end(), std::back_inserter(facets_),
                   [&](const Facet& f) { return listed(f); });
    }
    facets_ = without_repeats(facets_);
  }

  std::string nothing_to_choose_from() const {
    if (!choice_.joint.empty())
      return "the joint '" + choice_.joint + "' has no faces" + (choice_.of.empty() ? "" : " of " + quoted(choice_.of));
    if (!choice_.group.empty())
      return "no face of the group " + quoted(choice_.group) + " belongs to " + quoted(choice_.of);
    std::set<std::string> neighbours;
    for (const auto& [a, b] : faces_.inner)
      if (listed(a) != listed(b))
        neighbours.insert(mesh_.region_names[mesh_.regions[listed(a) ? b.element : a.element]]);
    return "all faces of " + quoted(choice_.of) + " lie inside the model, against " +
           quoted({neighbours.begin(), neighbours.end()}) +
           "; surfaces are outer faces, or those of a joint: joint = \"...\"";
  }

  /// A hint if faces towards regions that are not listed would have passed the filter.
  template <class Keep>
  std::string inner_hint(Keep keep) const {
    for (const auto& [a, b] : faces_.inner) {
      if (listed(a) == listed(b)) continue;
      const auto& own = listed(a) ? a : b;
      if (keep(own))
        return "; faces that fit lie inside the model, against '" +
               mesh_.region_names[mesh_.regions[listed(a) ? b.element : a.element]] + "', at " +
               place_text(mesh_.facet_centroid(own)) +
               ": surfaces are outer faces; for pressure between two regions tie them by a joint and take its faces, "
               "joint = \"...\"";
    }
    return "";
  }

  void keep_sides() {
    std::vector<Facet> own;  // what may hide: all outer faces of the listed regions
    std::copy_if(faces_.outer.begin(), faces_.outer.end(), std::back_inserter(own),
                 [&](const Facet& f) { return listed(f); });
    std::vector<Facet> kept;
    for (const auto& name : choice_.side) {
      const auto at = std::find(side_names.begin(), side_names.end(), name);
      if (at == side_names.end())
        throw DeckError(choice_.where, "surface '" + choice_.name + "': there is no side '" + name + "'" +
                                           suggest_name(name, side_names));
      const int side = static_cast<int>(at - side_names.begin());
      const auto seen = seen_from(mesh_, side, facets_, own);
      if (seen.empty())
        refuse("none of the " + candidates() + " is seen from the " + name + " within 30 degrees" +
               existing_sides(own) + inner_hint([&](const Facet& f) {
                 return angle_between(mesh_.facet_area(f), side_direction(side)) <= std::numbers::pi / 6;
               }));
      kept.insert(kept.end(), seen.begin(), seen.end());
    }
    facets_ = without_repeats(kept);
  }

  std::string existing_sides(const std::vector<Facet>& own) const {
    std::string list;
    for (int side = 0; side < 6; ++side)
      if (!seen_from(mesh_, side, facets_, own).empty()) list += (list.empty() ? "" : ", ") + side_names[side];
    return list.empty() ? "; use 'facing' with a direction"
                        : "; it has " + list + " (or use 'facing' with a direction)";
  }

  /// Keeps the facets with distance <= reach; if none, `describe(nearest facet, its distance)` is the complaint.
  template <class Distance, class Describe>
  void keep_within(double reach, Distance distance, Describe describe) {
    std::vector<Facet> kept;
    Facet nearest;
    double smallest = std::numeric_limits<double>::infinity();
    for (const auto& f : facets_) {
      const double d = distance(f);
      if (d <= reach) kept.push_back(f);
      if (d < smallest) {
        smallest = d;
        nearest = f;
      }
    }
    if (kept.empty())
      refuse(describe(nearest, smallest) + inner_hint([&](const Facet& f) { return distance(f) <= reach; }));
    facets_ = kept;
  }

  void keep_facing() {
    const auto direction = *choice_.facing;
    if (!(norm(direction) > 0))
      throw DeckError(choice_.where,
                      "surface '" + choice_.name + "': 'facing' needs a direction, got " + place_text(direction));
    keep_within(
        choice_.within + rounding, [&](const Facet& f) { return angle_between(mesh_.facet_area(f), direction); },
        [&](const Facet& f, double angle) {
          const auto area = mesh_.facet_area(f);
          return "none of the " + candidates() + " faces " + place_text(direction) + " within " +
                 number_text(degrees(choice_.within)) + " degrees; the nearest faces " +
                 place_text((1 / norm(area)) * area) + ", " + number_text(degrees(angle)) + " degrees off, at " +
                 place_text(mesh_.facet_centroid(f));
        });
  }

  void keep_in_box() {
    const auto& [low, high] = *choice_.box;
    for (int a = 0; a < 3; ++a)
      if (!(low[a] <= high[a]))
        throw DeckError(choice_.where, "surface '" + choice_.name +
                                           "': 'box' goes from its low corner to its high one, got " + place_text(low) +
                                           " to " + place_text(high));
    keep_within(
        rounding * size_,
        [&](const Facet& f) {
          const auto p = mesh_.facet_centroid(f);
          Vec3<double> outside;
          for (int a = 0; a < 3; ++a) outside[a] = std::max({low[a] - p[a], 0.0, p[a] - high[a]});
          return norm(outside);
        },
        [&](const Facet& f, double distance) {
          return "none of the " + candidates() + " has its centre in the box " + place_text(low) + " to " +
                 place_text(high) + "; the nearest centre is " + number_text(distance) + " m outside, at " +
                 place_text(mesh_.facet_centroid(f));
        });
  }

  void keep_on_plane() {
    const auto& [point, direction] = *choice_.plane;
    if (!(norm(direction) > 0))
      throw DeckError(choice_.where,
                      "surface '" + choice_.name + "': 'plane' needs a normal, got " + place_text(direction));
    const auto normal = (1 / norm(direction)) * direction;
    keep_within(
        1e-6 * size_,
        [&](const Facet& f) {
          double farthest = 0;
          for (const int n : mesh_.facet_nodes(f))
            farthest = std::max(farthest, std::abs(dot(mesh_.points[n] - point, normal)));
          return farthest;
        },
        [&](const Facet& f, double distance) {
          return "none of the " + candidates() + " lies in the plane through " + place_text(point) + " with normal " +
                 place_text(normal) + "; the nearest reaches " + number_text(distance) + " m off it, at " +
                 place_text(mesh_.facet_centroid(f));
        });
  }

  const Mesh& mesh_;
  const FaceGraph& faces_;
  const SurfaceChoice& choice_;
  std::span<const Interface> interfaces_;
  std::span<const CoveredFace> covered_;
  double size_;
  std::vector<char> listed_;  ///< by region
  std::vector<Facet> facets_;
};

}  // namespace

std::vector<Facet> select_surface(const Mesh& mesh, const FaceGraph& faces, const SurfaceChoice& choice,
                                  std::span<const Interface> interfaces, std::span<const CoveredFace> covered) {
  return Selection(mesh, faces, choice, interfaces, covered).run();
}

std::vector<Surface> region_sides(const Mesh& mesh, const FaceGraph& faces, int region) {
  std::vector<Facet> own;
  std::copy_if(faces.outer.begin(), faces.outer.end(), std::back_inserter(own),
               [&](const Facet& f) { return mesh.regions[f.element] == region; });
  std::vector<Surface> sides;
  for (int side = 0; side < 6; ++side) {
    const auto facets = seen_from(mesh, side, own, own);
    if (!facets.empty()) sides.push_back({mesh.region_names[region] + "." + side_names[side], facets});
  }
  return sides;
}

}  // namespace ashlar
