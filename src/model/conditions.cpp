#include "model/conditions.hpp"

#include <algorithm>

#include "model/in_time.hpp"

namespace ashlar {

namespace {

struct Entry {
  ActingCondition acting;
  int given = -1;  // stage that gave it; -1: before the first
};

std::vector<const Surface*> surfaces_of(const Model& model, const Condition& condition) {
  std::vector<const Surface*> surfaces;
  for (const std::string& name : condition.surfaces) {
    const Surface* surface = model.mesh.find_surface(name);
    if (!surface) throw DeckError(condition.where, condition.noun + ": there is no surface '" + name + "'");
    surfaces.push_back(surface);
  }
  return surfaces;
}

std::vector<int> regions_of(const Model& model, const Condition& condition) {
  std::vector<int> regions;
  const auto* source = std::get_if<HeatSource>(&condition.kind);
  if (!source) return regions;
  for (const std::string& name : source->regions.empty() ? model.mesh.region_names : source->regions) {
    regions.push_back(model.mesh.find_region(name));
    if (regions.back() < 0) throw DeckError(condition.where, condition.noun + ": there is no region '" + name + "'");
  }
  std::sort(regions.begin(), regions.end());
  regions.erase(std::unique(regions.begin(), regions.end()), regions.end());
  return regions;
}

/// Takes the surfaces, regions or place of `newer` away from entries of the same noun that earlier stages gave.
void replace_older(std::vector<Entry>& entries, const Entry& newer) {
  std::erase_if(entries, [&](Entry& old) {
    if (old.given >= newer.given || old.acting.condition->noun != newer.acting.condition->noun) return false;
    if (const auto* load = std::get_if<PointLoad>(&old.acting.condition->kind))
      return norm(load->at - std::get<PointLoad>(newer.acting.condition->kind).at) == 0;
    for (const Surface* taken : newer.acting.surfaces) std::erase(old.acting.surfaces, taken);
    for (const int taken : newer.acting.regions) std::erase(old.acting.regions, taken);
    return old.acting.surfaces.empty() && old.acting.regions.empty();
  });
}

}  // namespace

bool gives_heat(const Condition& c) {
  return std::holds_alternative<FixedTemperature>(c.kind) || std::holds_alternative<Convection>(c.kind) ||
         std::holds_alternative<Flux>(c.kind) || std::holds_alternative<HeatSource>(c.kind);
}

std::vector<ActingCondition> acting_conditions(const Model& model, int stage) {
  std::vector<Entry> entries;
  const auto give = [&](const Condition& condition, int given) {
    std::erase_if(entries, [&](const Entry& old) { return old.acting.condition == &condition; });
    Entry entry{{&condition, surfaces_of(model, condition), regions_of(model, condition)}, given};
    replace_older(entries, entry);
    entries.push_back(std::move(entry));
  };
  for (const Condition& condition : model.conditions)
    if (condition.everywhere) give(condition, -1);
  for (int s = 0; s <= stage; ++s) {
    for (const std::string& name : model.stages[s].remove)
      std::erase_if(entries, [&](const Entry& old) { return old.acting.condition->name == name; });
    for (const int index : model.stages[s].apply) give(model.conditions[index], s);
  }
  std::vector<ActingCondition> acting;
  for (Entry& entry : entries) acting.push_back(std::move(entry.acting));
  return acting;
}

std::vector<ActingCondition> at_moment(std::vector<ActingCondition> acting,
                                       const std::function<double(const InTime&)>& choose) {
  for (ActingCondition& a : acting) {
    if (a.condition->in_time.empty()) continue;
    a.held = std::make_shared<const Condition>(with_numbers(*a.condition, choose));
    a.condition = a.held.get();
  }
  return acting;
}

std::vector<ActingCondition> acting_conditions(const Model& model, int stage,
                                               const std::function<double(const InTime&)>& choose) {
  return at_moment(acting_conditions(model, stage), choose);
}

std::vector<ActingCondition> acting_conditions(const Model& model, int stage, double time) {
  return acting_conditions(model, stage, [&](const InTime& number) { return number.table.at(time); });
}

bool holds_at(const Condition& condition, const Vec3<double>& p) {
  if (!condition.line) return true;
  const auto& [from, to] = *condition.line;
  const Vec3<double> along = to - from;
  const double length = norm(along), share = std::clamp(dot(p - from, along) / (length * length), 0.0, 1.0);
  return norm(p - from - share * along) <= 1e-6 * length;
}

std::vector<const Material*> materials_by_region(const Model& model) {
  std::vector<const Material*> materials(model.mesh.region_names.size(), nullptr);
  for (const Material& material : model.materials)
    for (const std::string& region : material.regions) {
      const int r = model.mesh.find_region(region);
      if (r >= 0) materials[r] = &material;
    }
  Complaints complaints;
  for (std::size_t r = 0; r < materials.size(); ++r)
    if (!materials[r]) complaints.add(model.where, "region '" + model.mesh.region_names[r] + "' has no material");
  complaints.raise();
  return materials;
}

bool first_acts(const Model& model, int stage, const Condition& condition) {
  for (int s = 0; s < stage; ++s)
    for (const ActingCondition& a : acting_conditions(model, s))
      if (a.condition == &condition) return false;
  return true;
}

}  // namespace ashlar
