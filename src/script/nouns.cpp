#include <algorithm>
#include <cmath>
#include <regex>

#include "base/nearest_name.hpp"
#include "physics/laws/laws.hpp"
#include "script/deck_reader.hpp"

namespace ashlar {
namespace {

/// One noun call on its way into the model.
struct Call {
  Deck& deck;
  std::vector<Solve>& solves;
  const NounRule& noun;
  const std::string& name;
  const Fields& fields;

  Model& model() const { return deck.model; }
  void complain(const std::string& key, const std::string& message) const {
    deck.sandbox->complaints.add(fields.at(key), title(noun.name, name) + ": " + message);
  }
  /// Exactly one of the keys must be given.
  bool one_of(const std::vector<std::string>& keys) const {
    std::string all;
    int given = 0;
    for (const auto& key : keys) {
      all += (all.empty() ? "'" : &key == &keys.back() ? " or '" : ", '") + key + "'";
      given += fields.has(key);
    }
    if (given != 1) complain("", (given ? "give only one of " : "give ") + all);
    return given == 1;
  }
};

constexpr double most_elements = 1e9;

Shape shape(const Fields& f) {
  const auto text = f.text("elements");
  return text == "wedge6" ? Shape::wedge6 : text == "tet4" ? Shape::tet4 : Shape::hex8;
}

int add_extrude(const Call& c) {
  const Fields& f = c.fields;
  Extrude e;
  e.name = c.name;
  e.where = f.where;
  const auto section = f.numbers("section");
  for (std::size_t i = 0; i + 1 < section.size(); i += 2) e.section.push_back({section[i], section[i + 1]});
  e.y0 = f.number("from");
  e.length = f.number("length");
  e.size = f.number("size");
  e.layer_size = f.maybe("layer_size").value_or(0);
  e.layers = static_cast<int>(f.maybe("layers").value_or(0));
  for (double corner : f.numbers("corners")) e.corners.push_back(static_cast<int>(corner));
  if (f.has("corners") && (e.corners.size() != 4 ||
                           *std::max_element(e.corners.begin(), e.corners.end()) > static_cast<int>(e.section.size())))
    c.complain("corners",
               "'corners' names four points of the section, counted from 1 to " + std::to_string(e.section.size()));
  if (f.has("divisions"))
    for (const auto& [side, count] : f.renames("divisions")) {
      e.divisions[std::stoi(side)] = std::stoi(count);
      if (side.size() != 1 || side[0] < '1' || side[0] > '4')
        c.complain("divisions", "'divisions' has no side " + side + "; sides are 1 to 4");
    }
  if (f.has("holes")) e.holes = f.outlines("holes");
  e.hole_size = f.maybe("hole_size").value_or(0);
  e.grow = f.maybe("grow").value_or(0);
  e.structured = f.flag("structured");
  e.shape = shape(f);
  c.model().extrudes.push_back(e);
  return 0;
}

int add_box(const Call& c) {
  const Fields& f = c.fields;
  Box box;
  box.name = c.name;
  box.where = f.where;
  box.shape = shape(f);
  const auto from = f.vector("from"), to = f.vector("to");
  const auto cells = f.numbers("cells");
  if (!c.one_of({"cells", "size"})) return 0;
  if (f.has("cells") && cells.size() != 3)
    return c.complain("cells", "'cells' is three whole numbers, along x, y and z"), 0;
  for (int i = 0; i < 3; ++i) {
    box.from[i] = from[i];
    box.to[i] = to[i];
    if (!(from[i] < to[i]))
      c.complain("to", std::string("'to' must be larger than 'from' along ") + "xyz"[i] + "; they are " +
                           decimal_text(to[i]) + " and " + decimal_text(from[i]));
    const double count = f.has("cells") ? cells[i] : std::max(1.0, std::round((to[i] - from[i]) / f.number("size")));
    if (count > 1e6) c.complain("size", "'size' gives " + decimal_text(count) + " elements along one side");
    box.cells[i] = static_cast<int>(std::min(count, 1e6));
    box.bent[i] = f.maybe_value(std::string(1, "xyz"[i]));
  }
  const double elements = 1.0 * box.cells[0] * box.cells[1] * box.cells[2];
  if (elements > most_elements)
    c.complain(
        f.has("cells") ? "cells" : "size",
        "makes " + decimal_text(elements) + " elements; no machine holds more than " + decimal_text(most_elements));
  c.model().boxes.push_back(box);
  return 0;
}

int add_surface(const Call& c) {
  const Fields& f = c.fields;
  SurfaceChoice s;
  s.name = c.name;
  s.where = f.where;
  s.of = f.texts("of");
  s.side = f.texts("side");
  s.group = f.texts("group");
  s.joint = f.text("joint");
  if (!s.joint.empty() && (!s.group.empty() || !s.side.empty()))
    c.complain("joint", "'joint' takes the faces of a joint; it does not go with 'group' or 'side'");
  if (f.has("facing")) s.facing = f.vector("facing");
  if (s.facing && norm(*s.facing) == 0) c.complain("facing", "'facing' is no direction: all three values are 0");
  s.within = f.number("within");
  if (f.has("box")) s.box = {f.vector("box", 0), f.vector("box", 1)};
  if (f.has("plane")) {
    s.plane = {f.vector("plane", 0), f.vector("plane", 1)};
    if (norm(s.plane->second) == 0)
      c.complain("plane", "the normal of 'plane' is no direction: all three values are 0");
  }
  c.model().surfaces.push_back(s);
  return 0;
}

int add_interface(const Call& c) {
  const bool joint = c.noun.name == "joint";
  Interface i;
  i.name = c.name;
  i.where = c.fields.where;
  i.crackable = !joint;
  i.regions = c.fields.texts(joint ? "between" : "region");
  i.law = c.fields.text("law");
  i.values = c.fields.law_values;
  if (joint) i.tolerance = c.fields.maybe("tolerance").value_or(0);
  if (joint) i.conductance = c.fields.maybe("conductance").value_or(0);
  if (joint) i.open_conductance = c.fields.maybe("open_conductance");
  i.opening = c.fields.number("initial_opening");
  if (i.opening > 0 && i.law != "frictional")
    c.complain("initial_opening",
               "'initial_opening' is that of a frictional interface: law '" + i.law + "' is bonded from the start");
  if (c.fields.has("scatter")) {
    if (i.law != "brittle" && i.law != "softening")
      c.complain("scatter", "'scatter' is that of strength, which law '" + i.law + "' does not have");
    if (!c.fields.has("variation")) c.complain("", "missing 'variation': standard deviation of strength over its mean");
    i.scatter = {c.fields.text("scatter") == "weibull" ? Scatter::Kind::weibull : Scatter::Kind::normal,
                 c.fields.maybe("variation").value_or(0), c.fields.integer("seed")};
  } else if (c.fields.has("variation")) {
    c.complain("variation", "'variation' needs 'scatter', the distribution: \"weibull\" or \"normal\"");
  }
  if (joint && (i.regions.size() != 2 || i.regions[0] == i.regions[1]))
    c.complain("between", "'between' names two different regions: { \"dam\", \"rock\" }");
  c.model().interfaces.push_back(i);
  return 0;
}

int add_initial_stress(const Call& c) {
  const Fields& f = c.fields;
  InitialStress given{c.name, f.where, f.texts("region"), {}, {}};
  const char* components[] = {"xx", "yy", "zz", "xy", "yz", "zx"};
  std::string component;
  for (int i = 0; i < 6; ++i)
    if (const auto value = f.maybe_value(components[i])) {
      given.components[i] = *value;
      component = components[i];
    }
  if (f.has("level")) {
    if (!component.empty())
      c.complain(component, "'" + component + "' has no meaning beside 'level'; give level and k0, or components");
    if (!f.has("k0") && !(f.has("k0_x") && f.has("k0_y")))
      c.complain("", "missing 'k0': horizontal stress over vertical stress (or k0_x and k0_y)");
    const double k0 = f.maybe("k0").value_or(0);
    given.in_situ = InSituStress{f.number("level"),   f.number("vertical"),          f.maybe("unit_weight"),
                                 f.number("gravity"), f.maybe("k0_x").value_or(k0), f.maybe("k0_y").value_or(k0)};
  } else {
    bool told = false;
    for (const char* key : {"unit_weight", "k0", "k0_x", "k0_y"}) {
      if (!f.has(key)) continue;
      told = true;
      c.complain(key, std::string("'") + key + "' needs 'level' [m], the height z where the stress is 'vertical'");
    }
    if (component.empty() && !told) c.complain("", "gives no stress; give level and k0, or components xx, yy, zz, xy, yz, zx");
  }
  c.model().initial_stresses.push_back(given);
  return 0;
}

Uplift uplift(const Call& c) {
  const Fields& f = c.fields;
  if (f.has("drain") != f.has("drain_efficiency"))
    c.complain(f.has("drain") ? "drain" : "drain_efficiency",
               "'drain' [m] and 'drain_efficiency' [0 to 1] belong together; give both or none");
  if (f.has("gallery") && !f.has("drain"))
    c.complain("gallery", "'gallery' has no meaning without 'drain'; it is the floor that the drains empty onto");
  if (f.number("downstream_level") > f.number("upstream_level"))
    c.complain("downstream_level",
               "'downstream_level' is above 'upstream_level'; if the reservoir is on the right, swap 'heel' and 'toe'");
  return {f.number("upstream_level"),
          f.number("downstream_level"),
          f.maybe("heel"),
          f.maybe("toe"),
          f.maybe("drain"),
          f.maybe("drain_efficiency").value_or(0),
          f.maybe("gallery"),
          f.number("density"),
          f.number("gravity")};
}

Condition::Kind condition_kind(const Call& c) {
  const Fields& f = c.fields;
  const std::string& noun = c.noun.name;
  if (noun == "fix") {
    const Fix fix{f.has("x"), f.has("y"), f.has("z"), f.flag("normal")};
    if (!fix.x && !fix.y && !fix.z && !fix.normal)
      c.complain("", "holds nothing; give x = 0, y = 0, z = 0 or normal = true");
    return fix;
  }
  if (noun == "displacement") {
    if (!f.has("x") && !f.has("y") && !f.has("z")) c.complain("", "moves nothing; give x, y or z");
    return Displacement{f.maybe_value("x"), f.maybe_value("y"), f.maybe_value("z")};
  }
  if (noun == "gravity") {
    const Gravity gravity{{f.number("x"), f.number("y"), f.number("z")}};
    if (norm(gravity.acceleration) == 0 && f.in_time().empty()) c.complain("", "has no acceleration; give z = -9.81");
    return gravity;
  }
  if (noun == "water_pressure") return WaterPressure{f.number("level"), f.number("density"), f.number("gravity")};
  if (noun == "crack_water")
    return CrackWater{f.texts("of"), f.number("level"), f.number("density"), f.number("gravity")};
  if (noun == "grouting") return Grouting{f.texts("of")};
  if (noun == "traction") return Traction{f.value("x"), f.value("y"), f.value("z")};
  if (noun == "pressure") return Pressure{f.value("value")};
  if (noun == "uplift") return uplift(c);
  if (noun == "point_load") {
    const PointLoad load{f.vector("at"), {f.number("x"), f.number("y"), f.number("z")}};
    if (norm(load.force) == 0 && f.in_time().empty()) c.complain("", "has no force; give x, y or z");
    return load;
  }
  if (noun == "fixed_temperature") return FixedTemperature{f.value("value"), f.maybe("below"), f.maybe("above")};
  if (noun == "convection") return Convection{f.value("ambient"), f.number("film"), f.maybe("below"), f.maybe("above")};
  if (noun == "flux") return Flux{f.value("value")};
  if (noun == "heat_source") return HeatSource{f.value("value"), f.texts("region")};
  if (noun == "initial_temperature") return InitialTemperature{f.value("value"), f.texts("region")};
  return TemperatureField{f.value("value")};
}

int add_condition(const Call& c) {
  Condition condition;
  condition.noun = c.noun.name;
  condition.name = c.name;
  condition.where = c.fields.where;
  condition.surfaces = c.fields.texts("surface");
  condition.kind = condition_kind(c);
  if (c.fields.has("line")) condition.line = {c.fields.vector("line", 0), c.fields.vector("line", 1)};
  condition.in_time = c.fields.in_time();
  c.model().conditions.push_back(std::move(condition));
  return static_cast<int>(c.model().conditions.size()) - 1;
}

Relaxation relaxation(const Fields& f) {
  const auto damping = f.text("damping");
  return {f.number("tolerance"),
          damping == "local"     ? Damping::local
          : damping == "viscous" ? Damping::viscous
                                 : Damping::adaptive,
          f.maybe("damping_value").value_or(0),
          f.number("step_factor"),
          static_cast<long>(f.maybe("max_steps").value_or(0)),
          f.text("start") == "search"};
}

void add_strength_reduction(const Call& c) {
  const Fields& f = c.fields;
  StrengthReduction s;
  if (f.has("between")) {
    s.low = f.quantity("between", 0).value;
    s.high = f.quantity("between", 1).value;
    if (!(s.low > 0) || !(s.low < s.high))
      c.complain("between", "'between' is { lowest, highest } factor, such as { 1, 3 }; the lowest is above 0");
  }
  s.width = f.number("width");
  s.relaxation = relaxation(f);
  c.solves.emplace_back(s);
}

void add_coupled(const Call& c) {
  const Fields& f = c.fields;
  constexpr double most = 1e6;
  CoupledSolve s;
  s.duration = f.number("duration");
  s.every = f.maybe("every").value_or(s.duration / 12);
  s.increments = f.integer("increments");
  s.relaxation = relaxation(f);
  if (s.every > s.duration) c.complain("every", "'every' is longer than 'duration'");
  if (s.duration / s.every > most)
    c.complain("every", "'every' is so short that 'duration' would hold more than a million equilibria");
  c.solves.emplace_back(s);
}

int add_solve(const Call& c) {
  const Fields& f = c.fields;
  if (c.noun.name == "dynamic") {
    if (f.has("time_step") && f.has("time_factor")) c.complain("time_factor", "give either time_step or time_factor");
    if (f.flag("large_displacement") && f.number("stiffness_damping") > 0)
      c.complain("stiffness_damping",
                 "'stiffness_damping' does not go with large_displacement, where blocks turn; give contact_damping, "
                 "mass_damping or local_damping");
    if (!f.flag("large_displacement") && f.number("contact_damping") > 0)
      c.complain("contact_damping", "'contact_damping' needs large_displacement = true; give stiffness_damping");
    c.solves.emplace_back(DynamicSolve{f.number("duration"), f.number("local_damping"), f.number("mass_damping"),
                                       f.number("stiffness_damping"), f.maybe("time_step").value_or(0),
                                       f.maybe("time_factor").value_or(0), f.maybe("record_every").value_or(0),
                                       f.flag("large_displacement"), f.number("contact_damping")});
  } else if (c.noun.name == "thermal") {
    if (f.flag("steady") == f.has("duration")) c.complain("", "give either steady = true or a duration");
    if (f.flag("steady") && f.has("record_every"))
      c.complain("record_every", "'record_every' has no meaning for a steady state, which takes no time");
    c.solves.emplace_back(ThermalSolve{f.flag("steady"), f.maybe("duration").value_or(0), f.number("tolerance"),
                                       f.maybe("record_every").value_or(0)});
  } else {
    if (f.has("damping_value") && f.text("damping") == "adaptive")
      c.complain("damping_value",
                 "'damping_value' has no meaning for adaptive damping, which finds its own; give damping = \"local\" "
                 "or \"viscous\"");
    if (c.noun.name == "fracture")
      c.solves.emplace_back(FractureSolve{f.text("from"), f.text("to"), f.integer("increments"), relaxation(f),
                                          static_cast<long>(f.number("max_events")), f.number("event_group")});
    else if (c.noun.name == "strength_reduction")
      add_strength_reduction(c);
    else if (c.noun.name == "coupled")
      add_coupled(c);
    else
      c.solves.emplace_back(StaticSolve{relaxation(f), static_cast<int>(f.maybe("increments").value_or(0))});
  }
  return static_cast<int>(c.solves.size()) - 1;
}

int add_stage(const Call& c) {
  const Fields& f = c.fields;
  Stage stage;
  stage.name = c.name;
  stage.where = f.where;
  stage.remove = f.texts("remove");
  stage.reset_displacement = f.flag("reset_displacement");
  if (!f.handles("solve").empty()) stage.solve = c.solves[f.handles("solve")[0]];
  if (f.has("apply")) stage.apply = f.handles("apply");
  for (int index : stage.apply) c.model().conditions[index].everywhere = false;
  c.model().stages.push_back(stage);
  return 0;
}

int add_history(const Call& c) {
  const Fields& f = c.fields;
  History history{c.name, f.where, {}, f.text("surface"), f.texts("record")};
  const bool placed = f.has("at") || f.has("surface");
  const auto of_model = [](const std::string& name) {
    return std::any_of(recorded().begin(), recorded().end(),
                       [&](const Recorded& r) { return r.of_model && r.name == name; });
  };
  const bool whole = std::all_of(history.record.begin(), history.record.end(), of_model);
  if ((placed || !whole) && !c.one_of({"at", "surface"})) return 0;
  if (f.has("at")) history.at = f.vector("at");
  std::vector<std::string> valid;
  for (const auto& r : recorded())
    if (history.at ? r.at_point : placed ? r.on_surface : r.of_model) valid.push_back(r.name);
  for (const auto& name : history.record)
    if (std::find(valid.begin(), valid.end(), name) == valid.end())
      c.complain("record", "'" + name + "' is not recorded " + (history.at ? "at a point" : "over a surface") +
                               suggest_name(name, valid));
  c.model().histories.push_back(history);
  return 0;
}

int add_expect(const Call& c) {
  const Fields& f = c.fields;
  Expect e{c.name, f.where, f.text("history"), f.text("component"), f.text("stage"), {}, 0};
  if (!c.one_of({"between", "value", "that"})) return 0;
  if (f.has("that")) {
    for (const char* key : {"history", "component", "stage"})
      if (f.has(key))
        c.complain(
            key, std::string("'") + key + "' has no meaning beside 'that'; use result.history(name).at(column, stage)");
    e.function = f.function("that").reference;
    c.deck.expects.push_back(e);
    return 0;
  }
  for (const char* key : {"history", "component"})
    if (!f.has(key)) c.complain("", std::string("missing '") + key + "'");
  const std::string field = e.component.substr(0, e.component.find('.'));
  KeyRule rule;
  for (const auto& r : recorded())
    if (r.name == field) rule.dimension = r.dimension;
  const auto check = [&](const char* key, int i) {
    Quantity quantity = f.quantity(key, i);
    quantity.celsius |= std::string(key) == "tolerance";  // a difference of temperatures may be in K
    const std::string complaint = number_complaint(rule, quantity);
    if (!complaint.empty()) c.complain(key, std::string("'") + key + "' " + complaint);
  };
  if (f.has("between")) {
    check("between", 0);
    check("between", 1);
    e.between = {f.quantity("between", 0).value, f.quantity("between", 1).value};
    if (!((*e.between)[0] <= (*e.between)[1]))
      c.complain("between", "'between' is { lowest, highest }; the first value is the larger one");
  } else {
    check("value", 0);
    if (f.has("tolerance")) check("tolerance", 0);
    const double value = f.number("value");
    if (f.has("tolerance") == f.has("relative")) c.complain("value", "give 'tolerance' or 'relative' with 'value'");
    if (f.has("relative") && value == 0)
      c.complain("relative", "'relative' needs a value other than 0; give 'tolerance'");
    const double tolerance =
        f.has("tolerance") ? f.number("tolerance") : f.maybe("relative").value_or(0) * std::abs(value);
    if (tolerance < 0) c.complain("tolerance", "'tolerance' is negative");
    e.between = {value - tolerance, value + tolerance};
  }
  c.deck.expects.push_back(e);
  return 0;
}

}  // namespace

int add_to_deck(Deck& deck, std::vector<Solve>& solves, const NounRule& noun, const std::string& name,
                const Fields& f) {
  const Call call{deck, solves, noun, name, f};
  Model& model = deck.model;
  if (noun.kind == NounKind::condition) return add_condition(call);
  if (noun.kind == NounKind::solve) return add_solve(call);
  if (noun.name == "extrude") return add_extrude(call);
  if (noun.name == "box") return add_box(call);
  if (noun.name == "surface") return add_surface(call);
  if (noun.name == "joint" || noun.name == "crackable") return add_interface(call);
  if (noun.name == "initial_stress") return add_initial_stress(call);
  if (noun.name == "stage") return add_stage(call);
  if (noun.name == "history") return add_history(call);
  if (noun.name == "expect") return add_expect(call);
  if (noun.name == "model") {
    model.name = name;
    model.where = f.where;
    model.reference_temperature = f.number("reference_temperature");
  } else if (noun.name == "material") {
    Material material{name,
                      f.where,
                      f.texts("region"),
                      f.text("law"),
                      f.number("density"),
                      f.maybe("conductivity"),
                      f.maybe("heat_capacity"),
                      f.law_values,
                      {}};
    if (f.has("formulation")) material.bbar = f.text("formulation") == "bbar";
    for (const auto& found : law_complaints(material.law, material.values)) call.complain(found.key, found.message);
    model.materials.push_back(material);
  } else if (noun.name == "output") {
    model.outputs.push_back({name, f.where, f.texts("record"), f.text("at") == "increment" ? f.integer("every") : 0});
  } else if (noun.name == "picture") {
    const std::string section = f.text("section");
    if (f.has("section") && !std::regex_match(section, std::regex("[xyz](=-?[0-9.]+(e-?[0-9]+)?)?")))
      call.complain("section", "'section' is \"" + section + "\"; expected \"y\" or a place such as \"y=3.5\"");
    model.pictures.push_back({name, f.where, f.text("of"), f.text("stage"), f.number("deform"), section});
  }
  return 0;
}

}  // namespace ashlar
