-- Case heat source: a wall of 2 m that makes 300 W/m^3, its faces held at 10 degC; then its right half stops.
-- Source: closed form, T = 10 + q x (L - x) / (2 k) with q all over; with q on the left half only,
--         T(L/2) = T(L/4) = 10 + q L^2 / (16 k)  (conduction in one dimension, integrated twice).
-- Accept: 1e-6 K on hex8, exact at nodes with consistent loads; 0.5 K on wedge6 and tet4 with the half wall, whose
--         unsymmetric split shares the source unevenly between the nodes of the middle plane.
-- Runs: elements=hex8 | elements=wedge6 | elements=tet4
local args = deck.args { elements = { default = "hex8", doc = "hex8, wedge6 or tet4" } }
local q, k, L = 300, 2.5, 2

model "heated_wall" { reference_temperature = 10*degC }
box "left"  { from = { 0, 0, 0 }, to = { 1*m, 0.25*m, 0.25*m }, cells = { 4, 1, 1 }, elements = args.elements }
box "right" { from = { 1*m, 0, 0 }, to = { 2*m, 0.25*m, 0.25*m }, cells = { 4, 1, 1 }, elements = args.elements }
material "concrete" {
  region = { "left", "right" }, young = 30*GPa, poisson = 0.2, density = 2400*kg/m^3, conductivity = k*W/(m*K),
}
surface "faces" { side = { "left", "right" } }
fixed_temperature { surface = "faces", value = 10*degC }

stage "all"  { apply = { heat_source { value = q*W/m^3 } }, solve = thermal { steady = true, tolerance = 1e-13 } }
stage "half" {
  apply = { heat_source { region = "right", value = 0*W/m^3 } },
  solve = thermal { steady = true, tolerance = 1e-13 },
}

history "middle"  { at = { 1*m, 0, 0 }, record = { "temperature" } }
history "quarter" { at = { 0.5*m, 0, 0 }, record = { "temperature" } }
for _, case in ipairs {
  { "all", "middle", q*L^2/(8*k) }, { "all", "quarter", 3*q*L^2/(32*k) },
  { "half", "middle", q*L^2/(16*k) }, { "half", "quarter", q*L^2/(16*k) },
} do
  local stage, place, rise = table.unpack(case)
  expect(place .. " with " .. stage) {
    history = place, component = "temperature", stage = stage, value = (10 + rise)*degC,
    tolerance = (stage == "half" and args.elements ~= "hex8") and 0.5 or 1e-6,
  }
end
