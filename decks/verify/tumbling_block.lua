-- Case tumbling block: a cube is dropped on an edge or a corner, or on the corner of another one that stands on the
--         ground, tumbles and comes to rest.
-- Source: closed form, statics: at rest the ground bears the weight; on one of its faces a cube's centre is half its
--         side high.
-- Accept: weight 1e-3, centre 1 % of the side; energy drifts by less than 1e-3 of its peak.
-- Runs: start=edge | start=corner | start=corner elements=tet4 | start=spike
local args = deck.args {
  start = { default = "corner", doc = "edge, corner or spike" },
  elements = { default = "hex8", doc = "hex8, wedge6 or tet4" },
}
local side, density, g = 0.2, 2500, 9.81
local mass = density * side ^ 3

-- A cube about the origin, turned about y, then about x, and moved.
local function turned(about_y, about_x, at)
  local cy, sy, cx, sx = math.cos(about_y), math.sin(about_y), math.cos(about_x), math.sin(about_x)
  return function(x, y, z) return at[1] + cy * x + sy * z end,
         function(x, y, z) return at[2] + cx * y - sx * (-sy * x + cy * z) end,
         function(x, y, z) return at[3] + sx * y + cx * (-sy * x + cy * z) end
end
local function cube(name, half, cells, about_y, about_x, at)
  local x, y, z = turned(about_y, about_x, at)
  box(name) {
    from = { -half, -half, -half }, to = { half, half, half }, cells = { cells, cells, cells }, x = x, y = y, z = z,
    elements = args.elements,
  }
end
model "tumble" {}
box "ground" { from = { -1, -1, -0.1 }, to = { 1, 1, 0 }, cells = { 2, 2, 1 } }
local centre = { 0.1, 0.05, args.start == "spike" and 0.45 or 0.25 }
if args.start == "edge" then cube("block", side / 2, 2, 30*deg, 0, centre)
elseif args.start == "corner" then cube("block", side / 2, 2, 30*deg, 25*deg, centre)
else
  cube("block", side / 2, 2, 0, 0, centre)
  cube("spike", side / 4, 1, 45*deg, 35*deg, { 0.13, 0.08, 0.05 })
end
local others = args.start == "spike" and { "ground", "spike" } or { "ground" }
local all = args.start == "spike" and { "block", "ground", "spike" } or { "block", "ground" }
material "rock" { region = all, density = density*kg/m^3, young = 5*GPa, poisson = 0.2 }
for _, other in ipairs(others) do
  joint(other) {
    between = { other, "block" }, law = "frictional", friction = 25*deg, normal_stiffness = 5e9*Pa/m,
    shear_stiffness = 5e9*Pa/m,
  }
end
surface "held" { of = others }
fix { surface = "held", x = 0, y = 0, z = 0 }
gravity { z = -g }
stage "fall" {
  solve = dynamic { duration = 1.5*s, large_displacement = true, contact_damping = 1e-4*s, record_every = 0.01*s },
}
stage "rest" {
  solve = dynamic { duration = 1.5*s, large_displacement = true, contact_damping = 1e-4*s, mass_damping = 2/s },
}
history "centre" { at = centre, record = { "displacement", "velocity" } }
history "ground" { surface = "held", record = { "reaction" } }

expect "centre" {
  history = "centre", component = "displacement.z", stage = "rest", value = side / 2 - centre[3],
  tolerance = side / 100,
}
local held = density * (2 * 2 * 0.1 + (args.start == "spike" and (side / 2) ^ 3 or 0)) * g
expect "weight" {
  history = "ground", component = "reaction.z", stage = "rest", value = held + mass * g, tolerance = 1e-3 * mass * g,
}
expect "energy drift" { that = function(result)
  local drift = result.stage("fall").energy_drift
  return drift < 1e-3, string.format("%.2g of the peak", drift)
end }
