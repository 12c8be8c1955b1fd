#include "model/contact/moving.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <span>

#include "model/contact/overlap_search.hpp"
#include "model/loads.hpp"
#include "physics/edge_crossing.hpp"
#include "physics/facet.hpp"
#include "physics/interface_laws/interface_laws.hpp"

namespace ashlar {

namespace {

constexpr double skin_share = 0.25;       ///< of the side of the smallest face
constexpr double one_way = 0.9;           ///< cosine between faces that one probe takes together
constexpr double edge_share = 0.5;        ///< of what a corner has of a face
constexpr double may_turn = 0.5;          ///< sine of the angle that faces may turn by until the next search
constexpr double flat_rim = 0.05;         ///< sine by which a rim of flat faces may dip
constexpr double faces_each_other = 0.1;  ///< least cosine between a probe's face and a triangle that it may touch

Vec3<double> triangle_area(const std::vector<int>& corner, int t, const std::vector<Vec3<double>>& places) {
  const Vec3<double>& a = places[corner[3 * t]];
  return 0.5 * cross(places[corner[3 * t + 1]] - a, places[corner[3 * t + 2]] - a);
}

/// m^2 that two edges press on each other with, of the one that has less; 0: they are too far apart or lie in a way
/// that they cannot touch before the next search.
double crossing_area(const ContactSurface& surface, const std::vector<Vec3<double>>& places,
                     const std::vector<Vec3<double>>& triangle_areas, int p, int t) {
  const int* const own = &surface.edge[4 * p];
  const int* const other = &surface.edge[4 * t];
  for (int i = 0; i < 2; ++i)
    if (own[i] == other[0] || own[i] == other[1]) return 0;
  const Vec3<double>&a = places[own[0]], &b = places[other[0]];
  const EdgeCrossing<double> crossing = cross_edges(a - b, places[own[1]] - b, places[own[2]] - b, places[own[3]] - b,
                                                    places[other[1]] - b, places[other[2]] - b, places[other[3]] - b);
  if (crossing.parallel || std::abs(crossing.gap) > 2 * surface.skin ||
      std::max(crossing.own_leans, crossing.other_leans) > may_turn)
    return 0;
  const double skin = 2 * surface.skin, own_skin = skin / norm(places[own[1]] - a);
  const double other_skin = skin / norm(places[other[1]] - b);
  if (crossing.own < -own_skin || crossing.own > 1 + own_skin || crossing.other < -other_skin ||
      crossing.other > 1 + other_skin)
    return 0;
  const auto seen = [&](int e, double way) {
    double sum = 0;
    for (int f = 2 * e; f < 2 * e + 2; ++f) {
      const Vec3<double>& face = triangle_areas[surface.edge_facet[f]];
      sum += surface.edge_area[f] * std::max(0.0, way * dot(face, crossing.normal) / norm(face));
    }
    return sum;
  };
  return std::min(seen(p, -1), seen(t, 1));
}

Box3 box_of(std::span<const int> nodes, const std::vector<Vec3<double>>& places) {
  Box3 box{places[nodes[0]], places[nodes[0]]};
  for (const int n : nodes.subspan(1))
    for (int i = 0; i < 3; ++i) {
      box.low[i] = std::min(box.low[i], places[n][i]);
      box.high[i] = std::max(box.high[i], places[n][i]);
    }
  return box;
}

/// Faces that no other element of the same block shares.
std::vector<Facet> block_faces(const Model& model, const Blocks& blocks) {
  const Mesh& mesh = model.mesh;
  std::map<std::vector<int>, std::vector<Facet>> by_nodes;
  for (int e = 0; e < mesh.element_count(); ++e)
    for (int f = 0; f < face_count(mesh.shapes[e]); ++f) {
      std::vector<int> nodes;
      for (const int k : face_corners(mesh.shapes[e], f)) nodes.push_back(blocks.corners[mesh.first_corner[e] + k]);
      std::sort(nodes.begin(), nodes.end());
      by_nodes[nodes].push_back({e, f});
    }
  std::vector<Facet> faces;
  for (const auto& [nodes, owners] : by_nodes)
    if (owners.size() == 1) faces.push_back(owners[0]);
  std::sort(faces.begin(), faces.end(), before);
  return faces;
}

/// Edges that go on in nearly one direction are pieces of one long edge.
void find_long_edges(ContactSurface& s, const std::vector<Vec3<double>>& places) {
  std::vector<std::vector<int>> edges_at(places.size());
  for (int e = 0; e < s.edge_count(); ++e)
    for (int end = 0; end < 2; ++end) edges_at[s.edge[4 * e + end]].push_back(e);
  s.edge_ends.assign(2 * static_cast<std::size_t>(s.edge_count()), 1);
  s.long_edge.assign(s.edge_count(), -1);
  int count = 0;
  for (int seed = 0; seed < s.edge_count(); ++seed) {
    if (s.long_edge[seed] >= 0) continue;
    s.long_edge[seed] = count;
    for (int side = 0; side < 2; ++side) {
      const Vec3<double> along = places[s.edge[4 * seed + side]] - places[s.edge[4 * seed + 1 - side]];
      for (int last = seed, end = side, next = seed; next >= 0;) {
        const int node = s.edge[4 * last + end];
        next = -1;
        for (const int e : edges_at[node]) {
          if (s.long_edge[e] >= 0) continue;
          const Vec3<double> on = places[s.edge[4 * e] == node ? s.edge[4 * e + 1] : s.edge[4 * e]] - places[node];
          if (dot(on, along) > one_way * norm(on) * norm(along)) next = e;
        }
        if (next < 0) break;
        const int near = s.edge[4 * next] == node ? 0 : 1;
        s.edge_ends[2 * last + end] = s.edge_ends[2 * next + near] = 0;
        s.long_edge[next] = count;
        last = next;
        end = 1 - near;
      }
    }
    ++count;
  }
}

/// How much of the interface's stiffness a probe presses on a face with.
double share_of_stiffness(const ContactSurface& surface, int p, int t) {
  double own = 0;
  const int first = surface.first_facet[p], end = surface.first_facet[p + 1];
  for (int f = first; f < end; ++f) own += surface.face_area[surface.facet[f]] / (end - first);
  const double share = std::clamp(3 * surface.face_area[t] / (surface.face_area[t] + own) - 1, 0.0, 1.0);
  return surface.sharp[p] ? std::max(share, 0.5) : share;
}

}  // namespace

std::vector<int> interface_of_regions(const Model& model) {
  const int regions = static_cast<int>(model.mesh.region_names.size());
  std::vector<int> of(regions * regions, -1);
  const auto claim = [&](int a, int b, int interface) {
    for (int* at : {&of[a * regions + b], &of[b * regions + a]})
      if (*at < 0) *at = interface;
  };
  std::vector<int> crackable(regions, -1);
  for (int i = 0; i < static_cast<int>(model.interfaces.size()); ++i) {
    const Interface& declared = model.interfaces[i];
    std::vector<int> named;
    for (const std::string& name : declared.regions) named.push_back(model.mesh.find_region(name));
    if (std::count(named.begin(), named.end(), -1) > 0) continue;  // refused elsewhere
    if (!declared.crackable) claim(named[0], named[1], i);
    for (const int r : named)
      if (declared.crackable) crackable[r] = i;
  }
  for (int a = 0; a < regions; ++a)
    for (int b = 0; b < regions; ++b)
      if (crackable[a] >= 0) claim(a, b, crackable[a]);
  for (int a = 0; a < regions; ++a) {
    int first = of[a * regions + a];
    for (int b = 0; b < regions && crackable[a] < 0; ++b)
      if (const int i = of[a * regions + b]; i >= 0 && (first < 0 || i < first)) first = i;
    of[a * regions + a] = first;
  }
  return of;
}

ContactSurface contact_surface(const Model& model, const Blocks& blocks, const Discretisation& discretisation) {
  const Mesh& mesh = model.mesh;
  ContactSurface s;
  s.interface = interface_of_regions(model);
  const int regions = s.regions = static_cast<int>(mesh.region_names.size());
  for (const Interface& i : model.interfaces) {
    const InterfaceConstants constants = interface_constants(i.law, i.values, i.where, i.name);
    s.laws.push_back(
        {constants.stiffness.normal_stiffness, constants.stiffness.shear_stiffness, constants.law.tan_friction});
  }
  struct Share {
    int triangle, block, region;
    std::array<int, 2> rim;
    double area;
    Vec3<double> normal;
  };
  struct Side {
    int triangle, further, block, region;
    double area;
    Vec3<double> normal;
  };
  std::map<std::array<int, 2>, std::vector<Side>> sides;        // of the edges, by the machine's numbers
  std::vector<std::vector<Share>> around(blocks.node_count());  // by the machine's numbers
  double smallest = std::numeric_limits<double>::infinity();
  for (const Facet& facet : block_faces(model, blocks)) {
    const int region = mesh.regions[facet.element], block = blocks.block_of_element[facet.element];
    const auto row = s.interface.begin() + static_cast<std::ptrdiff_t>(region) * regions;
    if (std::all_of(row, row + regions, [](int i) { return i < 0; })) continue;
    std::vector<int> nodes;
    for (const int k : face_corners(mesh.shapes[facet.element], facet.face))
      nodes.push_back(discretisation.blocks.new_node[blocks.corners[mesh.first_corner[facet.element] + k]]);
    std::array<double, 4> areas{};
    Vec3<double> whole;
    for (const FacetPoint& point : facet_points(facet_corners(mesh, facet))) {
      for (int i = 0; i < 4; ++i) areas[i] += point.shape[i] * norm(point.area);
      whole = whole + point.area;
    }
    if (nodes.size() == 3) areas[2] += areas[3];
    smallest = std::min(smallest, norm(whole));
    for (std::size_t i = 0; i < nodes.size(); ++i)
      around[nodes[i]].push_back({s.triangle_count(),
                                  block,
                                  region,
                                  {nodes[(i + 1) % nodes.size()], nodes[(i + nodes.size() - 1) % nodes.size()]},
                                  areas[i],
                                  (1 / norm(whole)) * whole});
    for (std::size_t i = 0, count = nodes.size(); i < count; ++i) {
      const int a = nodes[i], b = nodes[(i + 1) % count];
      sides[{std::min(a, b), std::max(a, b)}].push_back({s.triangle_count(), nodes[(i + 2) % count], block, region,
                                                         edge_share * norm(whole) / static_cast<double>(count),
                                                         (1 / norm(whole)) * whole});
    }
    for (std::size_t i = 1; i + 1 < nodes.size(); ++i) {
      s.corner.insert(s.corner.end(), {nodes[0], nodes[i], nodes[i + 1]});
      s.block.push_back(block);
      s.region.push_back(region);
      s.face_area.push_back(norm(whole));
    }
  }
  s.skin = skin_share * std::sqrt(smallest);
  for (int n = 0; n < static_cast<int>(around.size()); ++n)
    while (!around[n].empty()) {
      const Share first = around[n].front();
      s.probe_node.push_back(n);
      s.probe_block.push_back(first.block);
      s.probe_region.push_back(first.region);
      std::vector<Share> others;
      std::set<int> rim;
      double nearest = 1;  // cosine of the angle to the first face
      for (const Share& share : around[n]) {
        if (dot(share.normal, first.normal) < one_way || share.region != first.region) {
          others.push_back(share);
          continue;
        }
        s.facet.push_back(share.triangle);
        s.area.push_back(share.area);
        rim.insert(share.rim.begin(), share.rim.end());
        nearest = std::min(nearest, dot(share.normal, first.normal));
      }
      s.first_facet.push_back(static_cast<int>(s.facet.size()));
      s.rim.insert(s.rim.end(), rim.begin(), rim.end());
      s.first_rim.push_back(static_cast<int>(s.rim.size()));
      s.may_dip.push_back(flat_rim + std::sqrt(std::max(0.0, 1 - nearest * nearest)));
      s.sharp.push_back(!others.empty() || (s.probe_count() > 1 && s.probe_node[s.probe_count() - 2] == n));
      around[n] = std::move(others);
    }
  const std::vector<Vec3<double>>& places = discretisation.block_points;
  for (const auto& [nodes, faces] : sides) {
    if (faces.size() != 2 || faces[0].block != faces[1].block) continue;
    const bool hollow = dot(faces[0].normal, places[faces[1].further] - places[nodes[0]]) > 0;
    if (hollow || dot(faces[0].normal, faces[1].normal) >= one_way) continue;
    s.edge.insert(s.edge.end(), {nodes[0], nodes[1], faces[0].further, faces[1].further});
    s.edge_facet.insert(s.edge_facet.end(), {faces[0].triangle, faces[1].triangle});
    s.edge_area.insert(s.edge_area.end(), {faces[0].area, faces[1].area});
    s.edge_block.push_back(faces[0].block);
    s.edge_region.push_back(faces[0].region);
  }
  find_long_edges(s, places);
  return s;
}

ContactCandidates find_candidates(const ContactSurface& surface, const std::vector<Vec3<double>>& places) {
  const int triangles = surface.triangle_count(), probes = surface.probe_count();
  const int regions = surface.regions;
  std::vector<Box3> of_probes, of_triangles;
  const Vec3<double> skin{surface.skin, surface.skin, surface.skin};
  for (const int n : surface.probe_node) of_probes.push_back({places[n] - skin, places[n] + skin});
  std::vector<Vec3<double>> area;
  for (int t = 0; t < triangles; ++t) {
    of_triangles.push_back(box_of({&surface.corner[3 * t], 3}, places));
    area.push_back(triangle_area(surface.corner, t, places));
  }
  ContactCandidates found;
  int probe = 0;
  const auto begin_until = [&](int p) {
    for (; probe < p; ++probe) found.first.push_back(static_cast<int>(found.target.size()));
  };
  for (const auto& [p, t] : meeting_boxes(of_probes, of_triangles)) {
    if (surface.probe_block[p] == surface.block[t] && surface.probe_region[p] == surface.region[t]) continue;
    const int* const corner = &surface.corner[3 * t];
    if (std::find(corner, corner + 3, surface.probe_node[p]) != corner + 3) continue;
    const int law = surface.interface[surface.probe_region[p] * regions + surface.region[t]];
    if (law < 0) continue;
    const Vec3<double> normal = (1 / norm(area[t])) * area[t];
    if (std::abs(dot(places[surface.probe_node[p]] - places[surface.corner[3 * t]], normal)) > 2 * surface.skin)
      continue;
    double seen = 0, whole = 0;
    for (int f = surface.first_facet[p]; f < surface.first_facet[p + 1]; ++f) {
      const Vec3<double>& face = area[surface.facet[f]];
      seen -= surface.area[f] * dot(face, normal) / norm(face);
      whole += surface.area[f];
    }
    if (seen < faces_each_other * whole) continue;
    seen *= share_of_stiffness(surface, p, t);
    if (!(seen > 0)) continue;
    begin_until(p);
    found.own.push_back(surface.probe_node[p]);
    found.target.push_back(t);
    found.law.push_back(law);
    found.area.push_back(seen);
  }
  begin_until(probes);
  std::vector<Box3> of_edges, wider;
  for (int e = 0; e < surface.edge_count(); ++e) {
    of_edges.push_back(box_of({&surface.edge[4 * e], 2}, places));
    wider.push_back({of_edges[e].low - skin, of_edges[e].high + skin});
  }
  struct Crossing {
    int own, target, law;
    double area;
  };
  std::map<std::array<int, 2>, std::vector<Crossing>> crossings;
  for (const auto& [p, t] : meeting_boxes(wider, of_edges)) {
    if (surface.long_edge[p] >= surface.long_edge[t] ||
        (surface.edge_block[p] == surface.edge_block[t] && surface.edge_region[p] == surface.edge_region[t]))
      continue;
    const int law = surface.interface[surface.edge_region[p] * regions + surface.edge_region[t]];
    if (law < 0) continue;
    const double pressing = crossing_area(surface, places, area, p, t);
    if (pressing > 0) crossings[{surface.long_edge[p], surface.long_edge[t]}].push_back({p, t, law, pressing});
  }
  for (const auto& [pair, pieces] : crossings) {
    found.pairs.push_back(pair);
    for (const Crossing& c : pieces) {
      found.own.push_back(c.own);
      found.target.push_back(c.target);
      found.law.push_back(c.law);
      found.area.push_back(c.area);
    }
    found.first.push_back(static_cast<int>(found.target.size()));
  }
  return found;
}

std::vector<double> contact_stiffness(const ContactSurface& surface, int node_count) {
  const auto stiffest_of = [&](int region) {
    double stiffest = 0;
    for (int r = 0; r < surface.regions; ++r)
      if (const int law = surface.interface[region * surface.regions + r]; law >= 0)
        stiffest = std::max({stiffest, surface.laws[law].normal_stiffness, surface.laws[law].shear_stiffness});
    return stiffest;
  };
  std::vector<double> stiffness(node_count);
  for (int p = 0; p < surface.probe_count(); ++p) {
    double area = 0;
    for (int f = surface.first_facet[p]; f < surface.first_facet[p + 1]; ++f) area += surface.area[f];
    stiffness[surface.probe_node[p]] += 2 * stiffest_of(surface.probe_region[p]) * area;
  }
  for (int e = 0; e < surface.edge_count(); ++e) {
    const double area = surface.edge_area[2 * e] + surface.edge_area[2 * e + 1];
    for (int i = 0; i < 2; ++i) stiffness[surface.edge[4 * e + i]] += stiffest_of(surface.edge_region[e]) * area;
  }
  return stiffness;
}

}  // namespace ashlar
