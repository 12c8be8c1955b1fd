-- Case water in cracks: a block hangs between a ceiling and a base; pulled up, it tears off the base, and water presses into
--   the crack, but not before.
-- Source: by hand: reaction of the ceiling = pull + pressure * area once it is cracked; of the base = pressure * area.
-- Accept: 1e-6 of the pull.
-- Runs: elements=hex8 | elements=tet4 upper=3
local args = deck.args {
  elements = { default = "hex8", doc = "hex8, wedge6 or tet4" },
  upper = { default = 2, doc = "cells along the edges of the block; the base has 2" },
}
local pull, level, n = 1.2e6, 20, args.upper

model "crack_water" {}
box "base" { from = { 0, 0, -1 }, to = { 1, 1, 0 }, cells = { 2, 2, 1 }, elements = args.elements }
box "block" { from = { 0, 0, 0 }, to = { 1, 1, 1 }, cells = { n, n, n }, elements = args.elements }
box "ceiling" { from = { 0, 0, 1 }, to = { 1, 1, 2 }, cells = { n, n, 1 }, elements = args.elements }
material "rock" { region = { "base", "block", "ceiling" }, density = 2400*kg/m^3, young = 30*GPa, poisson = 0 }
joint "foot" {
  between = { "base", "block" }, law = "brittle", tensile_strength = 0.5*MPa, cohesion = 5*MPa, friction = 45*deg,
}
joint "head" { between = { "block", "ceiling" }, law = "elastic" }
crack_water { of = { "foot" }, level = level*m }
surface "sides" { of = "block", side = { "left", "right" } }
fix { surface = "base.bottom", x = 0, y = 0, z = 0 }
fix { surface = "ceiling.top", x = 0, y = 0, z = 0 }
-- Half of it on each side; before it cracks base and ceiling share it.
stage "whole"   { apply = { traction { surface = "sides", z = 0.1 * pull / 2*Pa } }, solve = static { tolerance = 1e-9 } }
stage "cracked" { apply = { traction { surface = "sides", z = pull / 2*Pa } }, solve = static { tolerance = 1e-9 } }

local water = 1000 * 9.81 * level
history "base" { surface = "base.bottom", record = { "reaction" } }
history "ceiling" { surface = "ceiling.top", record = { "reaction" } }
expect "dry before" { that = function(result)
  local below = result.history("base").at("reaction.z", "whole")
  return below < 0 and result.stage("whole").cracks == 0, string.format("the base holds %.6g N", below)
end }
expect "ceiling" { history = "ceiling", component = "reaction.z", stage = "cracked", value = -(pull + water)*N, tolerance = 1e-6 * pull*N }
expect "base" { history = "base", component = "reaction.z", stage = "cracked", value = water*N, tolerance = 1e-6 * pull*N }
