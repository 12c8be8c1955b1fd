-- Case breakage: a broken block pulled, pushed and pulled again: its crack closes with the full stiffness and opens on the secant.
-- Source: closed form of linear softening: at opening strain e the stress is T (e_u - e') / e_u, and in compression E e.
-- Accept: 0.1 %.
-- Runs: elements=hex8 | elements=wedge6 | elements=tet4
local args = deck.args { elements = { default = "hex8", doc = "hex8, wedge6 or tet4" } }

model "closing_crack" {}
box "block" { from = { 0, 0, 0 }, to = { 0.2, 0.2, 0.2 }, cells = { 1, 1, 1 }, elements = args.elements }
material "block" {
  region = "block", law = "breakage", density = 2400*kg/m^3, young = 30*GPa, poisson = 0.2,
  tensile_strength = 2.5*MPa, fracture_energy = 100*J/m^2, cohesion = 5*MPa, friction = 35*deg,
}
fix { surface = "block.left", x = 0 }
fix { surface = "block.front", y = 0 }
fix { surface = "block.bottom", z = 0 }
history "block" { at = { 0.1, 0.1, 0.1 }, record = { "stress", "damage" } }

-- Pulled to a strain of 2e-4: T = E e0; stress and strain lie on the line from (e0, T) to (2 G / (T h), 0).
local young, tensile, ending = 30e9, 2.5e6, 2 * 100 / (2.5e6 * 0.2)
local strain = 2e-4
local left = tensile * (ending - strain) / (ending - tensile / young)
local function move(name, e)
  stage(name) {
    apply = { displacement { surface = "block.top", z = e * 0.2 } },
    solve = static { tolerance = 1e-8, increments = 10 },
  }
end
move("pull", strain)
move("ease", strain / 2)
move("push", -strain)
move("again", strain)
expect "softened" { history = "block", component = "stress.zz", stage = "pull", value = left*Pa, relative = 1e-3 }
expect "on the secant" { history = "block", component = "stress.zz", stage = "ease", value = left / 2*Pa, relative = 1e-3 }
expect "full stiffness" {
  history = "block", component = "stress.zz", stage = "push", value = -young * strain*Pa, relative = 1e-3,
}
expect "open again" { history = "block", component = "stress.zz", stage = "again", value = left*Pa, relative = 1e-3 }
