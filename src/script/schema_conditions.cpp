#include "script/schema_keys.hpp"

namespace ashlar::schema {

namespace {

/// A number, a function of position, or values in time.
KeyRule field(const char* name, Dimension dimension, const char* doc) {
  return key(name, Type::field, doc).in(dimension).changing();
}
KeyRule line_key() {
  return key("line", Type::vectors, "only nodes of the surface on the straight line between these two points")
      .in(dimension::length);
}
KeyRule surface_key() {
  return key("surface", Type::names,
             "surfaces where it acts: declared with `surface`, sides of regions such as \"dam.bottom\" (left, right, "
             "front, back, bottom, top), or groups of the mesh file")
      .need();
}
Keys height_keys(const char* what) {
  const std::string below = std::string("only ") + what + " at or below this height z",
                    above = std::string("only ") + what + " at or above this height z";
  return {number("below", dimension::length, range::any, below.c_str()),
          number("above", dimension::length, range::any, above.c_str())};
}

}  // namespace

/// Supports, loads and temperatures.
std::vector<NounRule> condition_nouns() {
  return {
      {.name = "fix",
       .kind = NounKind::condition,
       .naming = Naming::optional,
       .doc = "Holds a surface at zero displacement in the directions given.",
       .keys = {surface_key(), key("x", Type::zero, "0: no movement along x"),
                key("y", Type::zero, "0: no movement along y"), key("z", Type::zero, "0: no movement along z"),
                key("normal", Type::flag, "true: no movement normal to the surface (roller)").otherwise(0), line_key()},
       .example = R"(fix "base" { surface = "bottom", x = 0, y = 0, z = 0 })"},
      {.name = "displacement",
       .kind = NounKind::condition,
       .naming = Naming::optional,
       .doc = "Moves a surface by a given displacement; directions that are left out stay free.",
       .keys = {surface_key(), field("x", dimension::length, "along x"), field("y", dimension::length, "along y"),
                field("z", dimension::length, "along z"), line_key()},
       .example = R"(displacement "pull" { surface = "top", z = 1*mm })"},
      {.name = "gravity",
       .kind = NounKind::condition,
       .naming = Naming::optional,
       .doc = "Weight of every region.",
       .keys = {number("x", dimension::acceleration, range::any, "acceleration along x").otherwise(0).changing(),
                number("y", dimension::acceleration, range::any, "acceleration along y").otherwise(0).changing(),
                number("z", dimension::acceleration, range::any, "acceleration along z; down is negative")
                    .otherwise(0)
                    .changing()},
       .example = R"(gravity { z = -9.81 })"},
      {.name = "water_pressure",
       .kind = NounKind::condition,
       .naming = Naming::optional,
       .doc = "Hydrostatic pressure density * gravity * (level - z) on the part of a surface below the level.",
       .keys = {surface_key(),
                number("level", dimension::length, range::any, "height z of the water table").need().changing(),
                number("density", dimension::density, range::positive, "of the water").otherwise(1000),
                number("gravity", dimension::acceleration, range::positive, "strength of gravity").otherwise(9.81)},
       .example = R"(water_pressure "reservoir" { surface = "upstream", level = 55*m })"},
      {.name = "crack_water",
       .kind = NounKind::condition,
       .naming = Naming::optional,
       .doc = "Water that stands in joints where they are open or cracked, and follows cracks as they grow: it presses "
              "both faces apart with density * gravity * (level - z) below its level. Uncracked parts stay dry; for "
              "seepage through them see `uplift`.",
       .keys = {key("of", Type::names, "joints and crackables that it enters").need(),
                number("level", dimension::length, range::any, "height z of the water table").need().changing(),
                number("density", dimension::density, range::positive, "of water").otherwise(1000),
                number("gravity", dimension::acceleration, range::positive, "strength of gravity").otherwise(9.81)},
       .example = R"(crack_water { of = { "dam_base" }, level = 55*m })"},
      {.name = "grouting",
       .kind = NounKind::condition,
       .naming = Naming::optional,
       .doc = "Grout that fills joints at the moment when it first acts, such as contraction joints of an arch dam in "
              "winter: what is open then counts as closed from there on and carries compression and friction as it is. "
              "What is pressed together or bonded stays as it was; the grout itself holds no tension. Frictional and "
              "brittle joints.",
       .keys = {key("of", Type::names, "joints and crackables that it fills").need()},
       .example = R"(grouting { of = "dam_base" })"},
      {.name = "traction",
       .kind = NounKind::condition,
       .naming = Naming::optional,
       .doc = "Force per area on a surface, in fixed directions; numbers or functions of x, y, z.",
       .keys = {surface_key(), field("x", dimension::pressure, "along x").otherwise(0),
                field("y", dimension::pressure, "along y").otherwise(0),
                field("z", dimension::pressure, "along z").otherwise(0)},
       .example = R"(traction "ice" { surface = "top", x = function(x, y, z) return 10*kPa * (1 - y/12) end })"},
      {.name = "pressure",
       .kind = NounKind::condition,
       .naming = Naming::optional,
       .doc = "Force per area against the outward normal of a surface, such as silt, ice or gas; negative pulls.",
       .keys = {surface_key(),
                field("value", dimension::pressure, "the pressure, a number or a function of x, y, z").need()},
       .example =
           R"(pressure "silt" { surface = "upstream", value = function(x, y, z) return z < 10 and 5.5e3*(10 - z) or 0 end })"},
      {.name = "uplift",
       .kind = NounKind::condition,
       .naming = Naming::optional,
       .doc =
           "Water pressure under a base, density * gravity * (level - z) where positive. The piezometric level runs "
           "straight along x from `upstream_level` at the heel to `downstream_level` at the toe; at a line of drains "
           "it is base + (1 - drain_efficiency) * (straight - base), base being the downstream level or the gallery "
           "floor if that is higher (USACE EM 1110-2-2200, 3-3 d). For any other shape use `pressure` with a "
           "function. Under a dam on its rock it acts in the joint between them, on both faces: surface \"base\" { "
           "joint = \"dam_base\" }. On a base held by `fix` it changes reactions only.",
       .keys = {surface_key(),
                number("upstream_level", dimension::length, range::any, "height z of the headwater").need().changing(),
                number("downstream_level", dimension::length, range::any,
                       "height z of the tailwater; of the ground at the toe if there is none")
                    .need()
                    .changing(),
                number("drain", dimension::length, range::any, "x of the line of drains"),
                number("drain_efficiency", dimension::none, Range{0, 1},
                       "share of the head above the base level that the drains take away; EM 1110-2-2200 allows 0.25 "
                       "to 0.5, more only as measured"),
                number("gallery", dimension::length, range::any,
                       "height z of the gallery floor that the drains empty onto; below the tailwater unless given"),
                number("heel", dimension::length, range::any, "x of the heel; the surface's lowest x unless given"),
                number("toe", dimension::length, range::any, "x of the toe; the surface's highest x unless given"),
                number("density", dimension::density, range::positive, "of the water").otherwise(1000),
                number("gravity", dimension::acceleration, range::positive, "strength of gravity").otherwise(9.81)},
       .example =
           R"(uplift { surface = "bottom", upstream_level = 55*m, downstream_level = 5*m, drain = 6*m, drain_efficiency = 0.5 })"},
      {.name = "point_load",
       .kind = NounKind::condition,
       .naming = Naming::optional,
       .doc =
           "A force at a point of the body, shared among the corners of the element there. A later stage's point load "
           "replaces an earlier one at the same place. Stress next to it grows without bound as elements shrink.",
       .keys = {key("at", Type::vector, "the point, in the body or on its surface").in(dimension::length).need(),
                number("x", dimension::force, range::any, "force along x").otherwise(0).changing(),
                number("y", dimension::force, range::any, "force along y").otherwise(0).changing(),
                number("z", dimension::force, range::any, "force along z").otherwise(0).changing()},
       .example = R"(point_load "crane" { at = { 4*m, 6*m, 60*m }, z = -200*kN })"},
      {.name = "fixed_temperature",
       .kind = NounKind::condition,
       .naming = Naming::optional,
       .doc = "Temperature of a surface, such as a wetted face.",
       .keys =
           Keys{surface_key(), field("value", dimension::temperature, "temperature, a number or a function of x, y, z")
                                   .between(celsius)
                                   .need()} +
           height_keys("nodes"),
       .example = R"(fixed_temperature "water" { surface = "upstream", below = 55*m, value = 8*degC })"},
      {.name = "convection",
       .kind = NounKind::condition,
       .naming = Naming::optional,
       .doc = "Heat exchange film * (ambient - temperature) through a surface, such as with the air.",
       .keys =
           Keys{surface_key(),
                field("ambient", dimension::temperature, "temperature of the air, a number or a function of x, y, z")
                    .between(celsius)
                    .need(),
                number("film", dimension::film, range::positive, "film coefficient").need().changing()} +
           height_keys("faces with their centre"),
       .example =
           R"(convection "air" { surface = "downstream", ambient = in_time { {0*days, -2*degC}, {180*days, 28*degC} }, film = 15*W/(m^2*K) })"},
      {.name = "flux",
       .kind = NounKind::condition,
       .naming = Naming::optional,
       .doc = "Heat that enters through a surface; negative: leaves.",
       .keys = {surface_key(), field("value", dimension::heat_flux,
                                     "heat per area and time into the body, a number or a function of x, y, z")
                                   .need()},
       .example = R"(flux "sun" { surface = "top", value = 20*W/m^2 })"},
      {.name = "heat_source",
       .kind = NounKind::condition,
       .naming = Naming::optional,
       .doc = "Heat made inside regions, such as by hydrating cement; negative: taken out.",
       .keys = {field("value", dimension::heat_source, "heat per volume and time, a number or a function of x, y, z")
                    .need(),
                key("region", Type::names, "regions; the whole model unless given")},
       .example = R"(heat_source "hydration" { region = "lift", value = 300*W/m^3 })"},
      {.name = "initial_temperature",
       .kind = NounKind::condition,
       .naming = Naming::optional,
       .doc = "Temperature before the first stage where it acts; the reference temperature unless given.",
       .keys = {key("value", Type::field, "temperature, a number or a function of x, y, z")
                    .in(dimension::temperature)
                    .between(celsius)
                    .need(),
                key("region", Type::names, "regions; the whole model unless given")},
       .example = R"(initial_temperature { value = 15*degC })"},
      {.name = "temperature_field",
       .kind = NounKind::condition,
       .naming = Naming::optional,
       .doc = "Temperature given everywhere instead of solved for; static stages feel its thermal strain.",
       .keys = {field("value", dimension::temperature, "temperature, a number or a function of x, y, z")
                    .between(celsius)
                    .need()},
       .example = R"(temperature_field { value = function(x, y, z) return 10 + 0.5*z end })"},
  };
}

}  // namespace ashlar::schema
