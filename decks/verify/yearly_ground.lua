-- Case years in the ground: concrete 24 m deep, held sideways, under a yearly wave of temperature from its surface (given
-- there, or through a film) and a yearly load on it, split by an elastic joint: heat and stress marched together.
-- Source: closed form. T = Tm + A g exp(z/d) sin(w t + z/d - f), d^2 = 2 a / w; through a film h with q = k / (h d):
--   g = 1 / sqrt((1 + q)^2 + q^2), tan f = q / (1 + q). s_xx = -(E alpha (T - Tm) + nu p) / (1 - nu), s_zz = -p;
--   top = (1 + nu)/(1 - nu) alpha A g d/sqrt(2) sin(w t - f - pi/4) - p (L / E_oed + 1 / k_n).
-- Accept: 0.5 % of the largest stress and movement, at 28 times in two years and a quarter and three depths.
-- Runs: | film=15 | elements=wedge6 | elements=wedge6 film=15
local args = deck.args {
  elements = { default = "hex8", doc = "hex8 or wedge6; the mean of a tet4 belongs to the depth of its centroid" },
  film = { default = 0, unit = W/(m^2*K), doc = "film coefficient; 0: the temperature of the surface is given" },
}
local depth, joint_depth, period = 24*m, 12*m, 365*days
local mean, swing = 10*degC, 12*degC
local E, nu, alpha, k, rho, c = 25*GPa, 0.2, 1e-5/K, 2.5*W/(m*K), 2400*kg/m^3, 960*J/(kg*K)
local k_n = 20*GPa/m

-- Plain numbers, SI, of the closed form.
local L, w, a = 24, 2 * math.pi / (365 * 86400), 2.5 / (2400 * 960)
local d = math.sqrt(2 * a / w)
local q = args.film > 0*W/(m^2*K) and 2.5 / (args.film / (1*W/(m^2*K)) * d) or 0
local g, f = 1 / math.sqrt((1 + q)^2 + q^2), math.atan(q, 1 + q)
local function warming(t, z) return 12 * g * math.exp(z / d) * math.sin(w * t + z / d - f) end
local function load(t) return 1e6 * (1 - math.cos(w * t)) end
local function sideways(t, z) return -(25e9 * 1e-5 * warming(t, z) + 0.2 * load(t)) / 0.8 end
local function top(t)
  local oedometer = 25e9 * 0.8 / (1.2 * 0.6)
  return 1.2 / 0.8 * 1e-5 * 12 * g * d / math.sqrt(2) * math.sin(w * t - f - math.pi / 4)
    - load(t) * (L / oedometer + 1 / 20e9)
end

model "yearly_ground" { reference_temperature = mean }
box "upper" { from = { 0, 0, -joint_depth }, to = { 1*m, 1*m, 0 }, cells = { 1, 1, 60 }, elements = args.elements }
box "lower" { from = { 0, 0, -depth }, to = { 1*m, 1*m, -joint_depth }, cells = { 1, 1, 60 }, elements = args.elements }
material "concrete" {
  region = { "upper", "lower" }, young = E, poisson = nu, expansion = alpha, density = rho, conductivity = k,
  heat_capacity = c,
}
joint "middle" { between = { "upper", "lower" }, law = "elastic", normal_stiffness = k_n, shear_stiffness = k_n }

surface "sides"  { of = { "upper", "lower" }, side = { "left", "right", "front", "back" } }
surface "top"    { of = "upper", side = "top" }
surface "bottom" { of = "lower", side = "bottom" }
fix { surface = "sides", normal = true }
fix { surface = "bottom", normal = true }
pressure { surface = "top", value = in_time(function(t) return load(t) end) }
initial_temperature { value = function(x, y, z) return 10 + warming(0, z) end }
local air = in_time(function(t) return 10 + 12 * math.sin(w * t) end)
if args.film > 0*W/(m^2*K) then
  convection { surface = "top", ambient = air, film = args.film }
else
  fixed_temperature { surface = "top", value = air }
end

stage "start" { solve = static { tolerance = 1e-8 } }
stage "years" { solve = coupled { duration = 2.25 * period, every = period / 12, tolerance = 1e-8 } }

history "top" { at = { 0, 0, 0 }, record = { "displacement", "temperature" } }
local places = { [0.1] = "shallow", [2.1] = "deep", [11.9] = "at the joint" }
for below, name in pairs(places) do
  history(name) { at = { 0.5*m, 0.5*m, -below*m }, record = { "stress", "temperature" } }
end

-- Largest difference from `exact(t, depth)` in all rows and at all `depths`, against `scale`.
local function worst(result, depths, column, exact, scale)
  local most, rows = 0, 0
  for below, name in pairs(depths) do
    local h = result.history(name)
    local seconds, values = h.values("seconds", "years"), h.values(column, "years")
    for i, t in ipairs(seconds) do most = math.max(most, math.abs(values[i] - exact(t, -below))) end
    rows = #seconds
  end
  return rows == 28 and most <= 0.005 * scale, string.format("%d rows, off by %.3g %%", rows, 100 * most / scale)
end
local largest, last = 25e9 * 1e-5 * 12 / 0.8, 2.25 * 365 * 86400
expect "top" { that = function(result)
  return worst(result, { [0] = "top" }, "displacement.z", top, 2e6 * L / (25e9 * 0.8 / (1.2 * 0.6)))
end }
expect "sideways" { that = function(result) return worst(result, places, "stress.xx", sideways, largest) end }
expect "down" { that = function(result) return worst(result, places, "stress.zz", function(t) return -load(t) end, 2e6) end }
expect "temperature" { that = function(result)
  return worst(result, places, "temperature", function(t, z) return 10 + warming(t, z) end, 12)
end }
expect "top at the end" {
  history = "top", component = "displacement.z", value = top(last)*m, tolerance = 0.005 * 2.16e-3*m,
}
for below, name in pairs(places) do
  expect("sideways at the end, " .. name) {
    history = name, component = "stress.xx", value = sideways(last, -below)*Pa, tolerance = 0.005 * largest*Pa,
  }
end
