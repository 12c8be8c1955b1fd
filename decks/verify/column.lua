-- Cases P4, P5: a column under its own weight, held at the sides (P4) or free with poisson = 0 (P5).
-- Source: closed form, u_z = -rho g (H z - z^2/2) / M with M = E (1 - nu) / ((1 + nu) (1 - 2 nu)), or E for the free column.
--         tet4 near the top: numpy finite elements on the same mesh, since tetrahedra share out weight unevenly.
-- Accept: 1e-5 of nodal displacement and of stress at element centres; hexahedra and wedges meet both exactly.
-- Runs: elements=hex8 | elements=wedge6 | elements=tet4 | sides=free elements=hex8 | sides=free elements=wedge6 | sides=free elements=tet4
local args = deck.args {
  sides    = { default = "held", doc = "held: rollers on the four sides (P4); free: nothing there (P5)" },
  elements = { default = "hex8", doc = "hex8, wedge6 or tet4" },
}
local held = args.sides == "held"
local young, poisson, density, g, height, cells = 20*GPa, held and 0.2 or 0, 2400*kg/m^3, 9.81, 20, 10

model "column" {}
box "column" { from = { 0, 0, 0 }, to = { 2*m, 2*m, height }, cells = { 2, 2, cells }, elements = args.elements }
material "concrete" { region = "column", young = young, poisson = poisson, density = density }
surface "bottom" { of = "column", side = "bottom" }
surface "left"   { of = "column", side = "left" }
surface "front"  { of = "column", side = "front" }
surface "sides"  { of = "column", side = { "left", "right", "front", "back" } }
fix "base" { surface = "bottom", z = 0 }
if held then
  fix "rollers" { surface = "sides", normal = true }
else
  fix "symmetry" { surface = { "left", "front" }, normal = true }
end
gravity { z = -g }
stage "gravity" { solve = static { tolerance = 1e-9 } }

-- The numpy program's answers for six tetrahedra per cell.
local on_tetrahedra = args.elements == "tet4" and (held
  and { settlement = { [20] = -2.118877055e-4 }, stress = { [19] = -20885.26909 } }
  or  { settlement = { [20] = -2.354227669e-4 }, stress = { [19] = -21259.00806 } })
  or { settlement = {}, stress = {} }

local modulus = 2e10 * (1 - poisson) / ((1 + poisson) * (1 - 2 * poisson))
for _, z in ipairs { 4, 10, 20 } do
  history("node at " .. z) { at = { 1, 1, z }, record = { "displacement" } }
  expect("settlement at z = " .. z .. (on_tetrahedra.settlement[z] and ", numpy" or "")) {
    history = "node at " .. z, component = "displacement.z", relative = 1e-5,
    value = on_tetrahedra.settlement[z] or -2400 * g * (height * z - z^2 / 2) / modulus,
  }
end
for _, z in ipairs { 1, 9, 19 } do
  history("centre at " .. z) { at = { 0.6, 0.4, z }, record = { "stress" } }
  expect("stress at z = " .. z .. (on_tetrahedra.stress[z] and ", numpy" or "")) {
    history = "centre at " .. z, component = "stress.zz", relative = 1e-5,
    value = on_tetrahedra.stress[z] or -2400 * g * (height - z),
  }
end
history "support" { surface = "bottom", record = { "reaction" } }
expect "weight" { history = "support", component = "reaction.z", value = 2400 * g * 2 * 2 * height, relative = 1e-5 }
