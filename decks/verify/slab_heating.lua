-- Case P19: a slab of 1 m of concrete, 15 degC, its faces suddenly at 28.2 and 19.5 degC: temperature in its middle.
-- Source: closed form (series).
-- Accept: 0.05 K with 20 elements.
-- Runs: elements=hex8 | elements=wedge6 | elements=tet4
local args = deck.args { elements = { default = "hex8", doc = "hex8, wedge6 or tet4" } }

model "slab" { reference_temperature = 15*degC }
box "slab" { from = { 0, 0, 0 }, to = { 1*m, 0.05*m, 0.05*m }, cells = { 20, 1, 1 }, elements = args.elements }
material "concrete" {
  region = "slab", young = 30*GPa, poisson = 0.2, density = 2400*kg/m^3,
  conductivity = 2.7*W/(m*K), heat_capacity = 960*J/(kg*K),
}
surface "left"  { of = "slab", side = "left" }
surface "right" { of = "slab", side = "right" }
fixed_temperature { surface = "left", value = 28.2*degC }
fixed_temperature { surface = "right", value = 19.5*degC }

stage "1 day"   { solve = thermal { duration = 1*days } }
stage "5 days"  { solve = thermal { duration = 4*days } }
stage "20 days" { solve = thermal { duration = 15*days } }

history "middle" { at = { 0.5*m, 0, 0 }, record = { "temperature" } }
for stage, temperature in pairs { ["1 day"] = 19.7022, ["5 days"] = 23.7738, ["20 days"] = 23.8500 } do
  expect("middle after " .. stage) {
    history = "middle", component = "temperature", stage = stage, value = temperature*degC, tolerance = 0.05,
  }
end
