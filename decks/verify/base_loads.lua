-- Case balance: a block on its base under silt, uplift with drains and a crane: reactions and moments about the origin.
-- Source: by hand. Silt 5.5 kN/m^3 x 10^2 / 2 at 10/3 m; uplift by the diagram of EM 1110-2-2200: straight line at the
--         drains 17 - 14 x 2/14 = 15 m, level there 3 + 0.4 (15 - 3) = 7.8 m: two trapezoids, 2 m and 12 m long.
-- Accept: loads 1e-12, reactions 1e-5.
-- Runs: elements=hex8 | elements=wedge6 | elements=tet4
local args = deck.args { elements = { default = "hex8", doc = "hex8, wedge6 or tet4" } }

model "base_loads" {}
box "dam" { from = { 0, 0, 0 }, to = { 14*m, 3*m, 20*m }, cells = { 5, 2, 8 }, elements = args.elements }
material "concrete" { region = "dam", young = 30*GPa, poisson = 0.2, density = 2400*kg/m^3 }
surface "base"     { of = "dam", side = "bottom" }
surface "upstream" { of = "dam", side = "left" }
surface "silted"   { of = "dam", side = "left", box = { { -1, 0, 0 }, { 1, 3, 10 } } }
fix "foot" { surface = "base", x = 0, y = 0, z = 0 }

pressure "silt" { surface = "silted", value = function(x, y, z) return 5.5*kN/m^3 * (10*m - z*m) end }
uplift { surface = "base", upstream_level = 17*m, downstream_level = 3*m, drain = 2*m, drain_efficiency = 0.6 }
point_load "crane" { at = { 6.1*m, 1.7*m, 20*m }, x = 150*kN, y = -40*kN, z = -900*kN }
stage "loaded" { solve = static { tolerance = 1e-9 } }

history "base"     { surface = "base", record = { "load", "load_moment", "reaction" } }
history "upstream" { surface = "upstream", record = { "load", "load_moment" } }

local silt = 5.5e3 * 10^2 / 2 * 3
local first, second = (17 + 7.8) / 2 * 2, (7.8 + 3) / 2 * 12
local uplifted = 9810 * 3 * (first + second)
-- trapezoids from x = a to b with heads h, k: centre at a + (b - a) (h + 2 k) / (3 (h + k))
local about_heel = 9810 * 3 * (first * 2 * (17 + 2*7.8) / (3 * (17 + 7.8))
                               + second * (2 + 12 * (7.8 + 2*3) / (3 * (7.8 + 3))))
for _, case in ipairs {
  { "silt", "upstream", "load.x", silt*N, 1e-12 },
  { "silt's moment", "upstream", "load_moment.y", silt*10/3*N*m, 1e-12 },
  { "uplift", "base", "load.z", uplifted*N, 1e-12 },
  { "uplift's moment", "base", "load_moment.y", -about_heel*N*m, 1e-12 },
  { "thrust held", "base", "reaction.x", (-silt - 150e3)*N, 1e-5 },
  { "side force held", "base", "reaction.y", 40*kN, 1e-5 },
  { "crane and uplift held", "base", "reaction.z", (900e3 - uplifted)*N, 1e-5 },
} do
  local name, place, column, value, relative = table.unpack(case)
  expect(name) { history = place, component = column, value = value, relative = relative }
end
