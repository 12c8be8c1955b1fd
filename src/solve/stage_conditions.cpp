#include "solve/stage_conditions.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include "model/in_time.hpp"
#include "model/loads.hpp"

namespace ashlar {

namespace {

/// The axis that a facet is perpendicular to. Throws DeckError if there is none.
int normal_axis(const Mesh& mesh, const Facet& facet, const Condition& condition, const Surface& surface) {
  const Vec3<double> n = mesh.facet_area(facet);
  const double size = norm(n);
  for (int axis = 0; axis < 3; ++axis)
    if (std::abs(n[axis]) > (1 - 1e-9) * size) return axis;
  const Vec3<double> at = mesh.facet_centroid(facet);
  char text[600];
  std::snprintf(text, sizeof text,
                "fix%s: 'normal' holds faces across x, y or z only, but surface '%s' has the normal (%.3g, %.3g, %.3g) at "
                "(%.6g, %.6g, %.6g); hold x, y and z, turn the model until the face lies across an axis, or put a held "
                "body behind the face, tied by a joint with law = \"elastic\" and shear_stiffness = 1*Pa/m, which lets "
                "it slide",
                condition.name.empty() ? "" : (" '" + condition.name + "'").c_str(), surface.name.c_str(), n.x / size,
                n.y / size, n.z / size, at.x, at.y, at.z);
  throw DeckError(condition.where, text);
}

void fix(const Problem& p, const Condition& condition, const Fix& f, const Surface& surface,
         MechanicalConditions& out) {
  const unsigned bits = (f.x ? 1u : 0u) | (f.y ? 2u : 0u) | (f.z ? 4u : 0u);
  for (const Facet& facet : surface.facets) {
    const unsigned all = f.normal ? bits | (1u << normal_axis(p.model.mesh, facet, condition, surface)) : bits;
    for (const int n : facet_nodes(p.model.mesh, p.blocks.corners, facet))
      if (holds_at(condition, p.model.mesh.points[p.blocks.mesh_node[n]]))
        out.fixed[n] = static_cast<double>(static_cast<unsigned>(out.fixed[n]) | all);
  }
}

void fill_cracks(const Problem& p, const CrackWater& water, std::vector<double>& pressure) {
  for (int c = 0; c < p.contacts.count(); ++c) {
    const std::string& name = p.model.interfaces[p.contacts.interface[c]].name;
    if (std::find(water.interfaces.begin(), water.interfaces.end(), name) == water.interfaces.end()) continue;
    pressure[c] += std::max(0.0, water.density * water.gravity * (water.level - p.place_of_contact(c).z));
  }
}

}  // namespace

MechanicalConditions mechanical_conditions(const Problem& p, int stage) {
  return mechanical_conditions(p, acting_conditions(p.model, stage, stage_times(p.model)[stage].begin));
}

MechanicalConditions mechanical_conditions(const Problem& p, const std::vector<ActingCondition>& acting) {
  const auto nodes = static_cast<std::size_t>(p.blocks.node_count());
  MechanicalConditions out;
  out.load.assign(3 * nodes, 0);
  out.surface_load.assign(3 * nodes, 0);
  out.fixed.assign(nodes, 0);
  add_loads(p.model, p.blocks.corners, acting, out.load);
  for (std::size_t i = 0; i < p.initial.force.size(); ++i) out.load[i] -= p.initial.force[i];

  out.crack_water.assign(p.contacts.count(), 0);
  std::vector<ActingCondition> on_surfaces;
  std::map<int, double> prescribed;
  for (const ActingCondition& a : acting) {
    if (is_surface_load(*a.condition)) on_surfaces.push_back(a);
    if (const auto* water = std::get_if<CrackWater>(&a.condition->kind)) fill_cracks(p, *water, out.crack_water);
    for (const Surface* surface : a.surfaces) {
      if (const auto* f = std::get_if<Fix>(&a.condition->kind)) fix(p, *a.condition, *f, *surface, out);
      if (const auto* d = std::get_if<Displacement>(&a.condition->kind)) {
        const std::optional<Value>* given[3] = {&d->x, &d->y, &d->z};
        for (const int n : surface_nodes(p.model.mesh, p.blocks.corners, *surface))
          for (int axis = 0; axis < 3; ++axis)
            if (*given[axis] && holds_at(*a.condition, p.model.mesh.points[p.blocks.mesh_node[n]]))
              prescribed[3 * n + axis] = (**given[axis])(p.model.mesh.points[p.blocks.mesh_node[n]]);
      }
    }
  }
  add_loads(p.model, p.blocks.corners, on_surfaces, out.surface_load);
  for (const auto& [component, value] : prescribed) {
    out.prescribed.push_back(component);
    out.displacement.push_back(value);
    const int n = component / 3;
    out.fixed[n] = static_cast<double>(static_cast<unsigned>(out.fixed[n]) | (1u << (component % 3)));
  }
  return out;
}

}  // namespace ashlar
