-- Case P33 (far): a stack of blocks settles under its weight, in large displacement; contacts on both sides at the same
--         nodes.
-- Source: closed form, sum over i of (n - i) w / k_n + ((n - i - 1) w + w / 2) h / E with w = rho g h.
-- Accept: 1e-4.
-- Runs: elements=hex8 | elements=wedge6
local args = deck.args { elements = { default = "hex8", doc = "hex8 or wedge6" } }
local n, h, young, density, g, stiffness = 4, 0.5, 10e9, 2400, 9.81, 1e9

model "stack" {}
local joined = { "ground" }
box "ground" { from = { 0, 0, -h }, to = { 1, 1, 0 }, cells = { 1, 1, 1 }, elements = args.elements }
for i = 1, n do
  local name = "block" .. i
  box(name) { from = { 0, 0, (i - 1) * h }, to = { 1, 1, i * h }, cells = { 1, 1, 1 }, elements = args.elements }
  joint(name) {
    between = { joined[i], name }, law = "frictional", friction = 30*deg, normal_stiffness = stiffness*Pa/m,
    shear_stiffness = stiffness*Pa/m,
  }
  joined[i + 1] = name
end
material "rock" { region = joined, density = density*kg/m^3, young = young, poisson = 0 }
surface "held" { of = "ground" }
fix { surface = "held", x = 0, y = 0, z = 0 }
gravity { z = -g }
stage "settle" { solve = dynamic { duration = 0.5*s, large_displacement = true, mass_damping = 100/s } }
history "top" { at = { 0.3, 0.2, n * h }, record = { "displacement" } }

local weight, settles = density * g * h, 0
for i = 0, n - 1 do
  settles = settles + (n - i) * weight / stiffness + ((n - i - 1) * weight + weight / 2) * h / young
end
expect "settlement of the top" {
  history = "top", component = "displacement.z", stage = "settle", value = -settles, relative = 1e-4,
}
