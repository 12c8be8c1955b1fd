-- Case P39: a bar between rigid ends is pressed together, then cooled until it cracks.
-- Source: closed form, cracks at dT = -(f_t + precompression) / (E alpha).
-- Accept: 1 %.
-- Runs: precompression=0 | precompression=0.5 | elements=wedge6 precompression=0.5 | elements=tet4 precompression=0.5
-- The contacts (k_n = 1e13 Pa/m) soften the bar by E / (k_n h) = 0.2 % (tet4 0.5 %); the crack may come up to 0.5 % late.
local args = deck.args {
  elements       = { default = "hex8", doc = "hex8, wedge6 or tet4" },
  precompression = { default = 0.5, unit = MPa, doc = "before the cooling" },
}
local length, cells, young, expansion, strength, cooling = 5*m, 5, 20*GPa, 1e-5/K, 1.5*MPa, 20

model "bar" { reference_temperature = 0*degC }
box "left_end"  { from = { -1*m, 0, 0 }, to = { 0, 1*m, 1*m }, cells = { 1, 1, 1 }, elements = args.elements }
box "bar"       { from = { 0, 0, 0 }, to = { length, 1*m, 1*m }, cells = { cells, 1, 1 }, elements = args.elements }
box "right_end" { from = { length, 0, 0 }, to = { length + 1*m, 1*m, 1*m }, cells = { 1, 1, 1 }, elements = args.elements }
material "concrete" {
  region = { "left_end", "bar", "right_end" }, young = young, poisson = 0, density = 2400*kg/m^3,
  conductivity = 2.7*W/(m*K), expansion = expansion,
}
local law = {
  law = "brittle", tensile_strength = strength, cohesion = 10*MPa, friction = 40*deg,
  normal_stiffness = 1e13*Pa/m, shear_stiffness = 1e13*Pa/m,
}
local function with(more)
  for key, value in pairs(law) do more[key] = value end
  return more
end
crackable "bar" (with { region = "bar" })
joint "left"    (with { between = { "left_end", "bar" } })
joint "right"   (with { between = { "bar", "right_end" } })
surface "left_end"  { of = "left_end" }
surface "right_end" { of = "right_end" }
surface "all"       { of = { "left_end", "bar", "right_end" } }
fix "left" { surface = "left_end", x = 0, y = 0, z = 0 }
fix "across" { surface = "all", y = 0, z = 0 }

-- Shortening that gives the precompression, contacts included: (L / E + (n + 1) / k_n) per Pa. Of wedges and tetrahedra
-- each is a block; the way through a cell crosses one or two diagonal faces, which take sqrt(1/2) / k_n per Pa.
local diagonals = ({ hex8 = 0, wedge6 = 1, tet4 = 2 })[args.elements]
local crossings = cells + 1 + cells * diagonals * math.sqrt(0.5)
local shortening = args.precompression * (length / young + crossings / (1e13*Pa/m))
stage "press" {
  apply = { displacement { surface = "right_end", x = -shortening } },
  solve = static { tolerance = 1e-9 },
}
stage "cold" {
  apply = { fixed_temperature { surface = "all", value = -cooling } },
  solve = thermal { steady = true },
}
stage "cooling" { solve = fracture { to = "cold", increments = 10, tolerance = 1e-8, max_events = 100 } }

history "middle" { at = { 2.5, 0.5, 0.5 }, record = { "stress" } }
expect "pressed" { history = "middle", component = "stress.xx", stage = "press", value = -args.precompression, tolerance = 1*Pa }
expect "cracks at" { that = function(result)
  local found = result.stage("cooling").first_crack * -cooling
  local exact = -(1.5e6 + args.precompression / Pa) / (20e9 * 1e-5)
  return math.abs(found / exact - 1) < 0.01, string.format("dT = %.4f K, closed form %.4f K", found, exact)
end }
