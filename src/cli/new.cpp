#include <cstdio>
#include <filesystem>

#include "cli/commands.hpp"
#include "io/text_file.hpp"

namespace ashlar {
namespace {

/// A dam on its rock: what most decks need, once each.
constexpr const char* starter = R"starter(-- A gravity dam on rock under its weight, the lake and uplift.
--   ashlar check FILE     mesh, supports, loads and effort, without solving
--   ashlar run FILE       solves it; ashlar plot RUN draws the pictures
--   ashlar help           the nouns of this language; ashlar help material: the keys of one
-- x runs from the lake to the valley, y along the dam, z up. Bare numbers are SI; units are multiplied: 30*GPa.

local args = deck.args {                          -- ashlar run FILE --set level=40
  level = { default = 55, unit = m, doc = "of the lake, above the base" },
  size  = { default = 5, unit = m, doc = "element size in the dam" },
}
local height, base, crest = 60*m, 48*m, 8*m

model "NAME" {}

-- Bodies: sections in x and z, extruded along y. Their names are regions.
extrude "dam" {
  section = { {0, 0}, {base, 0}, {crest, 0.85*height}, {crest, height}, {0, height} },
  length = 10*m, size = args.size,
}
extrude "rock" {
  section = { {-80*m, -80*m}, {base + 80*m, -80*m}, {base + 80*m, 0}, {-80*m, 0} },
  length = 10*m, size = 3*args.size,
}

material "concrete" { region = "dam", density = 2400*kg/m^3, young = 30*GPa, poisson = 0.2 }
material "granite" { region = "rock", density = 2700*kg/m^3, young = 45*GPa, poisson = 0.25 }

-- Without the joint dam and rock would be one body; with it they may part and slide.
joint "base" {
  between = { "dam", "rock" }, law = "brittle",
  tensile_strength = 0.5*MPa, cohesion = 1*MPa, friction = 42*deg,
}

-- Faces: sides have names, "dam.left"; other faces are chosen by `surface`.
surface "contact" { joint = "base" }
surface "floor" { of = "rock", side = "top", box = { {-80*m, 0, 0}, {0, 10*m, 0} } }

fix "far" { surface = { "rock.left", "rock.right" }, normal = true }
fix "slice" { surface = { "rock.front", "rock.back" }, normal = true }
fix "bottom" { surface = "rock.bottom", x = 0, y = 0, z = 0 }

gravity { z = -9.81*m/s^2 }

-- Stages continue from each other; conditions inside `apply` act from their stage on.
stage "weight" { solve = static {}, reset_displacement = true }
stage "full" {
  apply = {
    water_pressure "lake" { surface = { "dam.left", "floor" }, level = args.level },
    uplift { surface = "contact", upstream_level = args.level, downstream_level = 0, drain = 6*m, drain_efficiency = 0.5 },
  },
  solve = static {},
}

history "crest" { at = { 0, 5*m, height }, record = { "displacement" } }
picture "movement" { of = "displacement.x", deform = 1000, stage = "full" }
expect "leans downstream" { history = "crest", component = "displacement.x", between = { 1*mm, 30*mm } }
expect "the base holds" { that = function(result) return result.stage("full").cracked_area == 0 end }
)starter";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

}  // namespace

int new_command(const Arguments& arguments) {
  std::filesystem::path path = arguments.operands[0];
  if (path.extension() != ".lua") path += ".lua";
  if (std::filesystem::exists(path)) throw UsageError("there is '" + path.string() + "' already; choose another name");
  const std::string name = path.stem().string();
  if (name.find_first_of("\"\\\n") != std::string::npos) throw UsageError("'" + name + "' cannot be a model's name");
  replace_file(path.string(), replaced(replaced(starter, "FILE", path.filename().string()), "NAME", name));
  std::printf("wrote    %s\nnext     ashlar run %s\n", path.c_str(), path.c_str());
  return 0;
}

}  // namespace ashlar
