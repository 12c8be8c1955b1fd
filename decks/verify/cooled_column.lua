-- Case P40: a column fixed at both ends carries its weight half in tension (top), half in compression (foot); cooled, it
--           cracks at the top first.
-- Source: closed form, +- rho g H / 2 at the ends; cracks at E alpha |dT| + rho g H / 2 = f_t.
-- Accept: 1 %.
-- Runs: elements=hex8 | elements=wedge6 | elements=tet4
local args = deck.args { elements = { default = "hex8", doc = "hex8, wedge6 or tet4" } }
local height, young, density, g, expansion, strength, cooling = 20, 20*GPa, 2400*kg/m^3, 9.81, 1e-5/K, 1.5*MPa, 20

model "column" { reference_temperature = 0*degC }
box "ground" { from = { 0, 0, -1 }, to = { 1, 1, 0 }, cells = { 1, 1, 1 }, elements = args.elements }
box "column" { from = { 0, 0, 0 }, to = { 1, 1, height }, cells = { 1, 1, height }, elements = args.elements }
box "roof"   { from = { 0, 0, height }, to = { 1, 1, height + 1 }, cells = { 1, 1, 1 }, elements = args.elements }
material "concrete" {
  region = { "ground", "column", "roof" }, young = young, poisson = 0, density = density,
  conductivity = 2.7*W/(m*K), expansion = expansion,
}
local function with(more)
  for key, value in pairs {
    law = "brittle", tensile_strength = strength, cohesion = 10*MPa, friction = 40*deg,
    normal_stiffness = 1e13*Pa/m, shear_stiffness = 1e13*Pa/m,
  } do more[key] = value end
  return more
end
crackable "column" (with { region = "column" })
joint "foot"       (with { between = { "ground", "column" } })
joint "top"        (with { between = { "column", "roof" } })
surface "ends" { of = { "ground", "roof" } }
surface "all"  { of = { "ground", "column", "roof" } }
fix "ends" { surface = "ends", x = 0, y = 0, z = 0 }
-- A brick stands free between its neighbours, by symmetry; what cuts it into wedges or tetrahedra would feel that the ends
-- do not let it shrink sideways.
if args.elements ~= "hex8" then fix "across" { surface = "all", x = 0, y = 0 } end
gravity { z = -g }

stage "gravity" { solve = static { tolerance = 1e-9 } }
stage "cold"    { apply = { fixed_temperature { surface = "all", value = -cooling } }, solve = thermal { steady = true } }
stage "cooling" { solve = fracture { to = "cold", increments = 10, tolerance = 1e-8, max_events = 100 } }

-- Stress at the centres of the end blocks: half a block less than at the ends.
local weight_stress = 2400 * g * (height / 2 - 0.5)
history "top"  { at = { 0.5, 0.5, height - 0.5 }, record = { "stress" } }
history "foot" { at = { 0.5, 0.5, 0.5 }, record = { "stress" } }
expect "hangs at the top" { history = "top", component = "stress.zz", stage = "gravity", value = weight_stress, relative = 0.01 }
expect "stands at the foot" { history = "foot", component = "stress.zz", stage = "gravity", value = -weight_stress, relative = 0.01 }
expect "cracks at" { that = function(result)
  local found = result.stage("cooling").first_crack * -cooling
  local exact = -(1.5e6 - 2400 * g * height / 2) / (20e9 * 1e-5)
  return math.abs(found / exact - 1) < 0.01, string.format("dT = %.4f K, closed form %.4f K", found, exact)
end }
expect "at the top first" { that = function(result)
  local z = result.stage("cooling").first_crack_place.z
  return z == height, string.format("z = %g m, closed form %g m", z, height)
end }
