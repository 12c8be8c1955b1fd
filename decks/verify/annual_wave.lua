-- Case annual wave: the temperature of the year goes down into the ground; given on all faces of a block as a function of
-- place and time, found inside.
-- Source: closed form (Carslaw and Jaeger, Conduction of Heat in Solids, 2.6): 10 + 12 exp(-d / s) cos(w t - d / s) at depth d,
--         s = sqrt(2 k / (rho c w)).
-- Accept: 0.05 K with elements of 0.5 m.
-- Runs: elements=hex8 | elements=wedge6 | elements=tet4
local args = deck.args { elements = { default = "hex8", doc = "hex8, wedge6 or tet4" } }
local deep, wide, conductivity, density, capacity = 8, 4, 2.7, 2400, 960
local w = 2 * math.pi / (365.25 * 86400)
local fades = math.sqrt(2 * conductivity / (density * capacity * w))
local function wave(_, _, z, t) return 10 + 12 * math.exp(z / fades) * math.cos(w * t + z / fades) end

model "annual_wave" { reference_temperature = 10*degC }
box "ground" { from = { 0, 0, -deep }, to = { wide, wide, 0 }, size = 0.5, elements = args.elements }
material "ground" {
  region = "ground", young = 30*GPa, poisson = 0.2, density = density, conductivity = conductivity*W/(m*K),
  heat_capacity = capacity*J/(kg*K),
}
surface "faces" { of = "ground" }
initial_temperature { value = function(x, y, z) return wave(x, y, z, 0) end }
fixed_temperature { surface = "faces", value = wave }
stage "year" { solve = thermal { duration = 365*days, record_every = 5*days } }

for _, depth in ipairs { 1, 3, 6 } do
  local name = depth .. " m deep"
  history(name) { at = { wide / 2, wide / 2, -depth }, record = { "temperature" } }
  expect(name) { that = function(result)
    local curve = result.history(name)
    local seconds, found = curve.values("seconds", "year"), curve.values("temperature", "year")
    local worst = 0
    for i = 2, #found do worst = math.max(worst, math.abs(found[i] - wave(0, 0, -depth, seconds[i]))) end
    return worst < 0.05, string.format("%.3f K off, wanted 0.05 K", worst)
  end }
end
