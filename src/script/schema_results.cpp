#include "script/schema_keys.hpp"

namespace ashlar {

const std::vector<Recorded>& recorded() {
  const std::vector<std::string> vector{"x", "y", "z"}, tensor{"xx", "yy", "zz", "xy", "yz", "zx"};
  constexpr Dimension moment{2, 1, -2, 0};
  static const std::vector<Recorded> all = {
      {"displacement", dimension::length, vector, true, false, true},
      {"velocity", dimension::velocity, vector, true, false, false},
      {"temperature", dimension::temperature, {}, true, false, true},
      {"stress", dimension::pressure, tensor, true, false, true},
      {"nodal_stress", dimension::pressure, tensor, true, false, false},
      {"principal_stress", dimension::pressure, {}, false, false, true},
      {"plastic_strain", dimension::none, {}, true, false, true},
      {"damage", dimension::none, {}, true, false, true},
      {"crack_normal", dimension::none, {}, false, false, true},
      {"opening", dimension::length, {}, false, false, true},
      {"slip", dimension::length, {}, false, false, true},
      {"traction", dimension::pressure, {}, false, false, true},
      {"broken", dimension::none, {}, false, false, true},
      {"reaction", dimension::force, vector, false, true, false},
      {"load", dimension::force, vector, false, true, false},
      {"load_moment", moment, vector, false, true, false},
      {"energy",
       dimension::energy,
       {"kinetic", "strain", "dissipated", "external_work", "error"},
       false,
       false,
       false,
       true},
      {"dissipation",
       dimension::energy,
       {"plastic", "fracture", "opening", "shear", "friction"},
       false,
       false,
       false,
       true},
      {"cracked_area", dimension::area, {}, false, false, false, true},
  };
  return all;
}

std::vector<std::string> columns_of(const History& history) {
  std::vector<std::string> columns;
  for (const auto& name : history.record)
    for (const auto& r : recorded()) {
      if (r.name != name) continue;
      if (r.components.empty()) columns.push_back(name);
      for (const auto& component : r.components) columns.push_back(name + "." + component);
    }
  return columns;
}

namespace schema {

namespace {

std::vector<std::string> recorded_names(bool Recorded::*where) {
  std::vector<std::string> names;
  for (const auto& r : recorded())
    if (r.*where) names.push_back(r.name);
  return names;
}
std::vector<std::string> pictured_names() {
  return {"broken",         "temperature",      "displacement",   "displacement.x", "displacement.y",
          "displacement.z", "principal_stress", "plastic_strain", "damage",         "stress.xx",
          "stress.yy",      "stress.zz",        "stress.xy",      "stress.yz",      "stress.zx"};
}
std::vector<std::string> history_names() {
  auto names = recorded_names(&Recorded::at_point);
  for (const auto& name : recorded_names(&Recorded::on_surface)) names.push_back(name);
  for (const auto& name : recorded_names(&Recorded::of_model)) names.push_back(name);
  return names;
}

}  // namespace

/// What comes out, and what is expected of it.
std::vector<NounRule> result_nouns() {
  return {
      {.name = "history",
       .doc = "A curve in history_NAME.csv: fields at a point, sums over a surface, or energies of the whole model; a row "
              "at the start, at the end of every stage and on the way (increments, times). Its column balanced is 0 in "
              "the last row of a stage that failed, which is no equilibrium, else 1.",
       .keys = {key("at", Type::vector, "the point; give this or `surface`").in(dimension::length),
                key("surface", Type::text, "the surface; give this or `at`"),
                key("record", Type::choices,
                    "at a point: displacement, velocity, temperature, stress (mean of the element there), nodal_stress "
                    "(extrapolated to the nodes, averaged there), plastic_strain, damage; over a surface: "
                    "reaction, load, load_moment; with neither: energy, of dynamic stages, and dissipation, of blocks")
                    .of(history_names())
                    .need()},
       .example = R"(history "crest" { at = { 0, 0, 60*m }, record = { "displacement", "temperature" } })"},
      {.name = "output",
       .doc = "Fields in the result files.",
       .keys = {key("record", Type::choices, "fields to write").of(recorded_names(&Recorded::in_output)).need(),
                key("at", Type::choice,
                    "when: at the end of every stage, or of every increment (coupled: every time) too")
                    .of({"stage_end", "increment"})
                    .otherwise_text("stage_end"),
                key("every", Type::integer, "with at = \"increment\": every so many increments").otherwise(1)},
       .example = R"(output "fields" { record = { "displacement", "stress" }, at = "stage_end" })"},
      {.name = "picture",
       .doc = "A picture that `ashlar plot` draws from the results.",
       .keys = {key("of", Type::choice, "field to show").of(pictured_names()).need(),
                key("stage", Type::text, "at the end of this stage; the last one unless given"),
                number("deform", dimension::none, range::not_negative,
                       "magnification of the displacement; 0: undeformed shape")
                    .otherwise(0),
                key("section", Type::text, "cut instead of the surface: \"y\" at mid thickness, \"y=3.5\" there")},
       .example = R"(picture "cracks" { of = "broken", deform = 200 })"},
      {.name = "expect",
       .doc = "A statement about the results, checked at the end of a run (exit code 4 if one fails). A history's "
              "value at the end of a stage lies in `between`, or "
              "is `value` within `tolerance` or `relative`; or `that` is a function of the result returning true (and, "
              "if it likes, a text). The result offers "
              "stage(name) with .converged .balanced (whether its last state is) .steps .ratio .load_factor .stop_reason .cracks (number of crack events) "
              ".first_crack (the load factor of the first) .first_crack_place (its .x .y .z) .cracked_area "
              ".dissipated_energy .plastic_work .fracture_work .safety_factor .falling_factor .free_blocks, "
              "and history(name) with .at(column, stage), .values(column, stage) and .columns. The end of a stage that "
              "failed is not in balance: no statement about it holds, and .values leaves it out.",
       .keys = {key("history", Type::text, "name of a history"),
                key("component", Type::text, "its column, such as \"displacement.z\""),
                key("stage", Type::text, "at the end of this stage; the last row unless given"),
                key("between", Type::interval, "{ lowest, highest } value").of_any_dimension(),
                number("value", dimension::none, range::any, "wanted value").of_any_dimension(),
                number("tolerance", dimension::none, range::not_negative,
                       "allowed difference from `value`, in its unit")
                    .of_any_dimension(),
                number("relative", dimension::none, range::not_negative,
                       "allowed difference from `value` as a share of it"),
                key("that", Type::function, "function(result) that returns true if all is well")},
       .example =
           R"(expect "crest settles" { history = "crest", component = "displacement.z", stage = "gravity", between = { -60*mm, -1*mm } })"},
  };
}

}  // namespace schema

}  // namespace ashlar
