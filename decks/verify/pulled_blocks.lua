-- Case P35 with the brittle law: two cubes of 0.1 m pulled apart, tensile strength 2 MPa, springs of 1e12 Pa/m.
-- Source: closed form: the force rises to f_t A = 20 kN at an opening of f_t / k_n = 2 um and is gone beyond it.
-- Accept: 1 % (the last step before the peak takes 99.9 % of it, the first one beyond 100.1 %).
-- Runs: elements=hex8 | elements=wedge6 | elements=tet4
local args = deck.args { elements = { default = "hex8", doc = "hex8, wedge6 or tet4" } }
local side, strength, stiffness = 0.1, 2e6, 1e12

model "pulled_blocks" {}
box "lower" { from = { 0, 0, -side }, to = { side, side, 0 }, cells = { 1, 1, 1 }, elements = args.elements }
box "upper" { from = { 0, 0, 0 }, to = { side, side, side }, cells = { 1, 1, 1 }, elements = args.elements }
material "concrete" { region = { "lower", "upper" }, young = 30*GPa, poisson = 0.2, density = 2400*kg/m^3 }
joint "plane" {
  between = { "lower", "upper" }, law = "brittle", tensile_strength = strength*Pa, cohesion = 3*MPa, friction = 45*deg,
  normal_stiffness = stiffness*Pa/m, shear_stiffness = stiffness*Pa/m,
}
-- Every node of a cube lies on its left or right side: the cubes move without straining, the joint alone opens.
surface "below" { of = "lower", side = { "left", "right" } }
surface "above" { of = "upper", side = { "left", "right" } }
fix { surface = "below", x = 0, y = 0, z = 0 }
local function opened(share) return displacement { surface = "above", x = 0, y = 0, z = share * strength / stiffness } end
stage "half"    { apply = { opened(0.5) }, solve = static { tolerance = 1e-9 } }
stage "before"  { apply = { opened(0.999) }, solve = static { tolerance = 1e-9 } }
stage "beyond"  { apply = { opened(1.001) }, solve = static { tolerance = 1e-9 } }
stage "closed"  { apply = { opened(-1) }, solve = static { tolerance = 1e-9 } }

history "above" { surface = "above", record = { "reaction" } }
local peak = strength * side^2
for name, force in pairs { half = peak / 2, before = 0.999 * peak, closed = -peak } do
  expect(name) { history = "above", component = "reaction.z", stage = name, value = force*N, relative = 1e-6 }
end
expect "nothing left" { history = "above", component = "reaction.z", stage = "beyond", value = 0*N, tolerance = 1e-6*N }
expect "cracks at its strength" { that = function(result)
  local before, beyond = result.stage("before").cracks, result.stage("beyond").cracks
  return before == 0 and beyond > 0, string.format("%d events before the peak, %d beyond it", before, beyond)
end }
