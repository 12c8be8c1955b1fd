#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>

#include "model/blocks.hpp"
#include "model/check_mesh.hpp"
#include "model/contact/scatter.hpp"
#include "model/initial_stress.hpp"
#include "model/loads.hpp"
#include "physics/interface_laws/interface_laws.hpp"
#include "physics/laws/laws.hpp"

namespace ashlar {

namespace {

/// Integral of every shape function over one facet, m^2, in the order of Mesh::facet_nodes.
std::array<double, 4> corner_areas(const Mesh& mesh, const Facet& facet) {
  std::array<double, 4> areas{};
  for (const auto& point : facet_points(facet_corners(mesh, facet)))
    for (int i = 0; i < 4; ++i) areas[i] += point.shape[i] * norm(point.area);
  if (face_corners(mesh.shapes[facet.element], facet.face).size() == 3) areas[2] += areas[3];
  return areas;
}

/// Moduli of the elastic part of one region's material, Pa, and its springs if it is made of them.
struct Moduli {
  double oedometric = 0, shear = 0;
  std::optional<DiscreteSpring> springs{};
};

std::vector<Moduli> moduli_of_regions(const Model& model) {
  std::vector<Moduli> moduli(model.mesh.region_names.size());
  for (const auto& material : model.materials)
    for (const auto& region : material.regions) {
      const int r = model.mesh.find_region(region);
      if (r < 0) continue;
      const auto elastic = make_law<Elastic>(material.values);
      moduli[r] = {elastic.oedometric(), elastic.shear()};
      if (material.law == DiscreteSpring::name) moduli[r].springs = make_law<DiscreteSpring>(material.values);
    }
  return moduli;
}

Vec3<double> traction(const Sym3<double>& s, const Vec3<double>& n) {
  return {s.xx * n.x + s.xy * n.y + s.zx * n.z, s.xy * n.x + s.yy * n.y + s.yz * n.z,
          s.zx * n.x + s.yz * n.y + s.zz * n.z};
}

/// Integral of N_i sigma n dA over one facet, N, of a stress field in the element's region; n as the facet's.
std::array<Vec3<double>, 4> corner_forces(const Mesh& mesh, const Facet& facet, const InitialStressField& field) {
  std::array<Vec3<double>, 4> forces{};
  for (const auto& point : facet_points(facet_corners(mesh, facet))) {
    const Vec3<double> force = traction(field.at(mesh.regions[facet.element], point.position), point.area);
    for (int i = 0; i < 4; ++i) forces[i] = forces[i] + point.shape[i] * force;
  }
  if (face_corners(mesh.shapes[facet.element], facet.face).size() == 3) forces[2] = forces[2] + forces[3];
  return forces;
}

/// One facet of an overlap.
struct OverlapSide {
  int element;
  std::vector<int> nodes;
  FacetCorners corners;

  OverlapSide(const Mesh& mesh, const Facet& f)
      : element(f.element), nodes(mesh.facet_nodes(f)), corners(facet_corners(mesh, f)) {}
  std::array<double, 4> shape_at(const Vec3<double>& p) const {
    return nodes.size() == 3 ? triangle_shape_at(corners, p) : facet_shape_at(corners, p);
  }
  /// Triangle or parallelogram: shape functions are polynomials of the place, of degree 2 at most.
  bool affine() const {
    const Vec3<double> bend = corners[0] - corners[1] + corners[2] - corners[3];
    return nodes.size() == 3 || norm(bend) < 1e-6 * norm(corners[2] - corners[0]);
  }
};

using Triangle = std::array<Vec3<double>, 3>;

/// The overlap cut into triangles, each of them into four where shape functions are no polynomials.
std::vector<Triangle> triangles_of(const Overlap& overlap, bool affine) {
  std::vector<Triangle> triangles;
  const std::vector<Vec3<double>>& p = overlap.polygon;
  for (std::size_t i = 1; i + 1 < p.size(); ++i) triangles.push_back({p[0], p[i], p[i + 1]});
  for (int round = 0; round < (affine ? 0 : 1); ++round) {
    std::vector<Triangle> finer;
    for (const Triangle& t : triangles) {
      const Triangle middle{0.5 * (t[0] + t[1]), 0.5 * (t[1] + t[2]), 0.5 * (t[2] + t[0])};
      finer.insert(finer.end(), {Triangle{t[0], middle[0], middle[2]}, Triangle{middle[0], t[1], middle[1]},
                                 Triangle{middle[2], middle[1], t[2]}, middle});
    }
    triangles = std::move(finer);
  }
  return triangles;
}

/// [faces] shares of the mean strength, drawn in the order of the faces; empty: nothing scatters.
std::vector<double> strength_of_faces(const Model& model, const Blocks& blocks) {
  std::vector<StrengthShares> shares;
  bool scatters = false;
  for (const Interface& i : model.interfaces) {
    shares.emplace_back(i.scatter);
    scatters = scatters || i.scatter.kind != Scatter::Kind::none;
  }
  if (!scatters) return {};
  std::vector<double> strength;
  for (const InterfaceFace& face : blocks.faces) strength.push_back(shares[face.interface].next());
  return strength;
}

std::string what(const Interface& i) { return (i.crackable ? "crackable '" : "joint '") + i.name + "'"; }

}  // namespace

Vec3<double> ContactPoints::initial_gap(int c) const {
  Vec3<double> gap;
  if (!initial_traction.empty()) {
    const Split<double> t = split(initial_traction[c], normal[c]);
    gap = (t.normal / normal_stiffness[c]) * normal[c] + (1 / shear_stiffness[c]) * t.shear;
  }
  return opening.empty() ? gap : gap + opening[c] * normal[c];
}

std::vector<double> ContactPoints::initial_gaps() const {
  std::vector<double> gaps;
  for (int c = 0; c < count() && has_initial_gap(); ++c) {
    const Vec3<double> gap = initial_gap(c);
    gaps.insert(gaps.end(), {gap.x, gap.y, gap.z});
  }
  return gaps;
}

ContactPoints place_contacts(const Model& model, const Blocks& blocks) {
  const Mesh& mesh = model.mesh;
  std::vector<InterfaceConstants> constants;
  for (const auto& i : model.interfaces) constants.push_back(interface_constants(i.law, i.values, i.where, what(i)));
  const auto moduli = moduli_of_regions(model);
  const InitialStressField initial_stress(model);

  const auto block_node = [&](int element, int mesh_node) {
    const auto nodes = mesh.element(element);
    const auto at = std::find(nodes.begin(), nodes.end(), mesh_node) - nodes.begin();
    return blocks.corners[mesh.first_corner[element] + at];
  };

  const auto to_centre = [&](const Facet& f) {
    const Vec3<double> area = mesh.facet_area(f);
    return std::abs(dot(mesh.facet_centroid(f) - mesh.centroid(f.element), area)) / norm(area);
  };
  const auto stiffness_of = [&](const InterfaceFace& face, double half_heights) {
    const auto& a = moduli[mesh.regions[face.a.element]];
    const auto& b = moduli[mesh.regions[face.b.element]];
    const auto& given = constants[face.interface].stiffness;
    const double ratio = constants[face.interface].stiffness_ratio;
    if (a.springs && b.springs) {
      const StiffnessKeys usual;
      for (const auto& [key, changed] : {std::pair{"stiffness_factor", given.stiffness_factor != usual.stiffness_factor},
                                         std::pair{"normal_stiffness", given.normal_stiffness > 0},
                                         std::pair{"shear_stiffness", given.shear_stiffness > 0}})
        if (changed)
          throw DeckError(model.interfaces[face.interface].where,
                          what(model.interfaces[face.interface]) + ": '" + key +
                              "' is of springs beside elastic blocks; those of a discrete_spring material have their "
                              "stiffness from its young and poisson: leave it out");
      const double from_a = to_centre(face.a), from_b = to_centre(face.b);
      const double normal = 1 / (from_a * a.springs->normal_compliance() + from_b * b.springs->normal_compliance());
      const double shear = 1 / (from_a * a.springs->shear_compliance() + from_b * b.springs->shear_compliance());
      return SpringStiffness<double>{normal, ratio > 0 ? ratio * normal : shear};
    }
    const double per_modulus = given.stiffness_factor / half_heights;
    SpringStiffness<double> stiffness{
        given.normal_stiffness > 0 ? given.normal_stiffness : per_modulus * std::min(a.oedometric, b.oedometric),
        given.shear_stiffness > 0 ? given.shear_stiffness : per_modulus * std::min(a.shear, b.shear)};
    if (ratio > 0) stiffness.shear = ratio * stiffness.normal;
    if (!(stiffness.normal > 0 && stiffness.shear > 0))
      throw DeckError(model.interfaces[face.interface].where,
                      what(model.interfaces[face.interface]) + ": no stiffness, because region '" +
                          mesh.region_names[mesh.regions[(a.shear > 0 ? face.b : face.a).element]] +
                          "' has no material: give it one, or give normal_stiffness and shear_stiffness");
    return stiffness;
  };

  const std::vector<double> strength = strength_of_faces(model, blocks);
  const bool opens =
      std::any_of(model.interfaces.begin(), model.interfaces.end(), [](const Interface& i) { return i.opening > 0; }) ||
      std::any_of(model.conditions.begin(), model.conditions.end(),
                  [](const Condition& c) { return std::holds_alternative<Grouting>(c.kind); });
  ContactPoints contacts;
  const auto add = [&](int f, const Vec3<double>& normal, double area, const SpringStiffness<double>& stiffness) {
    contacts.face.push_back(f);
    contacts.interface.push_back(blocks.faces[f].interface);
    contacts.normal.push_back(normal);
    contacts.area.push_back(area);
    contacts.normal_stiffness.push_back(stiffness.normal);
    contacts.shear_stiffness.push_back(stiffness.shear);
    if (!strength.empty()) contacts.strength.push_back(strength[f]);
    if (opens) contacts.opening.push_back(model.interfaces[blocks.faces[f].interface].opening);
    const SpringLaw<double>& law = constants[blocks.faces[f].interface].law;
    const Interface& declared = model.interfaces[blocks.faces[f].interface];
    if (law.softens())
      SofteningInterface::refuse_snap_back(law.with_strength(strength.empty() ? 1 : strength[f]), stiffness.normal,
                                           declared.where, what(declared));
  };
  for (int f = 0; f < blocks.coincident_count(); ++f) {
    const auto& face = blocks.faces[f];
    const auto nodes = mesh.facet_nodes(face.a), other_nodes = mesh.facet_nodes(face.b);
    const auto areas = corner_areas(mesh, face.a);
    const double area = std::accumulate(areas.begin(), areas.begin() + nodes.size(), 0.0);
    const Vec3<double> along = mesh.facet_area(face.a);
    const Vec3<double> normal = (1 / norm(along)) * along;

    // An element's height normal to its face is its volume over the face's area; half of it lies on each side of its
    // middle.
    const double half_heights =
        (element_volume(mesh, face.a.element) + element_volume(mesh, face.b.element)) / (2 * area);
    const SpringStiffness<double> stiffness = stiffness_of(face, half_heights);

    // Both sides have their own stress there; the spring carries the mean, and the difference is out of balance.
    std::array<Vec3<double>, 4> side_a{}, side_b{};
    if (initial_stress.any()) {
      side_a = corner_forces(mesh, face.a, initial_stress);
      side_b = corner_forces(mesh, face.b, initial_stress);
    }
    for (int i = 0; i < static_cast<int>(nodes.size()); ++i) {
      const int j = corner_on_corner(mesh, nodes[i], other_nodes);
      if (initial_stress.any()) contacts.initial_traction.push_back((0.5 / areas[i]) * (side_a[i] - side_b[j]));
      contacts.node_a.push_back(block_node(face.a.element, nodes[i]));
      contacts.node_b.push_back(block_node(face.b.element, other_nodes[j]));
      add(f, normal, areas[i], stiffness);
    }
  }

  for (int k = 0; k < static_cast<int>(blocks.overlaps.size()); ++k) {
    const int f = blocks.coincident_count() + k;
    const auto& face = blocks.faces[f];
    const Overlap& overlap = blocks.overlaps[k];
    const OverlapSide a(mesh, face.a), b(mesh, face.b);
    const SpringStiffness<double> stiffness =
        stiffness_of(face, 0.5 * (element_volume(mesh, face.a.element) / norm(mesh.facet_area(face.a)) +
                                  element_volume(mesh, face.b.element) / norm(mesh.facet_area(face.b))));
    for (const Triangle& triangle : triangles_of(overlap, a.affine() && b.affine())) {
      const double area = norm(cross(triangle[1] - triangle[0], triangle[2] - triangle[0])) / 2;
      if (!(area > 0)) continue;
      for (int i = 0; i < 3; ++i) {
        // The rule of degree 2 whose points lean to the corners.
        const Vec3<double> p = (2.0 / 3) * triangle[i] + (1.0 / 6) * (triangle[(i + 1) % 3] + triangle[(i + 2) % 3]);
        for (const auto& [side, sign] : {std::pair{&a, -1.0}, {&b, 1.0}}) {
          const auto shape = side->shape_at(p);
          for (std::size_t n = 0; n < side->nodes.size(); ++n) {
            contacts.end_node.push_back(block_node(side->element, side->nodes[n]));
            contacts.end_weight.push_back(sign * shape[n]);
          }
        }
        contacts.first_end.push_back(static_cast<int>(contacts.end_node.size()));
        contacts.corner.push_back(triangle[i]);
        if (initial_stress.any())
          contacts.initial_traction.push_back(
              0.5 * (traction(initial_stress.at(mesh.regions[face.a.element], p), overlap.normal) +
                     traction(initial_stress.at(mesh.regions[face.b.element], p), overlap.normal)));
        add(f, overlap.normal, area / 3, stiffness);
      }
    }
  }
  return contacts;
}

}  // namespace ashlar
