-- Case balance: water on an upstream face that leans by 20 m over 50 m, to 40 m above the heel, on a free-standing block.
-- Source: by hand. Thrust rho g h^2 / 2 at h / 3; the wedge of water above the face weighs rho g h b / 2 at b / 3, b = 16 m.
-- Accept: 1e-5.
-- Runs: elements=hex8 | elements=wedge6 | elements=tet4 | level=37
local args = deck.args {
  elements = { default = "hex8", doc = "hex8, wedge6 or tet4" },
  level    = { default = 40, unit = m, doc = "of the water; 37 m ends within a row of elements" },
}
local length, g = 10, 9.81
model "inclined_face" {}
extrude "dam" {
  section = { { 0, 0 }, { 40*m, 0 }, { 28*m, 50*m }, { 20*m, 50*m } }, corners = { 1, 2, 3, 4 },
  divisions = { [1] = 8, [2] = 10 }, size = 5*m, length = length, layers = 2, elements = args.elements,
}
material "concrete" { region = "dam", young = 20*GPa, poisson = 0.2, density = 2400*kg/m^3 }
surface "upstream" { of = "dam", facing = { -50, 0, 20 }, within = 5*deg }
surface "bottom"   { of = "dam", side = "bottom" }
fix "base" { surface = "bottom", x = 0, y = 0, z = 0 }
gravity { z = -g }
water_pressure { surface = "upstream", level = args.level }
stage "gravity" { solve = static { tolerance = 1e-8 } }

local h = args.level / m
local b = h * 20 / 50
local thrust, water_weight = 1000 * g * h^2 / 2 * length, 1000 * g * h * b / 2 * length
history "water"   { surface = "upstream", record = { "load", "load_moment" } }
history "support" { surface = "bottom", record = { "reaction" } }
expect "thrust" { history = "water", component = "load.x", value = thrust, relative = 1e-5 }
expect "weight of water" { history = "water", component = "load.z", value = -water_weight, relative = 1e-5 }
expect "moment about the heel" {
  history = "water", component = "load_moment.y", value = thrust * h / 3 + water_weight * b / 3, relative = 1e-5,
}
expect "support holds the thrust" { history = "support", component = "reaction.x", value = -thrust, relative = 1e-5 }
expect "support holds dam and water" {
  history = "support", component = "reaction.z", relative = 1e-5,
  value = (40 + 8) / 2 * 50 * length * 2400 * g + water_weight,
}
