#include <algorithm>
#include <array>
#include <numeric>

#include "model/blocks.hpp"
#include "model/check_mesh.hpp"
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

/// Moduli of the elastic part of one region's material, Pa.
struct Moduli {
  double oedometric = 0, shear = 0;
};

std::vector<Moduli> moduli_of_regions(const Model& model) {
  std::vector<Moduli> moduli(model.mesh.region_names.size());
  for (const auto& material : model.materials)
    for (const auto& region : material.regions) {
      const int r = model.mesh.find_region(region);
      if (r < 0) continue;
      const auto elastic = make_law<Elastic>(material.values);
      moduli[r] = {elastic.oedometric(), elastic.shear()};
    }
  return moduli;
}

/// Integral of N_i sigma n dA over one facet, N, of a stress field in the element's region; n as the facet's.
std::array<Vec3<double>, 4> corner_forces(const Mesh& mesh, const Facet& facet, const InitialStressField& field) {
  std::array<Vec3<double>, 4> forces{};
  for (const auto& point : facet_points(facet_corners(mesh, facet))) {
    const Sym3<double> s = field.at(mesh.regions[facet.element], point.position);
    const Vec3<double>& n = point.area;
    const Vec3<double> force{s.xx * n.x + s.xy * n.y + s.zx * n.z, s.xy * n.x + s.yy * n.y + s.yz * n.z,
                             s.zx * n.x + s.yz * n.y + s.zz * n.z};
    for (int i = 0; i < 4; ++i) forces[i] = forces[i] + point.shape[i] * force;
  }
  if (face_corners(mesh.shapes[facet.element], facet.face).size() == 3) forces[2] = forces[2] + forces[3];
  return forces;
}

std::string what(const Interface& i) { return (i.crackable ? "crackable '" : "joint '") + i.name + "'"; }

}  // namespace

Vec3<double> ContactPoints::initial_gap(int c) const {
  if (initial_traction.empty()) return {};
  const Split<double> t = split(initial_traction[c], normal[c]);
  return (t.normal / normal_stiffness[c]) * normal[c] + (1 / shear_stiffness[c]) * t.shear;
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

  ContactPoints contacts;
  for (int f = 0; f < static_cast<int>(blocks.faces.size()); ++f) {
    const auto& face = blocks.faces[f];
    const auto nodes = mesh.facet_nodes(face.a);
    const auto areas = corner_areas(mesh, face.a);
    const double area = std::accumulate(areas.begin(), areas.begin() + nodes.size(), 0.0);
    const Vec3<double> along = mesh.facet_area(face.a);
    const Vec3<double> normal = (1 / norm(along)) * along;

    // An element's height normal to its face is its volume over the face's area; half of it lies on each side of its
    // middle.
    const double half_heights =
        (element_volume(mesh, face.a.element) + element_volume(mesh, face.b.element)) / (2 * area);
    const auto& a = moduli[mesh.regions[face.a.element]];
    const auto& b = moduli[mesh.regions[face.b.element]];
    const auto& given = constants[face.interface].stiffness;
    const double per_modulus = given.stiffness_factor / half_heights;
    const double normal_stiffness =
        given.normal_stiffness > 0 ? given.normal_stiffness : per_modulus * std::min(a.oedometric, b.oedometric);
    const double shear_stiffness =
        given.shear_stiffness > 0 ? given.shear_stiffness : per_modulus * std::min(a.shear, b.shear);
    if (!(normal_stiffness > 0 && shear_stiffness > 0))
      throw DeckError(model.interfaces[face.interface].where,
                      what(model.interfaces[face.interface]) + ": no stiffness, because region '" +
                          mesh.region_names[mesh.regions[(a.shear > 0 ? face.b : face.a).element]] +
                          "' has no material: give it one, or give normal_stiffness and shear_stiffness");

    // Both sides have their own stress there; the spring carries the mean, and the difference is out of balance.
    std::array<Vec3<double>, 4> initial{};
    if (initial_stress.any()) {
      const auto other_nodes = mesh.facet_nodes(face.b);
      const auto side_a = corner_forces(mesh, face.a, initial_stress);
      const auto side_b = corner_forces(mesh, face.b, initial_stress);
      for (std::size_t i = 0; i < nodes.size(); ++i) {
        const auto j = std::find(other_nodes.begin(), other_nodes.end(), nodes[i]) - other_nodes.begin();
        initial[i] = (0.5 / areas[i]) * (side_a[i] - side_b[j]);
      }
    }
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (initial_stress.any()) contacts.initial_traction.push_back(initial[i]);
      contacts.node_a.push_back(block_node(face.a.element, nodes[i]));
      contacts.node_b.push_back(block_node(face.b.element, nodes[i]));
      contacts.face.push_back(f);
      contacts.interface.push_back(face.interface);
      contacts.normal.push_back(normal);
      contacts.area.push_back(areas[i]);
      contacts.normal_stiffness.push_back(normal_stiffness);
      contacts.shear_stiffness.push_back(shear_stiffness);
    }
  }
  return contacts;
}

}  // namespace ashlar
