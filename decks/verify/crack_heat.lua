-- Case heat through a crack: two slabs whose meshes share their nodes (or do not) between two temperatures; heat passes the
--   joint by its conductance, until it is pulled open.
-- Source: closed form: resistances in a row, height / conductivity of each slab and 1 / conductance of the joint, closed or
--   open; where nothing passes an open joint each slab takes the temperature of its own face.
-- Accept: 0.01 % of the difference.
-- Runs: meshes=shared | meshes=apart | meshes=shared air=1.3 | meshes=shared solve=coupled
local args = deck.args {
  meshes = { default = "shared", doc = "shared or apart: whether the slabs have the same divisions" },
  air = { default = 0, doc = "conductance of the open joint, W/(m^2 K)" },
  solve = { default = "thermal", doc = "thermal: opened between two thermal stages; coupled: while heat flows" },
}
local conductivity, hot, closed, lower, upper = 2.7, 20, 5.4, 0.5, 0.7

model "crack_heat" { reference_temperature = 0*degC }
box "lower" { from = { 0, 0, 0 }, to = { 1, 1, lower }, cells = { 2, 2, 5 } }
box "upper" { from = { 0, 0, lower }, to = { 1, 1, lower + upper }, cells = args.meshes == "apart" and { 3, 3, 7 } or { 2, 2, 7 } }
material "concrete" {
  region = { "lower", "upper" }, young = 30*GPa, poisson = 0, density = 2400*kg/m^3,
  conductivity = conductivity*W/(m*K), heat_capacity = 960*J/(kg*K), expansion = 0/K,
}
joint "plane" {
  between = { "lower", "upper" }, law = "brittle", tensile_strength = 0.5*MPa, cohesion = 1*MPa, friction = 30*deg,
  conductance = closed*W/(m^2*K), open_conductance = args.air > 0 and args.air*W/(m^2*K) or nil,
}
fix { surface = "lower.bottom", x = 0, y = 0, z = 0 }
gravity { z = -9.81 }
fixed_temperature { surface = "lower.bottom", value = 0*degC }
fixed_temperature { surface = "upper.top", value = hot*degC }
local function pulled(by) return displacement { surface = "upper.top", x = 0, y = 0, z = by } end
stage "sound" { solve = thermal { steady = true } }
if args.solve == "coupled" then
  stage "open" {
    apply = { pulled(in_stage { time = { 0*s, 4*day }, value = { 0*mm, 1*mm } }) },
    solve = coupled { duration = 80*day, every = 4*day },
  }
else
  stage "pull" { apply = { pulled(1*mm) }, solve = static {} }
  stage "open" { solve = thermal { steady = true } }
end

local places = { low = 0.2, below = lower - 1e-6, above = lower + 1e-6, high = 0.9 }
for name, z in pairs(places) do
  history(name) { at = { 0.37, 0.42, z }, record = { "temperature" } }
  for when, conductance in pairs { sound = closed, open = args.air } do
    local flow = conductance > 0 and hot / ((lower + upper) / conductivity + 1 / conductance) or 0
    local wanted = z < lower and flow * z / conductivity or hot - flow * (lower + upper - z) / conductivity
    expect(name .. ", " .. when) {
      history = name, component = "temperature", stage = when, value = wanted*degC, tolerance = 0.002*K,
    }
  end
end
