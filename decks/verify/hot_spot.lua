-- Case P11: NAFEMS T1, a thin sheet of 20 mm x 20 mm; a spot of 1 mm radius in its middle wants to grow by 1e-3.
-- Source: NAFEMS benchmark T1: hoop stress +50 MPa just outside of the spot; closed form for a wide sheet: -E alpha T / 2 all
--         over the spot, and -+ E alpha T / 2 (a / r)^2 along and around at r outside of it.
-- Accept: 5 %, from the nodes; of hex8 and wedge6 beside the arc also of the elements' means.
-- Runs: elements=hex8 | elements=wedge6 | elements=tet4
local args = deck.args { elements = { default = "hex8", doc = "hex8, wedge6 or tet4" } }
local unit = 1e-3
local a, side, thick, young, growth = 1*unit, 10*unit, 0.05*unit, 100e9, 1e-3

model "hot_spot" { reference_temperature = 0*degC }
-- A quarter. Spot and sheet are two bodies that share the arc.
local arc = {}
for i = 0, 24 do arc[#arc + 1] = { a * math.cos(math.pi / 2 * i / 24), a * math.sin(math.pi / 2 * i / 24) } end
arc[#arc][1] = 0  -- cos of a right angle is not quite 0
local spot, sheet = { { 0, 0 } }, { { side, 0 }, { side, side }, { 0, side } }
for i = 1, #arc do
  spot[#spot + 1] = arc[i]
  sheet[#sheet + 1] = arc[#arc + 1 - i]
end
extrude "spot"  { section = spot, length = thick, layers = 1, size = 0.07*unit, structured = false, elements = args.elements }
extrude "sheet" {
  section = sheet, length = thick, layers = 1, size = 1*unit, grow = 1.1, structured = false, elements = args.elements,
}
material "hot"  { region = "spot", young = young*Pa, poisson = 0.3, density = 7850*kg/m^3, expansion = 1e-5/K }
material "cold" { region = "sheet", young = young*Pa, poisson = 0.3, density = 7850*kg/m^3, expansion = 0/K }
surface "left"   { plane = { { 0, 0, 0 }, { 1, 0, 0 } } }
surface "bottom" { plane = { { 0, 0, 0 }, { 0, 0, 1 } } }
surface "front"  { side = "front" }
fix "symmetry" { surface = { "left", "bottom", "front" }, normal = true }
temperature_field { value = 100*degC }
stage "warm" { solve = static { tolerance = 1e-8 } }

local function compare(r, field)
  local name = string.format("r = %.2f mm", r)
  history(name) { at = { r*unit, thick / 2, 0 }, record = { field } }
  local around = r < 1 and -young * growth / 2 or young * growth / 2 / r^2
  local along = r < 1 and around or -around
  expect("hoop stress at " .. name) { history = name, component = field .. ".zz", value = around, relative = 0.05 }
  expect("radial stress at " .. name) { history = name, component = field .. ".xx", value = along, relative = 0.05 }
end
for _, r in ipairs { 0.3, 0.8, 1.25, 1.5 } do compare(r, "nodal_stress") end
-- Single tetrahedra share the stress of their prism unevenly.
if args.elements ~= "tet4" then
  for _, r in ipairs { 0.9, 1.1 } do compare(r, "stress") end
end
