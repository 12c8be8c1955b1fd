-- Case P36: direct shear of a joint of 1 m^2 under 0.5 MN, cohesion 1 MPa, friction 40 degrees.
-- Source: closed form: peak c A + N tan(phi) = 1.41955 MN, then N tan(phi) = 0.41955 MN.
-- Accept: 1 % (the last step before the peak takes 99.9 % of it, the first one beyond 100.1 %).
-- Runs: elements=hex8 | elements=wedge6 | elements=tet4
local args = deck.args { elements = { default = "hex8", doc = "hex8, wedge6 or tet4" } }
local cohesion, friction, normal, stiffness = 1e6, 40*deg, 0.5e6, 1e10
local peak = cohesion + normal * math.tan(friction)

model "direct_shear" {}
box "lower" { from = { 0, 0, -0.5 }, to = { 1, 1, 0 }, cells = { 1, 1, 1 }, elements = args.elements }
box "upper" { from = { 0, 0, 0 }, to = { 1, 1, 0.5 }, cells = { 1, 1, 1 }, elements = args.elements }
material "rock" { region = { "lower", "upper" }, young = 30*GPa, poisson = 0, density = 2600*kg/m^3 }
joint "plane" {
  between = { "lower", "upper" }, law = "brittle", cohesion = cohesion*Pa, tensile_strength = 1*MPa, friction = friction,
  normal_stiffness = 1e11*Pa/m, shear_stiffness = stiffness*Pa/m,
}
-- Every node of a box lies on its left or right side: the boxes move without straining, the joint alone is sheared.
surface "below" { of = "lower", side = { "left", "right" } }
surface "above" { of = "upper", side = { "left", "right" } }
surface "load"  { of = "upper", side = "top" }
fix { surface = "below", x = 0, y = 0, z = 0 }
pressure { surface = "load", value = normal*Pa }
local function sheared(share) return displacement { surface = "above", x = share * peak / stiffness, y = 0 } end
stage "pressed"  { apply = { sheared(0) }, solve = static { tolerance = 1e-9 } }
stage "before"   { apply = { sheared(0.999) }, solve = static { tolerance = 1e-9 } }
stage "beyond"   { apply = { sheared(1.001) }, solve = static { tolerance = 1e-9 } }
stage "sliding"  { apply = { sheared(3) }, solve = static { tolerance = 1e-9 } }

history "above" { surface = "above", record = { "reaction" } }
expect "holds to the peak" {
  history = "above", component = "reaction.x", stage = "before", value = peak*N, relative = 0.0011,
}
expect "cracks beyond it" { that = function(result)
  local before, beyond = result.stage("before").cracks, result.stage("beyond").cracks
  return before == 0 and beyond > 0, string.format("%d events before the peak, %d beyond it", before, beyond)
end }
for _, name in ipairs { "beyond", "sliding" } do
  expect("residual, " .. name) {
    history = "above", component = "reaction.x", stage = name, value = (peak - cohesion)*N, relative = 1e-6,
  }
end
