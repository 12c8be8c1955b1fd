-- Case P34 (far): a block slides ten times its length down a slope, over the edges between the slope's elements; on a
--         flatter slope it goes on leaning on its friction as it did in a static stage.
-- Source: closed form: s = g (sin(slope) - cos(slope) tan(friction)) t^2 / 2; below the friction angle 0.
-- Accept: distance and speed 1 % of what they are at the end, at every record; leaning it moves less than twice what
--         its springs give under W sin(slope); energy drifts by less than 1e-3 of its peak.
-- Runs: elements=hex8 | elements=wedge6 | elements=tet4 | slope=25
local args = deck.args {
  elements = { default = "hex8", doc = "hex8, wedge6 or tet4" },
  slope = { default = 35, doc = "degrees; the friction angle is 30" },
}
local size, thick, density, g, stiffness = 0.1, 0.02, 2500, 9.81, 1e9
local slope, friction = args.slope * deg, 30*deg
local distance, leans = 10 * size, args.slope < 30
local acceleration = g * (math.sin(slope) - math.cos(slope) * math.tan(friction))
local duration = leans and 0.2 or math.sqrt(2 * distance / acceleration)

model "slope" {}
box "slope" { from = { -0.03, -0.07, -0.1 }, to = { 1.25, 0.19, 0 }, cells = { 11, 3, 1 }, elements = args.elements }
box "block" { from = { 0, 0, 0 }, to = { size, size, thick }, cells = { 2, 2, 1 }, elements = args.elements }
material "rock" { region = { "slope", "block" }, density = density*kg/m^3, young = 1*GPa, poisson = 0.2 }
joint "contact" {
  between = { "slope", "block" }, law = "frictional", friction = friction, normal_stiffness = stiffness*Pa/m,
  shear_stiffness = stiffness*Pa/m,
}
fix { surface = "slope.bottom", x = 0, y = 0, z = 0 }
gravity { x = g * math.sin(slope), z = -g * math.cos(slope) }
if leans then stage "lean" { solve = static { tolerance = 1e-9 }, reset_displacement = true } end
stage "slide" {
  solve = dynamic {
    duration = duration, large_displacement = true, contact_damping = 1e-4*s, record_every = duration / 50,
  },
}
history "block" { at = { size, size, thick }, record = { "displacement", "velocity" } }

local function worst(result, column, exact, scale, limit)
  local block, largest = result.history("block"), 0
  local seconds, values = block.values("seconds", "slide"), block.values(column, "slide")
  for i = 1, #seconds do largest = math.max(largest, math.abs(values[i] - exact(seconds[i])) / scale) end
  return largest < limit, string.format("off by %.2g, allowed %.2g", largest, limit)
end
if leans then
  local gives = density * thick * g * math.sin(slope) / stiffness
  expect "leans" { that = function(result)
    return worst(result, "displacement.x", function() return 0 end, gives, 2)
  end }
else
  expect "distance" {
    history = "block", component = "displacement.x", stage = "slide", value = distance, relative = 0.01,
  }
  expect "distance at every time" { that = function(result)
    return worst(result, "displacement.x", function(t) return acceleration * t * t / 2 end, distance, 0.01)
  end }
  expect "speed without stick and slip" { that = function(result)
    return worst(result, "velocity.x", function(t) return acceleration * t end, acceleration * duration, 0.01)
  end }
  expect "energy drift" { that = function(result)
    local drift = result.stage("slide").energy_drift
    return drift < 1e-3, string.format("%.2g of the peak", drift)
  end }
end
