-- Case P33: blocks stacked on each other and on a rigid base settle by their own strain and by that of the contacts.
-- Source: closed form, sum over i of (n - i) w / k_n + ((n - i - 1) w + w / 2) h / E with w = rho g h. tet4: an
--         independent numpy program on the same mesh, since there every cell gives way along its diagonal faces too.
-- Accept: 1e-4.
-- Runs: elements=hex8 | elements=wedge6 | elements=tet4
local args = deck.args { elements = { default = "hex8", doc = "hex8, wedge6 or tet4 (each wedge or tetrahedron is a block)" } }
local n, h, young, density, g, normal_stiffness = 6, 1*m, 20*GPa, 2400*kg/m^3, 9.81, 1e11*Pa/m

model "stack" {}
box "base"  { from = { 0, 0, -h }, to = { 1*m, 1*m, 0 }, cells = { 1, 1, 1 }, elements = args.elements }
box "stack" { from = { 0, 0, 0 }, to = { 1*m, 1*m, n*h }, cells = { 1, 1, n }, elements = args.elements }
material "stone" { region = { "base", "stack" }, young = young, poisson = 0, density = density }
crackable "between" { region = "stack", law = "elastic", normal_stiffness = normal_stiffness, shear_stiffness = normal_stiffness }
joint "foot" { between = { "base", "stack" }, law = "elastic", normal_stiffness = normal_stiffness, shear_stiffness = normal_stiffness }
surface "rigid" { of = "base" }
fix "rigid" { surface = "rigid", x = 0, y = 0, z = 0 }
gravity { z = -g }
stage "gravity" { solve = static { tolerance = 1e-9 } }

local weight, settlement = 2400 * g * 1, 0
for i = 0, n - 1 do
  settlement = settlement + (n - i) * weight / 1e11 + ((n - i - 1) * weight + weight / 2) / 20e9
end
history "top" { at = { 1*m, 1*m, n*h }, record = { "displacement" } }
if args.elements == "tet4" then settlement = 3.320920e-5 end  -- mean of the six tetrahedra that meet there
expect "settlement of the top" { history = "top", component = "displacement.z", value = -settlement, relative = 1e-4 }
