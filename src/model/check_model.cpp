#include <algorithm>
#include <cstdio>
#include <map>
#include <set>

#include "base/nearest_name.hpp"
#include "model/conditions.hpp"
#include "model/contact/moving.hpp"
#include "model/element_measures.hpp"
#include "model/in_time.hpp"
#include "model/initial_stress.hpp"
#include "model/loads.hpp"
#include "model/locate.hpp"
#include "model/loose_bodies.hpp"
#include "model/model.hpp"
#include "model/place_text.hpp"
#include "physics/interface_laws/interface_laws.hpp"
#include "physics/laws/laws.hpp"

namespace ashlar {
namespace {

std::string title(const std::string& noun, const std::string& name) {
  return name.empty() ? noun : noun + " '" + name + "'";
}

std::string listed(const std::vector<std::string>& names) {
  std::string all;
  for (const auto& name : names) all += (all.empty() ? "'" : ", '") + name + "'";
  return all;
}

class ModelCheck {
 public:
  explicit ModelCheck(const Model& model) : model_(model) {
    for (const auto& s : model.mesh.surfaces) surfaces_.push_back(s.name);
    for (const auto& s : model.stages) stages_.push_back(s.name);
  }

  void run() {
    materials();
    interfaces();
    spring_regions();
    condition_references();
    collect([&] { InitialStressField{model_}; });
    stages();
    histories_and_pictures();
    complaints_.raise();
    // What follows needs every name to be right.
    idle_conditions();
    cracks_in_motion();
    functions();
    block_lengths();
    crack_spacings();
    supports();
    complaints_.raise();
  }

 private:
  void region(const std::string& name, const Where& where, const std::string& who) {
    if (model_.mesh.find_region(name) < 0)
      complaints_.add(where,
                      who + ": there is no region '" + name + "'" + suggest_name(name, model_.mesh.region_names));
  }
  void surface(const std::string& name, const Where& where, const std::string& who) {
    if (!model_.mesh.find_surface(name))
      complaints_.add(where, who + ": there is no surface '" + name + "'" + suggest_name(name, surfaces_));
  }
  void outer(const std::string& name, const Where& where, const std::string& who) {
    for (const SurfaceChoice& choice : model_.surfaces)
      if (choice.name == name && !choice.joint.empty())
        complaints_.add(where, who + ": acts on outer faces; surface '" + name + "' lies in joint '" + choice.joint +
                                   "', where pressures act, such as uplift");
  }
  void stage(const std::string& name, const Where& where, const std::string& who) {
    if (std::find(stages_.begin(), stages_.end(), name) == stages_.end())
      complaints_.add(where, who + ": there is no stage '" + name + "'" + suggest_name(name, stages_));
  }

  void materials() {
    std::map<std::string, const Material*> owner;
    for (const auto& material : model_.materials)
      for (const auto& name : material.regions) {
        region(name, material.where, title("material", material.name));
        const auto [other, fresh] = owner.emplace(name, &material);
        if (!fresh)
          complaints_.add(material.where, title("material", material.name) + ": region '" + name +
                                              "' is made of material '" + other->second->name + "' already");
      }
    for (const auto& name : model_.mesh.region_names)
      if (!owner.contains(name))
        complaints_.add(declared(name), "region '" + name + "' has no material; write material \"...\" { region = \"" +
                                            name + "\", ... }");
  }

  /// Blocks that would snap back as they crack.
  void block_lengths() {
    std::map<const Material*, int> longest;
    const auto material_of = materials_by_region(model_);
    const auto across = [&](int e) {
      const Vec3<double> lengths = lengths_across(model_.mesh, e);
      return std::max({lengths.x, lengths.y, lengths.z});
    };
    for (int e = 0; e < model_.mesh.element_count(); ++e) {
      const Material* material = material_of[model_.mesh.regions[e]];
      if (measure(material->law) != Measure::damage) continue;
      const auto [at, fresh] = longest.emplace(material, e);
      constexpr double longer = 1 + 1e-9;  // of those alike but for rounding, the first
      if (!fresh && across(e) > longer * across(at->second)) at->second = e;
    }
    for (const auto& [material, e] : longest) {
      const double most = largest_length(make_block_law(material->law, material->values));
      if (across(e) <= most) continue;
      char sizes[120];
      std::snprintf(sizes, sizeof sizes, "up to %.4g m long, and above %.4g m", across(e), most);
      complaints_.add(material->where, title("material", material->name) + ": its elements are " + sizes +
                                           " they would snap back as they crack: refine the mesh, or give a higher "
                                           "fracture energy; the longest is at " +
                                           place_text(model_.mesh.centroid(e)));
    }
  }

  /// Cracks can be kept apart by no less than the blocks that they break.
  void crack_spacings() {
    for (const auto& material : model_.materials) {
      const auto spacing = material.values.find("crack_spacing");
      if (spacing == material.values.end() || !(spacing->second > 0)) continue;
      double widest = 0;
      for (int e = 0; e < model_.mesh.element_count(); ++e) {
        const auto& name = model_.mesh.region_names[model_.mesh.regions[e]];
        if (std::find(material.regions.begin(), material.regions.end(), name) == material.regions.end()) continue;
        const Vec3<double> lengths = lengths_across(model_.mesh, e);
        widest = std::max(widest, std::min({lengths.x, lengths.y, lengths.z}));
      }
      if (spacing->second >= 3 * widest) continue;
      char sizes[120];
      std::snprintf(sizes, sizeof sizes, "crack_spacing = %.4g m is less than three of its elements, of up to %.4g m",
                    spacing->second, widest);
      complaints_.add(material.where, title("material", material.name) + ": " + sizes +
                                          ": it would hold nothing beside a crack; give more, or refine the mesh");
    }
  }

  Where declared(const std::string& region) const {
    for (const auto& e : model_.extrudes)
      if (e.name == region) return e.where;
    for (const auto& b : model_.boxes)
      if (b.name == region) return b.where;
    for (const auto& i : model_.imports)
      if (i.mesh.find_region(region) >= 0) return i.where;
    return model_.where;
  }

  void interfaces() {
    for (const auto& i : model_.interfaces) {
      const std::string who = title(i.crackable ? "crackable" : "joint", i.name);
      for (const auto& name : i.regions) region(name, i.where, who);
      collect([&] { interface_constants(i.law, i.values, i.where, who); });
    }
  }

  /// Blocks of springs are blocks only where the region is cut.
  void spring_regions() {
    for (const auto& material : model_.materials) {
      if (material.law != DiscreteSpring::name) continue;
      for (const auto& name : material.regions) {
        const auto cuts = [&](const Interface& i) {
          return i.crackable && std::find(i.regions.begin(), i.regions.end(), name) != i.regions.end();
        };
        if (std::none_of(model_.interfaces.begin(), model_.interfaces.end(), cuts))
          complaints_.add(material.where, title("material", material.name) + ": region '" + name +
                                              "' is not cut into blocks; write crackable \"...\" { region = \"" + name +
                                              "\", law = \"elastic\" }, or a law that breaks");
      }
    }
  }

  void condition_references() {
    for (const auto& c : model_.conditions) {
      const std::string who = title(c.noun, c.name);
      for (const auto& name : c.surfaces) {
        surface(name, c.where, who);
        if (!is_surface_load(c) || std::holds_alternative<Traction>(c.kind)) outer(name, c.where, who);
      }
      if (c.line) on_line(c, who);
      if (const auto* water = std::get_if<CrackWater>(&c.kind)) cracks(water->interfaces, c.where, who);
      if (const auto* grout = std::get_if<Grouting>(&c.kind)) {
        cracks(grout->interfaces, c.where, who);
        for (const Interface& i : model_.interfaces)
          if (i.law == SofteningInterface::name && std::ranges::count(grout->interfaces, i.name))
            complaints_.add(c.where,
                            who + ": '" + i.name + "' softens; only frictional and brittle joints are grouted");
      }
      if (std::holds_alternative<Uplift>(c.kind)) uplift(c);
      if (const auto* load = std::get_if<PointLoad>(&c.kind)) inside(load->at, c.where, who);
      if (const auto* source = std::get_if<HeatSource>(&c.kind))
        for (const auto& name : source->regions) region(name, c.where, who);
      if (const auto* start = std::get_if<InitialTemperature>(&c.kind))
        for (const auto& name : start->regions) region(name, c.where, who);
    }
  }

  void cracks(const std::vector<std::string>& names, const Where& where, const std::string& who) {
    std::vector<std::string> known;
    for (const Interface& i : model_.interfaces) known.push_back(i.name);
    for (const auto& name : names) {
      const auto at = std::find(known.begin(), known.end(), name);
      if (at == known.end())
        complaints_.add(where, who + ": there is no joint or crackable '" + name + "'" + suggest_name(name, known));
      else if (model_.interfaces[at - known.begin()].law == ElasticInterface::name)
        complaints_.add(where, who + ": '" + name + "' never opens: its law is elastic");
    }
  }

  void on_line(const Condition& c, const std::string& who) {
    const auto& [from, to] = *c.line;
    if (norm(to - from) == 0) return complaints_.add(c.where, who + ": 'line' is between two different points");
    for (const auto& name : c.surfaces) {
      const Surface* surface = model_.mesh.find_surface(name);
      if (!surface) continue;
      for (const Facet& f : surface->facets)
        for (const int n : model_.mesh.facet_nodes(f))
          if (holds_at(c, model_.mesh.points[n])) return;
    }
    complaints_.add(
        c.where, who + ": no node of its surfaces lies on the line from " + place_text(from) + " to " + place_text(to));
  }

  void inside(const Vec3<double>& place, const Where& where, const std::string& who) {
    if (locate(model_.mesh, place)) return;
    const auto& near = model_.mesh.points[nearest_node(model_.mesh, place)];
    complaints_.add(
        where, who + ": " + place_text(place) + " is outside the body; the nearest node is at " + place_text(near));
  }

  void uplift(const Condition& c) {
    for (const auto& name : c.surfaces)
      if (const Surface* surface = model_.mesh.find_surface(name))
        collect([&] {
          std::vector<double> force(3 * model_.mesh.points.size(), 0);
          add_uplift(model_.mesh, model_.mesh.corners, *surface, std::get<Uplift>(c.kind), c.where, force);
        });
  }

  /// The energy balance of a motion takes blocks for elastic.
  void motion(const Stage& stage) {
    for (const auto& material : model_.materials)
      if (measure(material.law) != Measure::none)
        complaints_.add(stage.where, title("stage", stage.name) + ": dynamic stages take elastic materials only, and " +
                                         title("material", material.name) + " is " + material.law);
    if (std::get<DynamicSolve>(stage.solve).large_displacement) large_displacement(stage);
  }

  /// What blocks that move far can be made of, meet by and be loaded with.
  void large_displacement(const Stage& stage) {
    const std::string who = title("stage", stage.name) + ": large_displacement ";
    const int index = static_cast<int>(&stage - model_.stages.data());
    for (const auto& material : model_.materials)
      if (material.law != "elastic" || material.bbar.value_or(false))
        complaints_.add(material.where, title("material", material.name) + ": stage '" + stage.name +
                                            "' with large_displacement takes law = \"elastic\" and formulation = " +
                                            "\"full\" only");
    for (const auto& i : model_.interfaces) {
      const std::string other = title(i.crackable ? "crackable" : "joint", i.name);
      if (i.law != "frictional")
        complaints_.add(i.where, other + ": stage '" + stage.name + "' with large_displacement takes law = " +
                                     "\"frictional\" only: a bond would have to turn with its blocks");
      for (const char* key : {"normal_stiffness", "shear_stiffness"})
        if (const auto given = i.values.find(key);
            i.law == "frictional" && (given == i.values.end() || given->second <= 0))
          complaints_.add(i.where, other + ": missing '" + key + "' [Pa/m], which stage '" + stage.name +
                                       "' with large_displacement needs: where blocks will meet is not known before");
      if (i.opening > 0)
        complaints_.add(i.where, other + ": 'initial_opening' does not go with large_displacement in stage '" +
                                     stage.name + "'; leave a gap between the bodies");
    }
    const bool first = std::none_of(model_.stages.begin(), model_.stages.begin() + index, [](const Stage& s) {
      const auto* d = std::get_if<DynamicSolve>(&s.solve);
      return d && d->large_displacement;
    });
    if (const auto inside = first ? node_inside(model_.mesh, interface_of_regions(model_)) : std::nullopt) {
      const Vec3<double>& p = model_.mesh.points[inside->node];
      complaints_.add(stage.where, who + "needs bodies beside each other: a corner at (" + number_text(p.x) + ", " +
                                       number_text(p.y) + ", " + number_text(p.z) + ") m is inside region '" +
                                       model_.mesh.region_names[model_.mesh.regions[inside->element]] +
                                       "', and nothing would push it out");
    }
    if (!model_.initial_stresses.empty())
      complaints_.add(stage.where, who + "does not go with initial_stress; bring loads on in time instead");
    for (const ActingCondition& a : acting_conditions(model_, index)) {
      const auto& kind = a.condition->kind;
      if (std::holds_alternative<TemperatureField>(kind) || std::holds_alternative<InitialTemperature>(kind))
        complaints_.add(a.condition->where, title(a.condition->noun, a.condition->name) + ": stage '" + stage.name +
                                                "' with large_displacement takes no temperature");
      if (std::holds_alternative<WaterPressure>(kind) || std::holds_alternative<Pressure>(kind) ||
          std::holds_alternative<Uplift>(kind) || std::holds_alternative<CrackWater>(kind))
        complaints_.add(a.condition->where,
                        title(a.condition->noun, a.condition->name) + ": stage '" + stage.name +
                            "' with large_displacement takes no pressure, whose faces would turn away; give traction, "
                            "which keeps its direction, or remove it with the stage");
    }
    for (const Stage& other : model_.stages)
      if (is_thermal(other))
        complaints_.add(stage.where, who + "takes no temperature, and stage '" + other.name + "' is thermal");
    if (index + 1 < static_cast<int>(model_.stages.size())) {
      const Stage& next = model_.stages[index + 1];
      const auto* motion = std::get_if<DynamicSolve>(&next.solve);
      if (!motion || !motion->large_displacement)
        complaints_.add(next.where, title("stage", next.name) + " comes after large_displacement in stage '" +
                                        stage.name + "': blocks may be anywhere by then; it has to be dynamic { " +
                                        "large_displacement = true } too");
    }
  }

  /// Something must be able to fail.
  void strength_reduction(const Stage& stage) {
    for (const auto& material : model_.materials)
      if (measure(material.law) != Measure::none) return;
    for (const auto& i : model_.interfaces)
      if (i.law != "elastic") return;
    complaints_.add(stage.where, title("stage", stage.name) + ": there is no strength to reduce: all materials and "
                                                              "interfaces are elastic");
  }

  void stages() {
    if (model_.stages.empty())
      complaints_.add(
          model_.where,
          "the model has no stage, so there is nothing to solve; write stage \"gravity\" { solve = static {} }");
    std::vector<std::string> names;
    for (const auto& c : model_.conditions)
      if (!c.name.empty() && std::find(names.begin(), names.end(), c.name) == names.end()) names.push_back(c.name);
    for (std::size_t s = 0; s < model_.stages.size(); ++s) {
      const Stage& stage = model_.stages[s];
      const std::string who = title("stage", stage.name);
      for (const auto& name : stage.remove) {
        std::set<std::string> nouns;
        for (const auto& c : model_.conditions)
          if (c.name == name) nouns.insert(title(c.noun, c.name));
        if (nouns.empty())
          complaints_.add(stage.where, who + ": cannot remove '" + name + "': no condition has this name" +
                                           suggest_name(name, names));
        if (nouns.size() > 1)
          complaints_.add(stage.where, who + ": remove '" + name + "' means both " + *nouns.begin() + " and " +
                                           *nouns.rbegin() + "; give them different names");
      }
      if (is_thermal(stage)) thermal_stage(stage);
      if (std::holds_alternative<DynamicSolve>(stage.solve)) motion(stage);
      if (std::holds_alternative<StrengthReduction>(stage.solve)) strength_reduction(stage);
      if (const auto* fracture = std::get_if<FractureSolve>(&stage.solve)) {
        if (fracture->from == fracture->to)
          complaints_.add(stage.where,
                          who + ": 'from' and 'to' are both '" + fracture->to +
                              "', so no temperature changes; leave 'from' out to start at the reference temperature");
        for (const auto& name : std::set{fracture->from, fracture->to})
          if (!name.empty()) earlier_temperature(name, s, who);
      }
    }
  }

  /// A fracture stage takes temperatures from the ends of earlier thermal stages.
  void earlier_temperature(const std::string& name, std::size_t stage, const std::string& who) {
    std::vector<std::string> valid;
    for (std::size_t s = 0; s < stage; ++s)
      if (is_thermal(model_.stages[s])) valid.push_back(model_.stages[s].name);
    if (std::find(valid.begin(), valid.end(), name) != valid.end()) return;
    const auto found = std::find(stages_.begin(), stages_.end(), name);
    const Where& where = model_.stages[stage].where;
    if (found == stages_.end())
      complaints_.add(where, who + ": there is no earlier thermal stage '" + name + "'" + suggest_name(name, valid));
    else if (found - stages_.begin() >= static_cast<long>(stage))
      complaints_.add(where, who + ": stage '" + name + "' must come before it");
    else
      complaints_.add(where, who + ": stage '" + name + "' is not thermal, so no temperature ends there");
  }

  void thermal_stage(const Stage& stage) {
    const auto* thermal = std::get_if<ThermalSolve>(&stage.solve);
    const bool steady = thermal && thermal->steady;
    for (const auto& material : model_.materials) {
      const auto need = [&](const char* key, const char* unit) {
        if (missing_.emplace(material.name, key).second)
          complaints_.add(material.where, title("material", material.name) + ": missing '" + key + "' [" + unit +
                                              "], which stage '" + stage.name + "' needs");
      };
      if (!material.conductivity) need("conductivity", "W/(m*K)");
      if (!material.heat_capacity && !steady) need("heat_capacity", "J/(kg*K)");
    }
  }

  void histories_and_pictures() {
    const bool moves = std::any_of(model_.stages.begin(), model_.stages.end(),
                                   [](const Stage& s) { return std::holds_alternative<DynamicSolve>(s.solve); });
    for (const auto& h : model_.histories) {
      const std::string who = title("history", h.name);
      for (const char* of_motion : {"velocity", "energy"})
        if (!moves && std::find(h.record.begin(), h.record.end(), of_motion) != h.record.end())
          complaints_.add(h.where, who + ": '" + of_motion + "' needs a stage with solve = dynamic {...}");
      if (!h.at) {
        if (!h.surface.empty()) surface(h.surface, h.where, who);
      } else {
        inside(*h.at, h.where, who);
      }
    }
    std::vector<std::string> written;
    for (const auto& output : model_.outputs) written.insert(written.end(), output.record.begin(), output.record.end());
    for (const auto& p : model_.pictures) {
      const std::string who = title("picture", p.name);
      if (!p.stage.empty()) stage(p.stage, p.where, who);
      std::vector<std::string> needed{p.of.substr(0, p.of.find('.'))};
      if (p.deform > 0 && needed[0] != "displacement") needed.push_back("displacement");
      for (const auto& field : needed)
        if (!written.empty() && std::find(written.begin(), written.end(), field) == written.end())
          complaints_.add(p.where, who + ": needs the field '" + field + "', which no output records");
    }
  }

  /// Conditions that no stage feels.
  void idle_conditions() {
    std::set<const Condition*> felt;
    for (std::size_t s = 0; s < model_.stages.size(); ++s)
      for (const auto& acting : acting_conditions(model_, static_cast<int>(s)))
        if (felt_by(*acting.condition, model_.stages[s])) felt.insert(acting.condition);
    for (const auto& c : model_.conditions)
      if (!felt.contains(&c))
        complaints_.add(c.where, title(c.noun, c.name) + " acts in no stage that could feel it: it needs " +
                                     (gives_heat(c) ? "a thermal or coupled stage" : "a static, fracture, dynamic or coupled stage") +
                                     "; add one or leave the condition out");
  }
  static bool felt_by(const Condition& c, const Stage& stage) {
    if (std::holds_alternative<InitialTemperature>(c.kind) || std::holds_alternative<TemperatureField>(c.kind))
      return true;
    return gives_heat(c) ? is_thermal(stage) : is_mechanical(stage);
  }

  /// Water in cracks keeps its level in motion.
  void cracks_in_motion() {
    const std::vector<StageTimes> times = stage_times(model_);
    for (std::size_t s = 0; s < model_.stages.size(); ++s) {
      if (!std::holds_alternative<DynamicSolve>(model_.stages[s].solve)) continue;
      for (const ActingCondition& a : acting_conditions(model_, static_cast<int>(s)))
        for (const InTime& number : a.condition->in_time)
          if (std::holds_alternative<CrackWater>(a.condition->kind) && changes(number.table, times[s]))
            complaints_.add(a.condition->where, title(a.condition->noun, a.condition->name) + ": '" + number.key +
                                                    "' changes during the dynamic stage '" + model_.stages[s].name +
                                                    "'; in cracks a level stays in motion");
    }
  }

  /// Asks every function of position once, those of time too at the start and the end: most mistakes show at once.
  void functions() {
    for (const auto& s : model_.initial_stresses)
      for (const auto& component : s.components) collect([&] { component(model_.mesh.points[0]); });
    for (const auto& c : model_.conditions) {
      functions_of(c);
      const bool moving = std::any_of(c.in_time.begin(), c.in_time.end(), [](const InTime& n) { return bool(n.field); });
      if (moving) functions_of(with_numbers(c, [](const InTime& number) { return number.table.value.back(); }));
    }
  }
  void functions_of(const Condition& c) {
    const Surface* surface = c.surfaces.empty() ? nullptr : model_.mesh.find_surface(c.surfaces[0]);
    const Vec3<double> point = surface ? model_.mesh.facet_centroid(surface->facets[0]) : model_.mesh.points[0];
    const auto ask = [&](const Value& value) { collect([&] { value(point); }); };
    if (const auto* d = std::get_if<Displacement>(&c.kind))
      for (const auto* value : {&d->x, &d->y, &d->z})
        if (*value) ask(**value);
    if (const auto* t = std::get_if<Traction>(&c.kind)) ask(t->x), ask(t->y), ask(t->z);
    if (const auto* p = std::get_if<Pressure>(&c.kind)) ask(p->value);
    if (const auto* t = std::get_if<FixedTemperature>(&c.kind)) ask(t->value);
    if (const auto* t = std::get_if<Convection>(&c.kind)) ask(t->ambient);
    if (const auto* f = std::get_if<Flux>(&c.kind)) ask(f->value);
    if (const auto* h = std::get_if<HeatSource>(&c.kind)) ask(h->value);
    if (const auto* t = std::get_if<InitialTemperature>(&c.kind)) ask(t->value);
    if (const auto* t = std::get_if<TemperatureField>(&c.kind)) ask(t->value);
  }

  /// Bodies that a stage leaves free, and steady heat without a given temperature.
  void supports() {
    const bool mechanical = std::any_of(model_.stages.begin(), model_.stages.end(), is_mechanical);
    Blocks blocks;
    collect([&] {
      if (mechanical || !model_.interfaces.empty()) blocks = split_blocks(model_, find_faces(model_.mesh));
    });
    if (!complaints_.empty()) return;
    for (std::size_t s = 0; s < model_.stages.size(); ++s) {
      const Stage& stage = model_.stages[s];
      if (std::holds_alternative<DynamicSolve>(stage.solve)) continue;  // free bodies fly
      if (is_mechanical(stage)) {
        const auto loose = loose_bodies(model_, blocks, static_cast<int>(s));
        for (std::size_t i = 0; i < loose.size() && i < 5; ++i)
          complaints_.add(stage.where, title("stage", stage.name) + ": nothing holds " +
                                           (loose[i].regions.size() == 1 ? "region " : "regions ") +
                                           listed(loose[i].regions) + " " + loose[i].movement +
                                           "; add a fix, or a joint to a body that is held");
        if (loose.size() > 5)
          complaints_.add(stage.where, title("stage", stage.name) + ": ... and " + std::to_string(loose.size() - 5) +
                                           " more bodies are free");
      } else if (std::get<ThermalSolve>(stage.solve).steady) {
        const auto acting = acting_conditions(model_, static_cast<int>(s));
        if (std::none_of(acting.begin(), acting.end(), [](const ActingCondition& a) {
              return std::holds_alternative<FixedTemperature>(a.condition->kind) ||
                     std::holds_alternative<Convection>(a.condition->kind);
            }))
          complaints_.add(stage.where,
                          title("stage", stage.name) + ": a steady state needs a fixed_temperature or a convection");
      }
      if (!complaints_.empty()) return;  // later stages would repeat it
    }
  }

  template <class Check>
  void collect(Check check) {
    try {
      check();
    } catch (const DeckError& error) {
      for (const auto& line : error.lines()) complaints_.add({}, line);
    }
  }

  const Model& model_;
  std::vector<std::string> surfaces_, stages_;
  std::set<std::pair<std::string, std::string>> missing_;  ///< material and key already complained about
  Complaints complaints_;
};

}  // namespace

void check_model(const Model& model) { ModelCheck(model).run(); }

}  // namespace ashlar
