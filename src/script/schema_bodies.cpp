#include "script/schema_keys.hpp"

namespace ashlar::schema {

namespace {

KeyRule region_key(const char* doc) { return key("region", Type::names, doc).need(); }
KeyRule elements_key() {
  return key("elements", Type::choice, "element shape: hexahedra, or the same split into wedges or tetrahedra")
      .of({"hex8", "wedge6", "tet4"})
      .otherwise_text("hex8");
}
/// A coordinate of a bent box.
KeyRule bent(const char* name) {
  return key(name, Type::field, "where points of the straight box come to lie along this axis").in(dimension::length);
}
KeyRule law_key(const char* fallback) {
  const auto law = key("law", Type::choice, "how it deforms and fails; each law brings its own keys");
  return *fallback ? law.otherwise_text(fallback) : law.need();
}
Keys joint_keys() {
  return {number("initial_opening", dimension::length, range::not_negative,
                 "frictional: gap that is open at the start, such as of a contraction joint before it is grouted (see "
                 "`grouting`); it carries nothing until it has closed by that much")
              .otherwise(0),
          key("scatter", Type::choice,
              "how tensile strength and cohesion differ, together, from face to face: the distribution about what is "
              "given here; no difference unless given")
              .of({"weibull", "normal"}),
          number("variation", dimension::none, Range{0, 0.5, true},
                 "standard deviation of strength over its mean (Weibull's modulus is about 1.2 / variation)"),
          key("seed", Type::integer, "another seed draws other strengths").otherwise(1)};
}
KeyRule stress_key(const char* name) {
  return key(name, Type::field, (std::string("component ") + name + "; 0 unless given").c_str())
      .in(dimension::pressure);
}

}  // namespace

/// Bodies, what they are made of, and where they may part.
std::vector<NounRule> body_nouns() {
  return {
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
                "full: every Gauss point has its own change of volume; bbar: that of the element's mean for hex8 and "
                "wedge6, for tet4 that of the elements around its corners (full locks in plastic flow and near poisson "
                "= 0.5); unless given, bbar for plastic laws on hex8 and wedge6 and for von_mises on tet4, full for all others: tet4 "
                "with friction and bbar meet limit loads in plane strain, but are too weak in triaxial states")
                .of({"full", "bbar"})},
       .example =
           R"(material "concrete" { region = "dam", density = 2400*kg/m^3, young = 30*GPa, poisson = 0.2, expansion = 9e-6/K })",
       .laws = Laws::material},
      {.name = "joint",
       .doc =
           "An interface where two regions touch: their faces are tied by springs that open, slide and crack by the "
           "law. Meshes need not match there: faces that lie on each other are joined over the area that they share. "
           "`ashlar check` shows that area, the gaps, and what found no partner; with --to NAME.vtu also as a picture. "
           "A "
           "face at the joint's rim of which half or less is joined stays an outer one, loads act on all of it; of "
           "which "
           "more is joined it is none, loads leave it out.",
       .keys =
           Keys{
               key("between", Type::names, "the two regions").need(), law_key(""),
               number("tolerance", dimension::length, range::positive,
                      "largest gap or overlap across which faces of meshes that do not match are joined; a millionth "
                      "of the model's size unless given"),
               number("conductance", dimension::film, range::positive,
                      "heat per area that passes where it is closed, for each degree between its faces. Unless this or "
                      "`open_conductance` is given heat passes as if nothing were there (meshed apart: ten times as "
                      "well as through the half elements beside it), open or not"),
               number("open_conductance", dimension::film, range::not_negative,
                      "the same where it is open, such as a film of air; 0 if only `conductance` is given. Taken as a "
                      "thermal stage finds the joint; coupled stages look at it again with every balance")} +
           joint_keys(),
       .example =
           R"(joint "dam_base" { between = { "dam", "rock" }, law = "brittle", tensile_strength = 0.5*MPa, cohesion = 1*MPa, friction = 42*deg })",
       .laws = Laws::interface},
      {.name = "crackable",
       .doc = "Regions that may crack along every element face: each element becomes its own block, tied to its "
              "neighbours by springs.",
       .keys = Keys{region_key("regions that may crack"), law_key("")} + joint_keys(),
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
  };
}

}  // namespace ashlar::schema
