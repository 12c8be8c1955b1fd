#include "cli/left_out.hpp"

#include <algorithm>

#include "model/contact/moving.hpp"

namespace ashlar {
namespace {

template <class Kind>
bool has_condition(const Model& model) {
  return std::any_of(model.conditions.begin(), model.conditions.end(),
                     [](const Condition& c) { return std::holds_alternative<Kind>(c.kind); });
}

/// Whether some water pressure presses on ground below its level: on facets that face upwards within 45 degrees.
bool water_rests_on_ground(const Model& model) {
  for (const Condition& condition : model.conditions) {
    const auto* water = std::get_if<WaterPressure>(&condition.kind);
    if (!water) continue;
    for (const std::string& name : condition.surfaces) {
      const Surface* surface = model.mesh.find_surface(name);
      if (!surface) continue;
      for (const Facet& facet : surface->facets) {
        const Vec3<double> area = model.mesh.facet_area(facet);
        if (area.z > 0.7 * norm(area) && model.mesh.facet_centroid(facet).z < water->level) return true;
      }
    }
  }
  return false;
}

/// "a and b, a and c": pairs of regions that nothing keeps apart when they move far.
std::string passing_pairs(const Model& model) {
  const std::vector<int> interface = interface_of_regions(model);
  const std::vector<std::string>& names = model.mesh.region_names;
  std::string pairs;
  for (std::size_t a = 0; a < names.size(); ++a)
    for (std::size_t b = a + 1; b < names.size(); ++b)
      if (interface[a * names.size() + b] < 0) pairs += (pairs.empty() ? "" : ", ") + names[a] + " and " + names[b];
  return pairs;
}

}  // namespace

std::vector<std::string> left_out(const Model& model) {
  std::vector<std::string> list;
  const bool breakable = !model.interfaces.empty();
  if (has_condition<WaterPressure>(model)) {
    list.push_back(has_condition<CrackWater>(model)
                       ? "pore pressure: water acts in joints and cracks, not inside the material"
                   : has_condition<Uplift>(model) ? "uplift inside: it acts on the faces given, not in cracks and pores"
                   : breakable ? "uplift: no water pressure acts in joints and cracks, nor in the pores"
                               : "uplift: no water pressure acts under the dam, nor in its pores");
    if (!water_rests_on_ground(model))
      list.push_back("reservoir floor load: the water does not weigh on the ground in front of the dam");
  }
  if (has_condition<Gravity>(model) && model.initial_stresses.empty())
    list.push_back("construction in lifts: gravity acts on the finished body at once");
  const bool thermal = std::any_of(model.stages.begin(), model.stages.end(), is_thermal);
  const bool passes = std::any_of(model.interfaces.begin(), model.interfaces.end(),
                                  [](const Interface& i) { return !i.resists_heat() && i.law != "elastic"; });
  if (thermal && passes) list.push_back("heat across cracks: open cracks conduct as sound concrete");
  if (has_large_displacement(model))
    if (const std::string pairs = passing_pairs(model); !pairs.empty())
      list.push_back("contact of " + pairs +
                     ": no joint or crackable names them together, they pass through each other");
  return list;
}

}  // namespace ashlar
