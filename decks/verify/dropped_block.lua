-- Case dropped block: a block falls flat on the ground, rebounds by what the damping of its contact leaves, and comes
--         to rest with its weight on the ground.
-- Source: closed form: mass on spring and dashpot without tension, under gravity: height of the rebound; weight.
-- Accept: rebound 1 %; weight 1e-6; energy drifts by less than 1e-3 of its peak.
-- Runs: damping=0 | damping=1e-4 | damping=4e-4 | damping=4e-4 elements=tet4 | damping=4e-4 ground=2
local args = deck.args {
  damping = { default = 4e-4, doc = "contact_damping, s" },
  elements = { default = "hex8", doc = "hex8, wedge6 or tet4" },
  ground = { default = 1, doc = "cells of the ground along a side; of 2 a node lies under the block" },
}
local side, height, density, g, stiffness = 0.2, 0.1, 2500, 9.81, 1e9
local mass, damping = density * side ^ 3, args.damping
local k = stiffness * side ^ 2
local speed, omega, xi = math.sqrt(2 * g * height), math.sqrt(k / mass), damping * math.sqrt(k / mass) / 2

-- Depth and its rate t seconds after touching the ground.
local function pressed(t)
  local turns, sinks = omega * math.sqrt(1 - xi * xi), mass * g / k
  local a, b = -sinks, (speed - xi * omega * sinks) / turns
  local c, s, decay = math.cos(turns * t), math.sin(turns * t), math.exp(-xi * omega * t)
  local depth = sinks + decay * (a * c + b * s)
  return depth, decay * ((b * turns - xi * omega * a) * c - (a * turns + xi * omega * b) * s)
end
-- It leaves when spring and dashpot together would begin to pull.
local low, high = math.pi / 2 / omega, math.pi / omega
for _ = 1, 60 do
  local middle = (low + high) / 2
  local depth, rate = pressed(middle)
  if depth + damping * rate > 0 then low = middle else high = middle end
end
local depth, rate = pressed(low)
local rebound = rate * rate / (2 * g) - depth
local first = speed / g + low - rate / g  -- when it is highest again

model "drop" {}
box "ground" {
  from = { -0.4, -0.4, -0.2 }, to = { 0.6, 0.6, 0 }, cells = { args.ground, args.ground, 1 },
  elements = args.elements,
}
box "block" {
  from = { 0, 0, height }, to = { side, side, height + side }, cells = { 1, 1, 1 }, elements = args.elements,
}
material "rock" { region = { "ground", "block" }, density = density*kg/m^3, young = 30*GPa, poisson = 0.2 }
joint "contact" {
  between = { "ground", "block" }, law = "frictional", friction = 30*deg, normal_stiffness = stiffness*Pa/m,
  shear_stiffness = stiffness*Pa/m,
}
surface "held" { of = "ground" }
fix { surface = "held", x = 0, y = 0, z = 0 }
gravity { z = -g }
stage "rebound" {
  solve = dynamic {  -- a dashpot lags by half a step: short ones
    duration = first, large_displacement = true, contact_damping = damping, record_every = first / 100,
    time_factor = 0.3,
  },
}
if damping > 2e-4 then
  stage "rest" { solve = dynamic { duration = 1*s, large_displacement = true, contact_damping = damping } }
end
history "block" { at = { side / 2, side / 2, height + side }, record = { "displacement", "velocity" } }
history "ground" { surface = "held", record = { "reaction" } }

expect "rebounds to" {
  history = "block", component = "displacement.z", stage = "rebound", value = rebound - height,
  tolerance = 0.01 * rebound,
}
expect "energy drift" { that = function(result)
  local drift = result.stage("rebound").energy_drift
  return drift < 1e-3, string.format("%.2g of the peak", drift)
end }
if damping > 2e-4 then
  expect "weight" {
    history = "ground", component = "reaction.z", stage = "rest", value = (mass + density * 0.2) * g, relative = 1e-6,
  }
end
