#include "model/contact/heat_links.hpp"

#include <algorithm>

#include "model/check_mesh.hpp"
#include "model/conditions.hpp"

namespace ashlar {

std::vector<HeatLink> heat_links(const Model& model, const Blocks& blocks, const ContactPoints& contacts,
                                 const std::vector<double>& open) {
  constexpr double better = 10;  // than half of the elements beside it: hardly felt, and time steps stay long
  const Mesh& mesh = model.mesh;
  const std::vector<const Material*> materials = materials_by_region(model);
  const auto conductivity = [&](const Facet& f) { return materials[mesh.regions[f.element]]->conductivity.value_or(0); };
  const auto half_height = [&](const Facet& f) {
    return element_volume(mesh, f.element) / (2 * norm(mesh.facet_area(f)));
  };

  std::vector<HeatLink> links;
  for (int c = 0; c < contacts.count(); ++c) {
    HeatLink link;
    contacts.each_end(c, [&](int node, double weight) {
      link.nodes.push_back(blocks.mesh_node[node]);
      link.weights.push_back(weight);
    });
    if (link.nodes.size() == 2 && link.nodes[0] == link.nodes[1]) continue;
    const Interface& joint = model.interfaces[contacts.interface[c]];
    const InterfaceFace& face = blocks.faces[contacts.face[c]];
    const double own = better * std::min(conductivity(face.a), conductivity(face.b)) /
                       (half_height(face.a) + half_height(face.b));
    const double closed = joint.conductance > 0 ? joint.conductance : own;
    double passes = closed;
    if (joint.resists_heat()) {
      const double apart = joint.open_conductance.value_or(0);
      passes = open.empty() ? std::max(closed, apart) : closed + open[c] * (apart - closed);
    }
    link.conductance = contacts.area[c] * passes;
    links.push_back(std::move(link));
  }
  return links;
}

}  // namespace ashlar
