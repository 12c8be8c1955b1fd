#include "model/contact/moving.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "model/contact/overlap_search.hpp"
#include "model/loads.hpp"
#include "physics/facet.hpp"
#include "physics/interface_laws/interface_laws.hpp"

namespace ashlar {

namespace {

constexpr double skin_share = 0.25;       ///< of the side of the smallest face
constexpr double one_way = 0.9;           ///< cosine between faces that one probe takes together
constexpr double faces_each_other = 0.1;  ///< least cosine between a probe's face and a triangle that it may touch

Vec3<double> triangle_area(const std::vector<int>& corner, int t, const std::vector<Vec3<double>>& places) {
  const Vec3<double>& a = places[corner[3 * t]];
  return 0.5 * cross(places[corner[3 * t + 1]] - a, places[corner[3 * t + 2]] - a);
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
    double area;
    Vec3<double> normal;
  };
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
      around[nodes[i]].push_back({s.triangle_count(), block, region, areas[i], (1 / norm(whole)) * whole});
    for (std::size_t i = 1; i + 1 < nodes.size(); ++i) {
      s.corner.insert(s.corner.end(), {nodes[0], nodes[i], nodes[i + 1]});
      s.block.push_back(block);
      s.region.push_back(region);
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
      for (const Share& share : around[n]) {
        if (dot(share.normal, first.normal) < one_way || share.region != first.region) {
          others.push_back(share);
          continue;
        }
        s.facet.push_back(share.triangle);
        s.area.push_back(share.area);
      }
      s.first_facet.push_back(static_cast<int>(s.facet.size()));
      around[n] = std::move(others);
    }
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
    Box3 box{places[surface.corner[3 * t]], places[surface.corner[3 * t]]};
    for (int k = 1; k < 3; ++k)
      for (int i = 0; i < 3; ++i) {
        box.low[i] = std::min(box.low[i], places[surface.corner[3 * t + k]][i]);
        box.high[i] = std::max(box.high[i], places[surface.corner[3 * t + k]][i]);
      }
    of_triangles.push_back(box);
    area.push_back(triangle_area(surface.corner, t, places));
  }
  ContactCandidates found;
  int probe = 0;
  const auto begin_until = [&](int p) {
    for (; probe < p; ++probe) found.first.push_back(static_cast<int>(found.triangle.size()));
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
    begin_until(p);
    found.triangle.push_back(t);
    found.law.push_back(law);
    found.area.push_back(seen);
  }
  begin_until(probes);
  return found;
}

std::vector<double> contact_stiffness(const ContactSurface& surface, int node_count) {
  const int regions = surface.regions;
  std::vector<double> stiffness(node_count);
  for (int p = 0; p < surface.probe_count(); ++p) {
    double stiffest = 0, area = 0;
    for (int r = 0; r < regions; ++r)
      if (const int law = surface.interface[surface.probe_region[p] * regions + r]; law >= 0)
        stiffest = std::max({stiffest, surface.laws[law].normal_stiffness, surface.laws[law].shear_stiffness});
    for (int f = surface.first_facet[p]; f < surface.first_facet[p + 1]; ++f) area += surface.area[f];
    stiffness[surface.probe_node[p]] += 1.5 * stiffest * area;  // each side has half of the stiffness
  }
  return stiffness;
}

}  // namespace ashlar
