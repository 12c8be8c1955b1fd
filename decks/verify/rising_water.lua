-- Case rising water: water rises on a block that is free to slide (or under one that is free to lift) while it moves.
-- Source: closed form, Newton's law for the whole block: mass * acceleration = rho g h^2 / 2 * width for the thrust of a level
--         h, rho g (h1 + h2) / 2 * area for an uplift between two levels; integrated twice with Simpson's rule.
-- Accept: 2e-4 of the way; energy to 1e-9 of its peak.
-- Runs: load=thrust | load=thrust elements=wedge6 | load=thrust elements=tet4 | load=uplift
-- The load between the sample times of a level lies on straight lines: 1e-4 of the largest nodal load off at most.
local args = deck.args {
  elements = { default = "hex8", doc = "hex8, wedge6 or tet4" },
  load     = { default = "thrust", doc = "thrust or uplift" },
}
local thick, width, height, density, water, g = 4, 1, 9, 2400, 1000, 9.81
local thrust, duration = args.load == "thrust", 2

model "rising_water" {}
box "block" { from = { 0, 0, 0 }, to = { thick, width, height }, cells = { 4, 1, 9 }, elements = args.elements }
material "concrete" { region = "block", young = 30*GPa, poisson = 0.2, density = density }
surface "front" { of = "block", side = "front" }
fix { surface = "front", normal = true }
local times, levels = { 0, 0.8, 1.2, 2 }, { 0, 5, 8.5, 2 }
local function tail(t) return 1 + t end
if thrust then
  fix { surface = "block.bottom", normal = true }
  water_pressure "flood" { surface = "block.left", level = in_time(times, levels) }
else
  fix { surface = "block.left", normal = true }
  uplift "flood" {
    surface = "block.bottom",
    upstream_level = in_time(function(t) return 2 + interpolate(times, levels, t) end), downstream_level = in_time(tail),
  }
end
stage "flood" { solve = dynamic { duration = duration*s, record_every = 0.02*s } }

local function acceleration(t)
  local h = interpolate(times, levels, t)
  local force = thrust and water * g * h^2 / 2 * width or water * g * (2 + h + tail(t)) / 2 * thick * width
  return force / (density * thick * width * height)
end
history "middle" { at = { thick / 2, 0, height / 2 }, record = { "displacement" } }
expect "way" { that = function(result)
  local middle = result.history("middle")
  local seconds, way = middle.values("seconds", "flood"), middle.values(thrust and "displacement.x" or "displacement.z", "flood")
  local worst, speed, exact, at = 0, 0, 0, 0
  for i = 1, #way do
    local pieces = math.max(2, 2 * math.ceil((seconds[i] - at) / 2e-3))
    local d = (seconds[i] - at) / pieces
    for _ = 1, pieces do
      local a, b, c = acceleration(at), acceleration(at + d / 2), acceleration(at + d)
      exact = exact + speed * d + d^2 / 6 * (a + 2 * b)
      speed = speed + d / 6 * (a + 4 * b + c)
      at = at + d
    end
    worst = math.max(worst, math.abs(way[i] - exact))
  end
  return worst < 2e-4 * exact, string.format("off by %.2g of %.6g m, wanted 2e-4", worst / exact, exact)
end }
expect "energy" { that = function(result)
  local drift = result.stage("flood").energy_drift
  return drift < 1e-9, string.format("drift %.1e of the peak, wanted 1e-9", drift)
end }
