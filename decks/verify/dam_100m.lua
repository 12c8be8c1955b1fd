-- Gravity dam of 100 m on 100 m of rock, own weight and reservoir, elastic: the same problem at any size and place, for
-- comparisons of precision, machines and speed (tools/precision_table.py).
-- No run of its own: nothing outside knows its answer.
local args = deck.args {
  size = { default = 5, unit = m, doc = "element edge in the dam; the rock has twice that" },
  east = { default = 0, unit = m, doc = "where the heel lies: an answer does not depend on the origin" },
  tolerance = { default = 1e-6, doc = "unbalanced force ratio" },
}
local x0, height, base, crest, thick = args.east, 100*m, 78*m, 14*m, 20*m

model "dam_100m" {}
extrude "dam" {
  section = { { x0, 0 }, { x0 + base, 0 }, { x0 + crest, 82*m }, { x0 + crest, height }, { x0, height } },
  length = thick, size = args.size,
}
extrude "rock" {
  section = { { x0 - 100*m, -100*m }, { x0 + base + 100*m, -100*m }, { x0 + base + 100*m, 0 }, { x0 - 100*m, 0 } },
  length = thick, size = 2 * args.size,
}
surface "upstream"  { of = "dam", facing = { -1, 0, 0 } }
surface "bottom"    { of = "rock", side = "bottom" }
surface "far_field" { of = "rock", side = { "left", "right" } }
surface "slice"     { of = { "dam", "rock" }, side = { "front", "back" } }
material "concrete" { region = "dam", density = 2400*kg/m^3, young = 25*GPa, poisson = 0.2 }
material "granite"  { region = "rock", density = 2650*kg/m^3, young = 45*GPa, poisson = 0.25 }
fix { surface = "bottom", x = 0, y = 0, z = 0 }
fix { surface = "far_field", x = 0 }
fix { surface = "slice", y = 0 }
gravity { z = -9.81 }
water_pressure "reservoir" { surface = "upstream", level = 92*m }
stage "gravity" { solve = static { tolerance = args.tolerance } }
