-- Case P20: a slab of 2 m, 28.2 degC, cools in air of -1.6 degC on both faces (film 15 W/m2K). Half of it is modelled.
-- Source: closed form (Heisler series) at the middle x = 0, at x = 0.5 m and at the face x = 1 m.
-- Accept: 0.1 K with 20 elements over the half.
-- Runs: elements=hex8 | elements=wedge6 | elements=tet4
local args = deck.args { elements = { default = "hex8", doc = "hex8, wedge6 or tet4" } }

model "slab" { reference_temperature = 28.2*degC }
box "slab" { from = { 0, 0, 0 }, to = { 1*m, 0.05*m, 0.05*m }, cells = { 20, 1, 1 }, elements = args.elements }
material "concrete" {
  region = "slab", young = 30*GPa, poisson = 0.2, density = 2400*kg/m^3,
  conductivity = 2.7*W/(m*K), heat_capacity = 960*J/(kg*K),
}
surface "face" { of = "slab", side = "right" }
convection { surface = "face", ambient = -1.6*degC, film = 15*W/(m^2*K) }

stage "1 day"   { solve = thermal { duration = 1*days } }
stage "5 days"  { solve = thermal { duration = 4*days } }
stage "20 days" { solve = thermal { duration = 15*days } }

for x, values in pairs { [0] = { 27.4530, 13.4467, -0.5953 }, [0.5] = { 23.5733, 10.2202, -0.8109 },
                                [1] = { 6.8232, 1.9175, -1.3653 } } do
  local name = "x = " .. x
  history(name) { at = { x, 0, 0 }, record = { "temperature" } }
  for i, stage in ipairs { "1 day", "5 days", "20 days" } do
    expect(name .. " after " .. stage) {
      history = name, component = "temperature", stage = stage, value = values[i], tolerance = 0.1,
    }
  end
end
