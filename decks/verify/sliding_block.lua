-- Case P34: a block on a slope, friction angle 30 degrees, without and with cohesion.
-- Source: closed form: it stays while W sin(slope) <= c A + W cos(slope) tan(friction), then slides with
--         a = g (sin(slope) - cos(slope) tan(friction)).
-- Accept: half a degree below it stays: moves as far as its springs give under W sin(slope), 2 % at a corner; half a degree
--         above it slides, acceleration 1 %.
-- Runs: elements=hex8 | elements=wedge6 | elements=tet4 | elements=hex8 cohesion=true | elements=wedge6 cohesion=true |
--       elements=tet4 cohesion=true
local args = deck.args {
  elements = { default = "hex8", doc = "hex8, wedge6 or tet4" },
  cohesion = { default = false, doc = "whether the block is also bonded to the slope" },
}
-- The block is flat: its weight acts close to the slope and presses on it nearly evenly.
local thick, density, g, friction, stiffness = 0.005, 2500, 9.81, 30*deg, 1e10*Pa/m

model "slope" {}
box "slope" { from = { 0, 0, -0.5 }, to = { 1, 1, 0 }, cells = { 1, 1, 1 }, elements = args.elements }
box "block" { from = { 0, 0, 0 }, to = { 1, 1, thick }, cells = { 1, 1, 1 }, elements = args.elements }
material "rock" { region = { "slope", "block" }, young = 30*GPa, poisson = 0, density = density*kg/m^3 }
-- With cohesion it would hold up to 50 degrees.
local steepest = args.cohesion and 50*deg or friction
local weight = density * thick * g  -- per area of contact
local cohesion = weight * (math.sin(steepest) - math.cos(steepest) * math.tan(friction))
joint "contact" {
  between = { "slope", "block" }, law = args.cohesion and "brittle" or "frictional", friction = friction,
  normal_stiffness = stiffness, shear_stiffness = stiffness,
  cohesion = args.cohesion and cohesion*Pa or nil, tensile_strength = args.cohesion and cohesion*Pa or nil,
}
surface "held" { of = "slope" }
fix { surface = "held", x = 0, y = 0, z = 0 }
local function tilted(angle) return gravity { x = g * math.sin(angle), z = -g * math.cos(angle) } end
local above = steepest + 0.5*deg
stage "below" { apply = { tilted(steepest - 0.5*deg) }, solve = static { tolerance = 1e-9 } }
stage "above" { apply = { tilted(above) }, solve = dynamic { duration = 0.1*s } }

history "block" { at = { 1, 1, thick }, record = { "displacement", "velocity" } }
local strength = weight * math.sin(steepest - 0.5*deg)  -- carried by the springs below the limit
expect "stays below" {
  history = "block", component = "displacement.x", stage = "below", value = strength / 1e10, relative = 0.02,
}
expect "acceleration above" { that = function(result)
  local block = result.history("block")
  local seconds, velocity = block.values("seconds", "above"), block.values("velocity.x", "above")
  local last, half = #seconds, #seconds // 2
  local found = (velocity[last] - velocity[half]) / (seconds[last] - seconds[half])
  local exact = g * (math.sin(above) - math.cos(above) * math.tan(friction))
  return math.abs(found / exact - 1) < 0.01, string.format("%.5g m/s^2, closed form %.5g m/s^2", found, exact)
end }
