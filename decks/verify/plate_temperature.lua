-- Case P12: a free plate of thickness 2c, warm in its middle: T = T0 (1 - z^2 / c^2). Its faces are pulled, its core pressed.
-- Source: closed form away from the edges, s_x = s_y = E alpha T0 / (1 - nu) (z^2 / c^2 - 1/3).
-- Accept: 3 % with 16 elements over the thickness.
-- Runs: elements=hex8 | elements=wedge6
-- (A tetrahedron has one stress, at its own centre: the six of a cell meet this only in their mean.)
-- By symmetry one eighth is modelled, 4 c x 4 c x c with 8 elements over c; planes of symmetry also hold it in place.
local args = deck.args { elements = { default = "hex8", doc = "hex8 or wedge6" } }
local c, warmest, young, poisson, expansion = 1, 20, 20*GPa, 0.2, 1e-5/K

model "plate" {}
box "plate" { from = { 0, 0, 0 }, to = { 4*c, 4*c, c }, cells = { 8, 8, 8 }, elements = args.elements }
material "concrete" {
  region = "plate", young = young, poisson = poisson, density = 2400*kg/m^3, expansion = expansion,
}
surface "symmetry" { of = "plate", side = { "left", "front", "bottom" } }
fix "symmetry" { surface = "symmetry", normal = true }
temperature_field { value = function(x, y, z) return warmest * (1 - z^2 / c^2) end }
stage "warm" { solve = static { tolerance = 1e-8 } }

-- 3 % of the stress; of the largest one where the stress changes its sign.
local scale = 20e9 * 1e-5 * warmest / (1 - poisson)
for layer = 0, 7 do
  local z = (layer + 0.5) / 8
  local exact = scale * (z^2 / c^2 - 1 / 3)
  local name = string.format("z = %.4f", z)
  history(name) { at = { 0.25, 0.25, z }, record = { "stress" } }
  for _, component in ipairs { "xx", "yy" } do
    expect(name .. " " .. component) {
      history = name, component = "stress." .. component, value = exact,
      tolerance = 0.03 * (layer == 4 and scale * 2 / 3 or math.abs(exact)),
    }
  end
end
