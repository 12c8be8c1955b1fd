#include "model/initial_stress.hpp"

#include "base/nearest_name.hpp"

namespace ashlar {

InitialStressField::InitialStressField(const Model& model)
    : model_(model), of_region_(model.mesh.region_names.size(), -1), density_(of_region_.size(), 0) {
  Complaints complaints;
  for (const Material& material : model.materials)
    for (const std::string& region : material.regions)
      if (const int r = model.mesh.find_region(region); r >= 0) density_[r] = material.density;
  for (std::size_t i = 0; i < model.initial_stresses.size(); ++i) {
    const InitialStress& given = model.initial_stresses[i];
    const std::string who = "initial_stress" + (given.name.empty() ? "" : " '" + given.name + "'");
    for (const std::string& region : given.regions.empty() ? model.mesh.region_names : given.regions) {
      const int r = model.mesh.find_region(region);
      if (r < 0)
        complaints.add(given.where,
                       who + ": there is no region '" + region + "'" + suggest_name(region, model.mesh.region_names));
      else if (of_region_[r] >= 0)
        complaints.add(given.where, who + ": region '" + region + "' has an initial stress already, from line " +
                                        std::to_string(model.initial_stresses[of_region_[r]].where.line));
      else
        of_region_[r] = static_cast<int>(i);
    }
  }
  complaints.raise();
}

Sym3<double> InitialStressField::at(int region, const Vec3<double>& p) const {
  if (of_region_[region] < 0) return {};
  const InitialStress& given = model_.initial_stresses[of_region_[region]];
  if (!given.in_situ) {
    Sym3<double> stress;
    for (int c = 0; c < 6; ++c) stress[c] = given.components[c](p);
    return stress;
  }
  const InSituStress& in_situ = *given.in_situ;
  const double weight = in_situ.unit_weight.value_or(in_situ.gravity * density_[region]);
  const double vertical = in_situ.vertical - weight * (in_situ.level - p.z);
  return {in_situ.k0_x * vertical, in_situ.k0_y * vertical, vertical, 0, 0, 0};
}

}  // namespace ashlar
