-- Case undamped bounces: two cubes on each other are dropped on a corner of the lower one and bounce, tumble and
--         clatter without friction and damping, or with friction alone.
-- Source: energy: what gravity brings is in their motion, but for friction and what ends while it is pressed.
-- Accept: energy drifts by less than 1e-3 of its peak over its many touches; nothing is taken out that brings.
-- Runs: friction=0 | friction=30 | friction=30 elements=tet4
local args = deck.args {
  friction = { default = 0, doc = "degrees" },
  elements = { default = "hex8", doc = "hex8, wedge6 or tet4" },
}
local side, density, g = 0.2, 2500, 9.81
local cy, sy, cx, sx = math.cos(30*deg), math.sin(30*deg), math.cos(25*deg), math.sin(25*deg)
local names = { "ground", "lower", "upper" }
model "bounces" {}
box "ground" { from = { -2, -2, -0.1 }, to = { 2, 2, 0 }, cells = { 4, 4, 1 }, elements = args.elements }
for i, name in ipairs { "lower", "upper" } do
  box(name) {
    from = { -side / 2, -side / 2, (i - 1.5) * side }, to = { side / 2, side / 2, (i - 0.5) * side },
    cells = { 1, 1, 1 }, elements = args.elements,
    x = function(x, y, z) return cy * x + sy * z end,
    y = function(x, y, z) return cx * y - sx * (-sy * x + cy * z) end,
    z = function(x, y, z) return 0.35 + sx * y + cx * (-sy * x + cy * z) end,
  }
end
material "rock" { region = names, density = density*kg/m^3, young = 5*GPa, poisson = 0.2 }
for i, pair in ipairs { { 1, 2 }, { 2, 3 }, { 1, 3 } } do
  joint("contact " .. i) {
    between = { names[pair[1]], names[pair[2]] }, law = "frictional", friction = args.friction*deg,
    normal_stiffness = 2e9*Pa/m, shear_stiffness = 2e9*Pa/m,
  }
end
surface "held" { of = "ground" }
fix { surface = "held", x = 0, y = 0, z = 0 }
gravity { z = -g }
stage "bounce" { solve = dynamic { duration = 1.5*s, large_displacement = true, record_every = 0.01*s } }
history "all" { record = { "energy" } }

expect "energy drift" { that = function(result)
  local drift = result.stage("bounce").energy_drift
  return drift < 1e-3, string.format("%.2g of the peak", drift)
end }
expect "nothing brings energy" { that = function(result)
  local lost, most, back = result.history("all").values("energy.dissipated", "bounce"), 0, 0
  for _, value in ipairs(lost) do most, back = math.max(most, value), math.max(back, most - value) end
  return back < 1e-4 * most, string.format("%.2g J of %.3g J came back", back, most)
end }
