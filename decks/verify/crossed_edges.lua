-- Case crossed edges: a beam falls with its lower edge across the upper edge of another one and bounces, between nodes
--         of the mesh, on a node of both, beside it, or passing it.
-- Source: closed form: without damping it rebounds to where it fell from, the contact conserves energy.
-- Accept: rebound 1 % of the height; the edge never sinks in by more than 1.5 times what speed, mass and stiffness
--         give; energy drifts by less than 1e-3 of its peak.
-- Runs: elements=hex8 | elements=wedge6 | cells=4 | cells=4 along=0.002 | cells=4 slides=0.4
local args = deck.args {
  elements = { default = "hex8", doc = "hex8 or wedge6" },
  cells = { default = 5, doc = "along a beam; of an even number two nodes meet" },
  along = { default = 0, doc = "how far from the middle of both the beams meet, m" },
  slides = { default = 0, doc = "acceleration along both beams, m/s2: they pass their nodes while pressed" },
}
local length, side, height, density, g, stiffness = 1, 0.1, 0.1, 2500, 9.81, 2e10
local mass, half = density * side ^ 2 * length, side * math.sqrt(0.5)
local speed, fall = math.sqrt(2 * g * height), math.sqrt(2 * height / g)
-- Eighths of the four faces at 45 degrees: of the two beside each edge, the edge presses on both sides with half.
local cells = args.cells
local k = stiffness * 2 * side * length / cells / 8 * math.sqrt(0.5)
local touch = math.pi * math.sqrt(mass / k)

local function bar(name, axis, at)  -- turned by 45 degrees about its axis, x or y
  local c = math.sqrt(0.5)
  local from, to, count = { -side / 2, -side / 2, -side / 2 }, { side / 2, side / 2, side / 2 }, { 1, 1, 1 }
  from[axis], to[axis], count[axis] = -length / 2, length / 2, cells
  local function across(x, y) return axis == 1 and y or x end
  box(name) {
    from = from, to = to, cells = count, elements = args.elements,
    x = function(x, y, z) return at[1] + (axis == 1 and x or c * x + c * z) end,
    y = function(x, y, z) return at[2] + (axis == 2 and y or c * y + c * z) end,
    z = function(x, y, z) return at[3] - c * across(x, y) + c * z end,
  }
end
model "crossed" {}
bar("lower", 1, { 0, 0, 0 })
local starts = args.along - args.slides * (fall + touch / 2) ^ 2 / 2  -- it is at `along` when it is deepest
bar("upper", 2, { starts, starts, 2 * half + height })
material "rock" { region = { "lower", "upper" }, density = density*kg/m^3, young = 500*GPa, poisson = 0.2 }
joint "contact" {
  between = { "lower", "upper" }, law = "frictional", friction = 0, normal_stiffness = stiffness*Pa/m,
  shear_stiffness = stiffness*Pa/m,
}
surface "held" { of = "lower" }
fix { surface = "held", x = 0, y = 0, z = 0 }
gravity { x = args.slides, y = args.slides, z = -g }
stage "bounce" {
  solve = dynamic { duration = 2 * fall + touch, large_displacement = true, record_every = touch / 20 },
}
history "centre" { at = { starts, starts, 2 * half + height }, record = { "displacement" } }

expect "rebound" {
  history = "centre", component = "displacement.z", stage = "bounce", value = 0, tolerance = 0.01 * height,
}
expect "depth" { that = function(result)
  local lowest, most = 0, 1.5 * speed * math.sqrt(mass / k)
  for _, z in ipairs(result.history("centre").values("displacement.z", "bounce")) do lowest = math.min(lowest, z) end
  local sank = -height - lowest
  return sank > 0 and sank < most, string.format("sank in %.3g m, allowed %.3g", sank, most)
end }
expect "energy drift" { that = function(result)
  local drift = result.stage("bounce").energy_drift
  return drift < 1e-3, string.format("%.2g of the peak", drift)
end }
