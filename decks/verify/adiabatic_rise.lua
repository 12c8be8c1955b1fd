-- Case hydration: concrete that makes 300 W/m^3 for ten days and lets no heat out.
-- Source: by hand. The rise is q t / (rho c) everywhere, 112.5 K.
-- Accept: 1e-9 of the rise.
-- Runs: elements=hex8 | elements=wedge6 | elements=tet4
local args = deck.args { elements = { default = "hex8", doc = "hex8, wedge6 or tet4" } }

model "adiabatic_rise" { reference_temperature = 12*degC }
box "lift" { from = { 0, 0, 0 }, to = { 3*m, 2*m, 1.5*m }, size = 0.5*m, elements = args.elements }
material "concrete" {
  region = "lift", young = 30*GPa, poisson = 0.2, density = 2400*kg/m^3,
  conductivity = 2.5*W/(m*K), heat_capacity = 960*J/(kg*K),
}
heat_source "hydration" { region = "lift", value = 300*W/m^3 }
stage "ten days" { solve = thermal { duration = 10*days } }

history "core"   { at = { 1.3*m, 0.9*m, 0.7*m }, record = { "temperature" } }
history "corner" { at = { 0, 0, 0 }, record = { "temperature" } }
for _, place in ipairs { "core", "corner" } do
  expect(place) { history = place, component = "temperature", value = (12 + 112.5)*degC, relative = 1e-9 }
end
