-- Case lies across: a plank comes to rest across another one, face on face; no node of either lies on the other.
-- Source: closed form: weight over the stiffness of the four places where edges cross, each with an eighth of a face.
-- Accept: depth 1 %; energy drifts by less than 1e-3 of its peak.
-- Runs: turned=90 | turned=50
local args = deck.args { turned = { default = 90, doc = "degrees between the planks" } }
local length, side, density, g, stiffness = 1, 0.1, 2500, 9.81, 1e9
local weight, c, sine = density * side ^ 2 * length * g, math.cos(args.turned * deg), math.sin(args.turned * deg)
model "planks" {}
box "lower" { from = { -length / 2, -side / 2, -side }, to = { length / 2, side / 2, 0 }, cells = { 1, 1, 1 } }
box "upper" {
  from = { -length / 2, -side / 2, 0 }, to = { length / 2, side / 2, side }, cells = { 1, 1, 1 },
  x = function(x, y, z) return c * x - sine * y end, y = function(x, y, z) return sine * x + c * y end,
}
material "rock" { region = { "lower", "upper" }, density = density*kg/m^3, young = 500*GPa, poisson = 0 }
joint "contact" {
  between = { "lower", "upper" }, law = "frictional", friction = 30*deg, normal_stiffness = stiffness*Pa/m,
  shear_stiffness = stiffness*Pa/m,
}
surface "held" { of = "lower" }
fix { surface = "held", x = 0, y = 0, z = 0 }
gravity { z = -g }
stage "rest" { solve = dynamic { duration = 0.5*s, large_displacement = true, contact_damping = 1e-4*s } }
history "centre" { at = { 0, 0, side / 2 }, record = { "displacement" } }

expect "depth" {
  history = "centre", component = "displacement.z", stage = "rest",
  value = -weight / (4 * stiffness * length * side / 8), relative = 0.01,
}
expect "energy drift" { that = function(result)
  local drift = result.stage("rest").energy_drift
  return drift < 1e-3, string.format("%.2g of the peak", drift)
end }
