-- Case unloading: an elastic column pulled at its top and let go comes back to where it was.
-- Source: elasticity, no load leaves no displacement; pulled, u = t H / E.
-- Accept: 1e-6 of the pulled displacement.
-- Runs: start=search | start=rest
local args = deck.args { start = { default = "search", doc = "search or rest" } }
local height, young, pull = 10*m, 20*GPa, 1*MPa

model "unloading" {}
box "column" { from = { 0, 0, 0 }, to = { 1*m, 1*m, height }, cells = { 2, 2, 10 } }
material "concrete" { region = "column", young = young, poisson = 0, density = 2400*kg/m^3 }
surface "top" { of = "column", side = "top" }
fix "foot" { surface = "column.bottom", x = 0, y = 0, z = 0 }

stage "pulled"  { apply = { traction "pull" { surface = "top", z = pull } }, solve = static { tolerance = 1e-8, start = args.start } }
stage "let_go"  { remove = { "pull" }, solve = static { tolerance = 1e-6, start = args.start } }

history "top" { at = { 0.5*m, 0.5*m, height }, record = { "displacement" } }
expect "pulled" { history = "top", component = "displacement.z", stage = "pulled", value = pull * height / young, relative = 1e-6 }
expect "back"   { history = "top", component = "displacement.z", stage = "let_go", between = { -5e-10*m, 5e-10*m } }
