-- Cases P21, P22, P23: concrete of 15 degC, 25 m deep, heated at its surface for 1, 10 and 100 days.
-- Source: closed form for the half space (error functions).
-- Accept: 0.1 K with elements of 0.05 m near the surface.
-- Runs: heating=temperature | heating=flux | heating=film | heating=temperature elements=wedge6 | heating=flux elements=wedge6 | heating=film elements=wedge6 | heating=temperature elements=tet4 | heating=flux elements=tet4 | heating=film elements=tet4
local args = deck.args {
  elements = { default = "hex8", doc = "hex8, wedge6 or tet4" },
  heating  = { default = "temperature", doc = "temperature 28.2 degC (P21), flux 20 W/m2 (P22), film to 28.2 degC (P23)" },
}

model "half_space" { reference_temperature = 15*degC }
-- A bar of 0.2 m: tetrahedra share out the surface's heat unevenly among its nodes, which even out over short ways.
local wide = 0.2*m
box "near" { from = { 0, 0, 0 }, to = { 3*m, wide, wide }, cells = { 60, 1, 1 }, elements = args.elements }
box "far"  { from = { 3*m, 0, 0 }, to = { 25*m, wide, wide }, cells = { 88, 1, 1 }, elements = args.elements }
material "concrete" {
  region = { "near", "far" }, young = 30*GPa, poisson = 0.2, density = 2400*kg/m^3,
  conductivity = 2.7*W/(m*K), heat_capacity = 960*J/(kg*K),
}
surface "surface" { of = "near", side = "left" }
if args.heating == "temperature" then
  fixed_temperature { surface = "surface", value = 28.2*degC }
elseif args.heating == "flux" then
  flux { surface = "surface", value = 20*W/m^2 }
else
  convection { surface = "surface", ambient = 28.2*degC, film = 15*W/(m^2*K) }
end

local stages = { "1 day", "10 days", "100 days" }
stage(stages[1]) { solve = thermal { duration = 1*days } }
stage(stages[2]) { solve = thermal { duration = 9*days } }
stage(stages[3]) { solve = thermal { duration = 90*days } }

local exact = ({
  temperature = { [0.5] = { 18.5181, 24.5742, 27.0322 }, [2] = { 15.0001, 17.1105, 23.6687 } },
  flux = { [0] = { 17.6596, 23.4104, 41.5962 }, [0.5] = { 15.4475, 20.2206, 38.0565 }, [2] = { 15.0000, 15.7638, 29.3657 } },
  film = { [0] = { 24.4689, 26.8882, 27.7794 }, [0.5] = { 17.0449, 23.3919, 26.6160 }, [2] = { 15.0000, 16.6939, 23.2943 } },
})[args.heating]
for depth, values in pairs(exact) do
  local name = "depth " .. depth
  history(name) { at = { depth, 0, 0 }, record = { "temperature" } }
  for i, stage in ipairs(stages) do
    expect(name .. " after " .. stage) {
      history = name, component = "temperature", stage = stage, value = values[i], tolerance = 0.1,
    }
  end
end
