#include "script/schema.hpp"

#include "physics/interface_laws/interface_laws.hpp"
#include "physics/laws/laws.hpp"

namespace ashlar {
namespace {

using Type = KeyType;
using Keys = std::vector<KeyRule>;

KeyRule key(const char* name, Type type, const char* doc) {
  KeyRule rule;
  rule.name = name;
  rule.type = type;
  rule.doc = doc;
  if (type == Type::integer) rule.range = {1, 1e9};
  return rule;
}
KeyRule number(const char* name, Dimension dimension, Range range, const char* doc) {
  return key(name, Type::number, doc).in(dimension, range);
}
/// A coordinate of a bent box.
KeyRule bent(const char* name) {
  return key(name, Type::field, "where points of the straight box come to lie along this axis").in(dimension::length);
}
/// A number, a function of position, or values in time.
KeyRule field(const char* name, Dimension dimension, const char* doc) {
  return key(name, Type::field, doc).in(dimension).changing();
}
Keys operator+(Keys a, const Keys& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

KeyRule stress_key(const char* name) {
  return key(name, Type::field, (std::string("component ") + name + "; 0 unless given").c_str())
      .in(dimension::pressure);
}

/// Above absolute zero; 283 given for 10 degC falls inside, so K is refused where degC is meant.
constexpr Range celsius{-273.15, 5000};

KeyRule region_key(const char* doc) { return key("region", Type::names, doc).need(); }
KeyRule surface_key() {
  return key("surface", Type::names,
             "surfaces where it acts: declared with `surface`, sides of regions such as \"dam.bottom\" (left, right, "
             "front, back, bottom, top), or groups of the mesh file")
      .need();
}
KeyRule elements_key() {
  return key("elements", Type::choice, "element shape: hexahedra, or the same split into wedges or tetrahedra")
      .of({"hex8", "wedge6", "tet4"})
      .otherwise_text("hex8");
}
KeyRule law_key(const char* fallback) {
  const auto law = key("law", Type::choice, "how it deforms and fails; each law brings its own keys");
  return *fallback ? law.otherwise_text(fallback) : law.need();
}
Keys height_keys(const char* what) {
  const std::string below = std::string("only ") + what + " at or below this height z",
                    above = std::string("only ") + what + " at or above this height z";
  return {number("below", dimension::length, range::any, below.c_str()),
          number("above", dimension::length, range::any, above.c_str())};
}
Keys relaxation_keys() {
  return {
      number("tolerance", dimension::none, Range{1e-14, 0.1}, "unbalanced force ratio at which the stage has converged")
          .otherwise(1e-6),
      key("damping", Type::choice, "how motion is taken out on the way to rest; the answer does not depend on it")
          .of({"adaptive", "local", "viscous"})
          .otherwise_text("adaptive"),
      number(
          "damping_value", dimension::none, Range{0, 1, true},
          "local: share of the force (0.8 unless given); viscous: share of velocity lost per step (0.02 unless given)"),
      number("step_factor", dimension::none, Range{0, 1, true}, "scales the pseudo time step").otherwise(1),
      key("max_steps", Type::integer, "gives up after so many relaxation steps; a million unless given"),
      key("start", Type::choice,
          "search: conjugate gradients to the elastic balance before relaxation, where no contact has cracked or "
          "slides; "
          "rest: relaxation alone")
          .of({"search", "rest"})
          .otherwise_text("search"),
  };
}

std::vector<std::string> recorded_names(bool Recorded::*where) {
  std::vector<std::string> names;
  for (const auto& r : recorded())
    if (r.*where) names.push_back(r.name);
  return names;
}
std::vector<std::string> pictured_names() {
  return {"broken",         "temperature",      "displacement", "displacement.x", "displacement.y",
          "displacement.z", "principal_stress", "plastic_strain", "damage", "stress.xx", "stress.yy", "stress.zz",
          "stress.xy",      "stress.yz",        "stress.zx"};
}
std::vector<std::string> history_names() {
  auto names = recorded_names(&Recorded::at_point);
  for (const auto& name : recorded_names(&Recorded::on_surface)) names.push_back(name);
  for (const auto& name : recorded_names(&Recorded::of_model)) names.push_back(name);
  return names;
}

}  // namespace

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
      {"dissipation", dimension::energy, {"plastic", "fracture"}, false, false, false, true},
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

const std::vector<NounRule>& nouns() {
  static const std::vector<NounRule> all = {
      {.name = "model",
       .doc = "Names the model and gives the temperature at which there is no thermal strain.",
       .keys = {number("reference_temperature", dimension::temperature, celsius,
                       "no thermal strain at this temperature; also the initial temperature unless given")
                    .otherwise(0)},
       .example = R"(model "gravity_dam" { reference_temperature = 10*degC })"},
      {.name = "extrude",
       .doc = "A body: a section in the x-z plane, extruded along y. Its name becomes a region. Sections that share an "
              "edge get meshes that fit.",
       .keys = {key("section", Type::outline, "corners { x, z } of the outline, in order; the last joins the first")
                    .in(dimension::length)
                    .need(),
                number("length", dimension::length, range::positive, "along y").need(),
                number("size", dimension::length, range::positive, "element edge to aim at").need(),
                number("layer_size", dimension::length, range::positive,
                       "element edge along y; as `size` unless given"),
                key("layers", Type::integer, "elements along y; from `layer_size` unless given"),
                number("from", dimension::length, range::any, "y where the extrusion starts").otherwise(0),
                key("corners", Type::integers,
                    "which four points of `section` (counted from 1) are the corners of the logical quad; picked by "
                    "angle unless given")
                    .between({1, 1e6}),
                key("divisions", Type::counts,
                    "elements along chosen sides, counted from the first corner: { [1] = 6, [2] = 8 }")
                    .between({1, 1e6}),
                key("holes", Type::outlines,
                    "outlines of holes inside the section, such as galleries: { { {x,z}, ... }, ... }")
                    .in(dimension::length),
                number("hole_size", dimension::length, range::positive,
                       "element edge to aim at around the holes; as `size` unless given"),
                number("grow", dimension::none, Range{1, 2},
                       "growth from one element to the next, away from finer neighbours and holes up to `size`: 1 is "
                       "uniform; unless given 1 in a section meshed in rows, 1.3 in any other"),
                key("structured", Type::flag,
                    "mesh a section with four corners in rows; any other section, and this one if false, is cut into "
                    "triangles, for hex8 each into three quads")
                    .otherwise(1),
                elements_key()},
       .example =
           R"(extrude "dam" { section = { {0,0}, {48*m,0}, {8*m,50*m}, {8*m,60*m}, {0,60*m} }, length = 12*m, size = 4*m })"},
      {.name = "box",
       .doc = "A rectangular body along the axes, or one with six curved sides: functions x, y, z of the places in the "
              "straight box bend it, such as into an arch. Its name becomes a region; boxes that touch share nodes "
              "where their divisions agree.",
       .keys = {key("from", Type::vector, "corner with the smallest x, y, z").in(dimension::length).need(),
                key("to", Type::vector, "corner with the largest x, y, z").in(dimension::length).need(),
                key("cells", Type::integers, "elements along x, y, z; give this or `size`").between({1, 1e6}),
                number("size", dimension::length, range::positive, "element edge to aim at; give this or `cells`"),
                bent("x"), bent("y"), bent("z"), elements_key()},
       .example = R"(box "column" { from = {0,0,0}, to = {1*m,1*m,10*m}, cells = {1,1,10} })"},
      {.name = "solid",
       .doc =
           "A body of tet4 elements inside a closed surface, read from a file of facets by its extension: .stl (text "
           "or "
           "binary), .off, .obj, .ply. Its name becomes a region. The surface is one shell without cavities; one that "
           "is open, crosses itself, or has facets that are turned over, given twice or without area is refused with "
           "their numbers and places. A solid shares no nodes with a body that it touches: a `joint` ties them.",
       .keys =
           {key("file", Type::text, "path relative to the deck").need(),
            number("size", dimension::length, range::positive, "element edge to aim at").need(),
            number("grow", dimension::none, Range{1, 2},
                   "growth from one element to the next, from `size` at the surface inwards: 1 is uniform")
                .otherwise(1),
            number("feature_angle", dimension::none, Range{0, 3.1416, true},
                   "edges where facets meet at more than this angle stay as they are, with their corners; smaller "
                   "ones are rounded off by at most a twentieth of `size`; in rad or *deg")
                .otherwise(0.3490658503988659),
            number("unit", dimension::length, range::positive, "length that 1 in the file stands for").otherwise(1)},
       .example = R"(solid "abutment" { file = "abutment.stl", size = 5*m, unit = mm })"},
      {.name = "import_mesh",
       .naming = Naming::optional,
       .doc = "Reads a mesh file of hex8, wedge6 and tet4 elements by its extension. Gmsh (.msh 2.2 or 4.1, ASCII or "
              "binary): physical volumes become regions, physical surfaces become surfaces. Abaqus or CalculiX (.inp: "
              "C3D8, C3D8I, C3D8R, C3D6, C3D4; one flat file): element sets of *SOLID SECTION become regions (without "
              "sections, sets of *ELSET or *ELEMENT that hold every element once); *SURFACE, sets of shell facets and "
              "node sets with whole faces become surfaces; materials, loads, steps and all other keywords are ignored. "
              "VTK (.vtu, not compressed): the integer cell array region, material or gmsh:physical numbers regions "
              "(region_1, ...) and the surfaces of its triangles and quads (surface_1, ...).",
       .keys = {key("file", Type::text, "path relative to the deck").need(),
                number("unit", dimension::length, range::positive, "length that 1 in the file stands for").otherwise(1),
                key("regions", Type::renames, "new names of regions: { old = \"new\" }"),
                key("surfaces", Type::renames, "new names of surfaces: { old = \"new\" }")},
       .example = R"(import_mesh { file = "dam.msh", regions = { concrete = "dam" } })"},
      {.name = "surface",
       .doc =
           "A named part of the outer faces of regions, or the faces of a joint. Every filter that is given must hold. "
           "The sides of extruded, boxed and solid regions have names of their own: \"dam.left\", \"dam.bottom\", ...",
       .keys = {key("of", Type::names, "regions whose faces are taken; every region unless given"),
                key("group", Type::names, "surfaces of the mesh file to take the faces from"),
                key("joint", Type::text,
                    "the joint to take the faces from: of both regions, which a pressure in the joint pushes apart, "
                    "unless `of` says otherwise; for uplift, pressure and water_pressure"),
                key("side", Type::choices, "extreme sides of the regions: left is -x, front is -y, bottom is -z")
                    .of({"left", "right", "front", "back", "bottom", "top"}),
                key("facing", Type::vector, "direction that the outward normals point to"),
                number("within", dimension::none, Range{0, 3.1416, true}, "largest angle from `facing`, such as 60*deg")
                    .otherwise(0.5235987755982988),
                key("box", Type::vectors, "only faces with their centre between the corners { low, high }")
                    .in(dimension::length),
                key("plane", Type::vectors, "only faces in the plane { point, normal }").in(dimension::length)},
       .example = R"(surface "upstream" { of = "dam", facing = { -1, 0, 0 } })"},
      {.name = "material",
       .doc = "What regions are made of. The keys depend on the law.",
       .keys =
           {region_key("regions made of it"), law_key("elastic"),
            number("density", dimension::density, range::positive, "mass per volume").need(),
            number("conductivity", dimension::conductivity, range::positive,
                   "heat conduction; needed by thermal stages"),
            number("heat_capacity", dimension::heat_capacity, range::positive,
                   "heat per mass; needed by transient thermal stages"),
            key("formulation", Type::choice,
                "full: every Gauss point has its own change of volume; bbar: that of the element's mean, for hex8 "
                "and wedge6 (full locks in plastic flow and near poisson = 0.5); bbar for plastic laws unless given")
                .of({"full", "bbar"})},
       .example =
           R"(material "concrete" { region = "dam", density = 2400*kg/m^3, young = 30*GPa, poisson = 0.2, expansion = 9e-6/K })",
       .laws = Laws::material},
      {.name = "joint",
       .doc =
           "An interface where two regions touch: their faces are tied by springs that open, slide and crack by the "
           "law. Meshes need not match there: faces that lie on each other are joined over the area that they share. "
           "`ashlar check` shows that area, the gaps, and what found no partner.",
       .keys = {key("between", Type::names, "the two regions").need(), law_key(""),
                number("tolerance", dimension::length, range::positive,
                       "largest gap or overlap across which faces of meshes that do not match are joined; a millionth "
                       "of the model's size unless given")},
       .example =
           R"(joint "dam_base" { between = { "dam", "rock" }, law = "brittle", tensile_strength = 0.5*MPa, cohesion = 1*MPa, friction = 42*deg })",
       .laws = Laws::interface},
      {.name = "crackable",
       .doc = "Regions that may crack along every element face: each element becomes its own block, tied to its "
              "neighbours by springs.",
       .keys = {region_key("regions that may crack"), law_key("")},
       .example =
           R"(crackable "body" { region = "dam", law = "brittle", tensile_strength = 2*MPa, cohesion = 3*MPa, friction = 45*deg })",
       .laws = Laws::interface},
      {.name = "initial_stress",
       .naming = Naming::optional,
       .doc = "Stress before any displacement, from the start of the run; tension is positive. Ground at rest: give "
              "`level` and `k0`, and the vertical stress is vertical - unit_weight * (level - z), k0 times that "
              "sideways. Or give components, as numbers or functions of x, y, z. With loads that balance it nothing "
              "moves; the first stage says how far it is from that. A hole in the ground, such as a tunnel, is a face "
              "without "
              "load: the first stage excavates it. Interfaces carry its traction.",
       .keys = {key("region", Type::names, "regions; the whole model unless given"),
                number("level", dimension::length, range::any, "height z where the vertical stress is `vertical`"),
                number("vertical", dimension::pressure, range::any,
                       "vertical stress at `level`, such as of ground above the model (negative: pressed)")
                    .otherwise(0),
                number("unit_weight", dimension::stiffness_per_area, range::not_negative,
                       "weight per volume of what presses; gravity times the density of the region's material unless "
                       "given"),
                number("gravity", dimension::acceleration, range::positive, "strength of gravity").otherwise(9.81),
                number("k0", dimension::none, range::not_negative, "horizontal stress over vertical stress"),
                number("k0_x", dimension::none, range::not_negative, "along x, where that differs"),
                number("k0_y", dimension::none, range::not_negative, "along y, where that differs"), stress_key("xx"),
                stress_key("yy"), stress_key("zz"), stress_key("xy"), stress_key("yz"), stress_key("zx")},
       .example = R"(initial_stress { region = "rock", level = 0*m, k0 = 0.6 })"},
      {.name = "fix",
       .kind = NounKind::condition,
       .naming = Naming::optional,
       .doc = "Holds a surface at zero displacement in the directions given.",
       .keys = {surface_key(), key("x", Type::zero, "0: no movement along x"),
                key("y", Type::zero, "0: no movement along y"), key("z", Type::zero, "0: no movement along z"),
                key("normal", Type::flag, "true: no movement normal to the surface (roller)").otherwise(0)},
       .example = R"(fix "base" { surface = "bottom", x = 0, y = 0, z = 0 })"},
      {.name = "displacement",
       .kind = NounKind::condition,
       .naming = Naming::optional,
       .doc = "Moves a surface by a given displacement; directions that are left out stay free.",
       .keys = {surface_key(), field("x", dimension::length, "along x"), field("y", dimension::length, "along y"),
                field("z", dimension::length, "along z")},
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
                number("film", dimension::film, range::positive, "film coefficient").need()} +
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
      {.name = "static",
       .kind = NounKind::solve,
       .naming = Naming::none,
       .doc = "Equilibrium by dynamic relaxation. What the stage changes (loads, supports, displacements, temperature) "
              "comes in increments where plastic flow or cracking of blocks depends on the path.",
       .keys =
           Keys{key("increments", Type::integer,
                    "equal parts in which the change comes; 20 with a material that remembers, else 1, unless given")} +
           relaxation_keys(),
       .example = R"(stage "gravity" { solve = static { tolerance = 1e-6 } })"},
      {.name = "thermal",
       .kind = NounKind::solve,
       .naming = Naming::none,
       .doc = "Heat: the steady state, or a transient of a given duration, in time steps that the program chooses.",
       .keys =
           {key("steady", Type::flag, "true: the state that the boundary conditions lead to in the end").otherwise(0),
            number("duration", dimension::time, range::positive, "of a transient; give this or `steady = true`"),
            number("record_every", dimension::time, range::positive,
                   "transient: between rows of histories; a hundredth of the duration unless given"),
            number("tolerance", dimension::none, Range{1e-15, 0.1}, "steady: residual over its start")
                .otherwise(1e-10)},
       .example = R"(stage "winter" { solve = thermal { duration = 100*days } })"},
      {.name = "fracture",
       .kind = NounKind::solve,
       .naming = Naming::none,
       .doc = "The temperature change between the ends of two thermal stages, put on the state reached in increments, "
              "with cracks.",
       .keys =
           Keys{key("from", Type::text, "thermal stage whose end is the start; the reference temperature unless given"),
                key("to", Type::text, "thermal stage whose end is the goal").need(),
                key("increments", Type::integer, "steps of the load factor from 0 to 1").otherwise(10),
                key("max_events", Type::integer, "gives up after so many crack events").otherwise(100000)} +
           relaxation_keys(),
       .example = R"(stage "fracture" { solve = fracture { from = "summer", to = "winter", increments = 10 } })"},
      {.name = "coupled",
       .kind = NounKind::solve,
       .naming = Naming::none,
       .doc = "Heat and quasi-static stress together in time, such as seasons: heat goes on in its own steps, and at "
              "times `every` apart the body comes to equilibrium with the temperature and the conditions of that "
              "moment, from where the last equilibrium left it. Begins with the equilibrium of its first moment. "
              "Histories have a row for every such time, from the first. On two devices, or beside each other on one: "
              "--devices.",
       .keys = Keys{number("duration", dimension::time, range::positive, "how long").need(),
                    number("every", dimension::time, range::positive,
                           "between equilibria, the last is at the end; a twelfth of the duration unless given"),
                    key("increments", Type::integer,
                        "equal parts in which the change from one equilibrium to the next comes; more than 1 where "
                        "plastic flow or cracking of blocks depends on the path")
                        .otherwise(1)} +
               relaxation_keys(),
       .example = R"(stage "year" { solve = coupled { duration = 365*days, every = 15*days } })"},
      {.name = "strength_reduction",
       .kind = NounKind::solve,
       .naming = Naming::none,
       .doc =
           "The safety factor: by what the strength of all materials and interfaces (cohesion, tan(friction), tensile "
           "strength) can be divided until no equilibrium is found under the loads that act (in 20 000 steps, or "
           "max_steps), by halving the interval. Results show the last state that stands; later stages go on from "
           "before it, with full strength.",
       .keys = Keys{key("between", Type::interval, "{ lowest, highest } factor to look between; { 1, 4 } unless given"),
                    number("width", dimension::none, Range{1e-4, 1}, "of the interval at the end").otherwise(0.01)} +
               relaxation_keys(),
       .example = R"(stage "safety" { solve = strength_reduction { between = { 1, 3 }, width = 0.01 } })"},
      {.name = "dynamic",
       .kind = NounKind::solve,
       .naming = Naming::none,
       .doc = "Motion in time with the real mass, under the loads that act: from rest, or on from a dynamic stage just "
              "before. Explicit: the step is short, the energy balance is kept and reported. Shake a base by "
              "displacement { x = in_stage(...) } on it; or hold it and give gravity { x = in_stage(...) } minus the "
              "base's "
              "acceleration, then displacements are relative to the base.",
       .keys = {number("duration", dimension::time, range::positive, "how long").need(),
                number("mass_damping", dimension::frequency, range::not_negative,
                       "Rayleigh's factor of the mass: 4 pi f xi damps frequency f by xi of critical, lower ones more")
                    .otherwise(0),
                number("stiffness_damping", dimension::time, range::not_negative,
                       "Rayleigh's factor of the blocks' stiffness: xi / (pi f) damps frequency f by xi of critical, "
                       "higher ones more; shortens the step")
                    .otherwise(0),
                number("local_damping", dimension::none, Range{0, 0.95},
                       "share of the unbalanced force that opposes motion; 0.1 is about 3 % of critical at every "
                       "frequency")
                    .otherwise(0),
                number("record_every", dimension::time, range::positive,
                       "between rows of histories; a hundredth of the duration unless given"),
                number("time_step", dimension::time, range::positive,
                       "longest step; refused above the stable one; chosen unless given"),
                number("time_factor", dimension::none, Range{0, 10, true},
                       "share of the stable step to take, 0.9 unless given; above 1 to see a motion run away")},
       .example =
           R"(stage "release" { solve = dynamic { duration = 2*s, mass_damping = 0.5/s, record_every = 0.01*s } })"},
      {.name = "stage",
       .doc = "One step of the model's life. Stages continue from each other, in the deck's order.",
       .keys = {key("solve", Type::solve,
                    "static {...}, thermal {...}, fracture {...}, coupled {...}, dynamic {...} or strength_reduction {...}")
                    .need(),
                key("apply", Type::conditions,
                    "conditions that act from this stage on: a list of calls such as convection {...}. One replaces an "
                    "earlier one of its noun on the same surface"),
                key("remove", Type::names, "names of conditions that stop acting"),
                key("reset_displacement", Type::flag, "true: results count displacement from the end of this stage")
                    .otherwise(0)},
       .example =
           R"(stage "summer" { apply = { fixed_temperature { surface = "top", value = 20*degC } }, solve = thermal { steady = true } })"},
      {.name = "history",
       .doc = "A curve in history.csv: fields at a point, sums over a surface, or energies of the whole model.",
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
                key("at", Type::choice, "when: at the end of every stage, or of every increment (coupled: every time) too")
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
              "stage(name) with .converged .steps .ratio .load_factor .stop_reason .cracks (number of crack events) "
              ".first_crack (the load factor of the first) .first_crack_place (its .x .y .z) .cracked_area "
              ".dissipated_energy .plastic_work .fracture_work .safety_factor .falling_factor .free_blocks, "
              "and history(name) with .at(column, stage), .values(column, stage) and .columns.",
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
  return all;
}

const NounRule* find_noun(const std::string& name) {
  for (const auto& noun : nouns())
    if (noun.name == name) return &noun;
  return nullptr;
}

std::vector<LawDoc> laws_of(const NounRule& noun) {
  if (noun.laws == Laws::material) return material_law_docs();
  if (noun.laws == Laws::interface) return interface_law_docs();
  return {};
}

KeyRule rule_of(const Key& law_key) {
  KeyRule rule = number(law_key.name.c_str(), law_key.dimension, law_key.range, law_key.doc.c_str());
  rule.required = !law_key.fallback;
  if (!law_key.choices.empty()) {
    rule.type = Type::choice;
    rule.choices = law_key.choices;
    if (law_key.fallback) rule.fallback_text = rule.choices[static_cast<std::size_t>(*law_key.fallback)];
  } else if (law_key.fallback && given(*law_key.fallback)) {
    rule.fallback = law_key.fallback;
  }
  return rule;
}

}  // namespace ashlar
