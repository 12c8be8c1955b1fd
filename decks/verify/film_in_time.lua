-- Case film in time: a small warm cube in air, in a formwork that is taken away after three hours.
-- Source: closed form for a body of one temperature, T = Ta + (T0 - Ta) exp(- A / (rho c V) * integral of the film); air that
--         changes too: the same balance, d T / d t = - film A / (rho c V) (T - Ta), integrated by Runge and Kutta.
-- Accept: 0.05 K.
-- Runs: air=still | air=still elements=wedge6 | air=still elements=tet4 | air=changing
local args = deck.args {
  elements = { default = "hex8", doc = "hex8, wedge6 or tet4" },
  air      = { default = "still", doc = "still: 0 degC; changing: warms as the formwork goes" },
}
local edge, density, capacity, start = 0.2, 2400, 1000, 30

model "film_in_time" { reference_temperature = start*degC }
box "cube" { from = { 0, 0, 0 }, to = { edge, edge, edge }, cells = { 2, 2, 2 }, elements = args.elements }
-- It conducts so well that the whole cube has one temperature.
material "metal" {
  region = "cube", young = 30*GPa, poisson = 0.2, density = density, conductivity = 1000*W/(m*K),
  heat_capacity = capacity*J/(kg*K),
}
surface "skin" { of = "cube" }
local times, films, air = { 0, 10800, 10860 }, { 3, 3, 15 }, { 0, args.air == "still" and 0 or 8, args.air == "still" and 0 or 12 }
convection "air" {
  surface = "skin", ambient = args.air == "still" and 0 or in_time(times, air),
  film = { { 0*hours, 3*W/(m^2*K) }, { 3*hours, 3*W/(m^2*K) }, { 3*hours + 60*s, 15*W/(m^2*K) } },
}
stage "day" { solve = thermal { duration = 6*hours, record_every = 600*s } }

local function rate(t, temperature)
  local share = interpolate(times, films, t) * 6 / edge / (density * capacity)
  return -share * (temperature - interpolate(times, air, t))
end
history "middle" { at = { edge / 2, edge / 2, edge / 2 }, record = { "temperature" } }
expect "temperature" { that = function(result)
  local middle = result.history("middle")
  local seconds, found = middle.values("seconds", "day"), middle.values("temperature", "day")
  local worst, exact, at = 0, start, 0
  for i = 1, #found do
    while at < seconds[i] do
      local d = math.min(10, seconds[i] - at)
      local a = rate(at, exact)
      local b = rate(at + d / 2, exact + d / 2 * a)
      local c = rate(at + d / 2, exact + d / 2 * b)
      exact = exact + d / 6 * (a + 2 * b + 2 * c + rate(at + d, exact + d * c))
      at = at + d
    end
    if args.air == "still" then
      local film = 3 * math.min(at, 10800) + math.max(at - 10860, 0) * 15 + 9 * math.max(0, math.min(at - 10800, 60))
      exact = start * math.exp(-film * 6 / edge / (density * capacity))
    end
    worst = math.max(worst, math.abs(found[i] - exact))
  end
  return worst < 0.05, string.format("%.3f K off, %.2f degC at the end, wanted 0.05 K", worst, exact)
end }
