-- Case P12: a free plate of thickness 2c, warm in its middle: T = T0 (1 - z^2 / c^2). Its faces are pulled, its core pressed.
-- Source: closed form away from the edges, s_x = s_y = E alpha T0 / (1 - nu) (z^2 / c^2 - 1/3).
-- Accept: 3 % with 16 elements over the thickness, at the nodes; of hex8 and wedge6 also in the elements and on the face.
--         A tetrahedron has one stress, and the six of a cell share its load unevenly: theirs is compared at inner nodes,
--         where stress is the mean of all around.
-- Runs: elements=hex8 | elements=wedge6 | elements=tet4
-- By symmetry one eighth is modelled, 4 c x 4 c x c with 8 elements over c; planes of symmetry also hold it in place.
local args = deck.args { elements = { default = "hex8", doc = "hex8, wedge6 or tet4" } }
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

local scale = 20e9 * 1e-5 * warmest / (1 - poisson)
local function compare(name, place, field)
  local exact = scale * (place[3]^2 / c^2 - 1 / 3)
  -- 3 % of the stress; of the largest one where the stress changes its sign.
  local reach = 0.03 * (math.abs(exact) > 0.1 * scale and math.abs(exact) or scale * 2 / 3)
  history(name) { at = place, record = { field } }
  for _, component in ipairs { "xx", "yy" } do
    expect(name .. " " .. component) { history = name, component = field .. "." .. component, value = exact, tolerance = reach }
  end
end
local whole = args.elements ~= "tet4"
for layer = whole and 0 or 1, whole and 8 or 7 do
  compare(string.format("node z = %.4f", layer / 8), { 0.5, 0.5, layer / 8 * c }, "nodal_stress")
end
if whole then
  for layer = 0, 7 do
    compare(string.format("element z = %.4f", (layer + 0.5) / 8), { 0.25, 0.25, (layer + 0.5) / 8 * c }, "stress")
  end
end
