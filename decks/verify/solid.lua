-- Case balance: bodies meshed from closed surfaces: a cube, a bracket with a re-entrant edge, a wedge of a dam under water.
-- Source: by hand: weight density * g * volume; thrust on the upstream face gamma * depth^2 / 2 * width.
-- Accept: 1e-9 of the weight, since flat faces and sharp edges are kept exactly.
-- Runs: body=cube | body=bracket | body=wedge
local args = deck.args { body = { default = "wedge", doc = "cube, bracket or wedge" } }
local volume = { cube = 1*m^3, bracket = 3*m^3, wedge = 24*m * 30*m / 2 * 6*m }
local size = { cube = 0.25*m, bracket = 0.25*m, wedge = 3*m }
local weight = 2400*kg/m^3 * 9.81*m/s^2 * volume[args.body]

model "solid" {}
solid "body" { file = "solid_" .. args.body .. ".stl", size = size[args.body] }
material "concrete" { region = "body", density = 2400*kg/m^3, young = 30*GPa, poisson = 0.2 }
surface "foot"     { of = "body", side = "bottom" }
surface "upstream" { of = "body", facing = { -1, 0, 0 } }
fix { surface = "foot", x = 0, y = 0, z = 0 }
gravity { z = -9.81 }
stage "weight" { solve = static { tolerance = 1e-10 } }
history "foot" { surface = "foot", record = { "reaction" } }
expect "foot carries the weight" { history = "foot", component = "reaction.z", stage = "weight", value = weight, relative = 1e-9 }

if args.body == "wedge" then
  stage "water" { apply = { water_pressure { surface = "upstream", level = 28*m } }, solve = static { tolerance = 1e-10 } }
  history "upstream" { surface = "upstream", record = { "load" } }
  expect "water thrust" { history = "upstream", component = "load.x", stage = "water", value = 1000 * 9.81 * 28^2 / 2 * 6 * N,
    relative = 1e-9 }
  expect "foot carries the thrust" { history = "foot", component = "reaction.x", stage = "water",
    value = -1000 * 9.81 * 28^2 / 2 * 6 * N, relative = 1e-9 }
end
