-- Case P24: steady heat through a wall of 3 m between air (28.2 degC, film 15) and water (19.5 degC, film 500).
-- Source: closed form, q = (28.2 - 19.5) / (1/15 + 3/2.7 + 1/500) = 7.3743 W/m2.
-- Accept: 1e-6; linear elements are exact here.
-- Runs: elements=hex8 | elements=wedge6 | elements=tet4
local args = deck.args { elements = { default = "hex8", doc = "hex8, wedge6 or tet4" } }

model "wall" { reference_temperature = 15*degC }
box "wall" { from = { 0, 0, 0 }, to = { 3*m, 1*m, 1*m }, cells = { 6, 2, 2 }, elements = args.elements }
material "concrete" { region = "wall", young = 30*GPa, poisson = 0.2, density = 2400*kg/m^3, conductivity = 2.7*W/(m*K) }
surface "air"   { of = "wall", side = "left" }
surface "water" { of = "wall", side = "right" }
convection { surface = "air", ambient = 28.2*degC, film = 15*W/(m^2*K) }
convection { surface = "water", ambient = 19.5*degC, film = 500*W/(m^2*K) }
stage "steady" { solve = thermal { steady = true, tolerance = 1e-12 } }

local q = (28.2 - 19.5) / (1 / 15 + 3 / 2.7 + 1 / 500)
for x, temperature in pairs { [0] = 28.2 - q / 15, [1.5] = 28.2 - q / 15 - q * 1.5 / 2.7, [3] = 19.5 + q / 500 } do
  local name = "x = " .. x
  history(name) { at = { x, 0.5, 0.5 }, record = { "temperature" } }
  expect(name) { history = name, component = "temperature", value = temperature, relative = 1e-6 }
end
expect "heat flux" { that = function(result)
  local found = (result.history("x = 0").at("temperature") - result.history("x = 3").at("temperature")) * 2.7 / 3
  return math.abs(found / 7.3743 - 1) < 1e-5, string.format("%.6f W/m2, closed form 7.3743", found)
end }
