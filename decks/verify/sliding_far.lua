-- Case P34: a block slides ten times its length down a slope, over the edges between the slope's elements.
-- Source: closed form: s = g (sin(slope) - cos(slope) tan(friction)) t^2 / 2.
-- Accept: distance and speed 1 % of what they are at the end, at every record; energy drifts by less than 1e-3 of its
--         peak.
-- Runs: elements=hex8 | elements=wedge6 | elements=tet4
local args = deck.args { elements = { default = "hex8", doc = "hex8, wedge6 or tet4" } }
local size, thick, g, slope, friction = 0.1, 0.02, 9.81, 35*deg, 30*deg
local distance = 10 * size
local acceleration = g * (math.sin(slope) - math.cos(slope) * math.tan(friction))
local duration = math.sqrt(2 * distance / acceleration)

model "slope" {}
box "slope" { from = { -0.03, -0.07, -0.1 }, to = { 1.25, 0.19, 0 }, cells = { 11, 3, 1 }, elements = args.elements }
box "block" { from = { 0, 0, 0 }, to = { size, size, thick }, cells = { 2, 2, 1 }, elements = args.elements }
material "rock" { region = { "slope", "block" }, density = 2500*kg/m^3, young = 1*GPa, poisson = 0.2 }
joint "contact" {
  between = { "slope", "block" }, law = "frictional", friction = friction, normal_stiffness = 1e9*Pa/m,
  shear_stiffness = 1e9*Pa/m,
}
fix { surface = "slope.bottom", x = 0, y = 0, z = 0 }
gravity { x = g * math.sin(slope), z = -g * math.cos(slope) }
stage "slide" {
  solve = dynamic { duration = duration, large_displacement = true, contact_damping = 1e-4*s, record_every = duration / 50 },
}
history "block" { at = { size, size, thick }, record = { "displacement", "velocity" } }
history "all" { record = { "energy" } }

expect "distance" {
  history = "block", component = "displacement.x", stage = "slide", value = distance, relative = 0.01,
}
local function worst(result, column, exact, scale)
  local block, largest = result.history("block"), 0
  local seconds, values = block.values("seconds", "slide"), block.values(column, "slide")
  for i = 1, #seconds do largest = math.max(largest, math.abs(values[i] - exact(seconds[i])) / scale) end
  return largest < 0.01, string.format("off by %.2g of the largest", largest)
end
expect "distance at every time" { that = function(result)
  return worst(result, "displacement.x", function(t) return acceleration * t * t / 2 end, distance)
end }
expect "speed without stick and slip" { that = function(result)
  return worst(result, "velocity.x", function(t) return acceleration * t end, acceleration * duration)
end }
expect "energy drift" { that = function(result)
  local drift = result.stage("slide").energy_drift
  return drift < 1e-3, string.format("%.2g of the peak", drift)
end }
