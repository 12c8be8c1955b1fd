-- Cases P14 and P15: a bar of 10 m, held at one end and suddenly pulled with 1 MPa at the other, for eight transits.
-- Source: closed form. Wave speed sqrt(E / rho) = 3535.5 m/s, particle velocity 1 MPa / (rho c) = 0.11785 m/s, tip peak
--         twice the static pull. Without damping the energy stays: 9e-14 in an independent numpy program.
-- Accept: arrival of half the particle velocity at mid-length 3 %, tip peak 2 %, energy drift 1e-10.
-- Runs: step=0.5 | step=0.25 | elements=wedge6 step=0.5 | elements=tet4 step=0.45 |
--   elements=tet4 step=0.45 formulation=bbar
-- A bar of tetrahedra is stable below 0.5 only.
local args = deck.args {
  elements    = { default = "hex8", doc = "hex8, wedge6 or tet4" },
  formulation = { default = "full", doc = "full or bbar" },
  step        = { default = 0.5, doc = "time step over the time that a wave takes through a cell" },
}

local length, edge, young, density, pull = 10, 0.1, 30e9, 2400, 1e6
local speed = math.sqrt(young / density)
local time_step = args.step * edge / speed

model "bar_wave" {}
box "bar" { from = { 0, 0, 0 }, to = { length, edge, edge }, cells = { 100, 1, 1 }, elements = args.elements }
material "concrete" { region = "bar", young = young, poisson = 0, density = density, formulation = args.formulation }
surface "held"   { of = "bar", side = "left" }
surface "pulled" { of = "bar", side = "right" }
surface "front"  { of = "bar", side = "front" }
surface "bottom" { of = "bar", side = "bottom" }
fix { surface = "held", x = 0 }
fix { surface = "front", y = 0 }
fix { surface = "bottom", z = 0 }
traction { surface = "pulled", x = pull }
stage "pull" { solve = dynamic { duration = 8 * length / speed, time_step = time_step, record_every = time_step } }

history "middle" { at = { length / 2, 0, 0 }, record = { "velocity" } }
history "tip"    { at = { length, 0, 0 }, record = { "displacement" } }
history "energy" { record = { "energy" } }

expect "arrival" { that = function(result)
  local middle = result.history("middle")
  local seconds, velocity = middle.values("seconds", "pull"), middle.values("velocity.x", "pull")
  local i = 1
  while velocity[i] <= 0.5 * pull / (density * speed) do i = i + 1 end
  local exact = length / 2 / speed
  return math.abs(seconds[i] / exact - 1) < 0.03, string.format("%.5g s, closed form %.5g s", seconds[i], exact)
end }
expect "peak" { that = function(result)
  local peak = 0
  for _, u in ipairs(result.history("tip").values("displacement.x", "pull")) do peak = math.max(peak, u) end
  local exact = 2 * pull * length / young
  return math.abs(peak / exact - 1) < 0.02, string.format("%.5g m, twice the static pull %.5g m", peak, exact)
end }
expect "energy" { that = function(result)
  local drift = result.stage("pull").energy_drift
  return drift < 1e-10, string.format("drift %.1e of the peak, wanted 1e-10", drift)
end }
