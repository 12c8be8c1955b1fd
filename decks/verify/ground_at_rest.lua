-- Case ground at rest: layers of ground, and blocks of rock along a joint, with their initial stress under gravity.
-- Source: equilibrium. Nothing moves; vertical stress is the weight above, sideways k0 times that.
-- Accept: displacement 1e-9 of the settlement without initial stress; stress 1e-9 of the largest.
-- Runs: elements=hex8 | elements=wedge6 | elements=tet4 | law=drucker_prager | ground=joint | ground=joint elements=tet4 | ground=crackable | ground=crackable elements=wedge6 | ground=frictional | solve=dynamic ground=joint
local args = deck.args {
  elements = { default = "hex8", doc = "hex8, wedge6 or tet4" },
  law = { default = "elastic", doc = "of the ground: elastic or drucker_prager" },
  ground = { default = "layers", doc = "layers, joint, frictional (joint) or crackable" },
  solve = { default = "static", doc = "static or dynamic" },
}
local layers = args.ground == "layers"
-- top, bottom, density, k0; stress on the top of the model: 50 kPa of fill
local grounds = layers and { { 0, -3, 1800, 0.8 }, { -3, -7, 2000, 0.5 }, { -7, -12, 2400, 1.2 } }
                       or { { 0, -12, 2600, 0.7 }, { 0, -12, 2600, 0.7 } }
local fill, g = 50*kPa, 9.81

model "ground_at_rest" {}
for i, ground in ipairs(grounds) do
  local name, top, bottom = "ground " .. i, ground[1], ground[2]
  local left, right = { { 0, bottom }, { 0, top } }, { { 10, top }, { 10, bottom } }
  if not layers then   -- two halves on both sides of a joint at 56 degrees
    local joint = { { 8, top }, { 2, bottom } }
    if i == 1 then right = joint else left = { joint[2], joint[1] } end
  end
  extrude(name) {
    section = { left[1], right[2], right[1], left[2] }, length = 4*m, size = 1*m, elements = args.elements,
  }
  material(name) {
    region = name, law = args.law, density = ground[3], young = 50*MPa, poisson = 0.3,
    cohesion = args.law == "drucker_prager" and 2*MPa or nil, friction = args.law == "drucker_prager" and 30*deg or nil,
  }
end
local above = -fill
for i, ground in ipairs(grounds) do
  initial_stress("ground " .. i) { region = "ground " .. i, level = ground[1], vertical = above, k0 = ground[4] }
  if layers then above = above - ground[3] * g * (ground[1] - ground[2]) * Pa end
end
if args.ground == "crackable" then
  crackable "rock" { region = { "ground 1", "ground 2" }, law = "brittle", tensile_strength = 1*MPa, cohesion = 3*MPa, friction = 30*deg }
elseif args.ground == "frictional" then
  joint "fault" { between = { "ground 1", "ground 2" }, law = "frictional", friction = 35*deg }
elseif not layers then
  joint "fault" { between = { "ground 1", "ground 2" }, law = "brittle", tensile_strength = 0.1*MPa, cohesion = 1*MPa, friction = 35*deg }
end
local all = layers and { "ground 1", "ground 2", "ground 3" } or { "ground 1", "ground 2" }
surface "sides"  { of = all, side = { "left", "right", "front", "back" } }
surface "bottom" { of = all, side = "bottom" }
surface "top"    { of = all, side = "top" }
fix { surface = "sides", normal = true }
fix { surface = "bottom", x = 0, y = 0, z = 0 }
gravity { z = -g }
pressure { surface = "top", value = fill }
stage "rest" { solve = args.solve == "dynamic" and dynamic { duration = 0.2*s } or static { tolerance = 1e-8 } }

local settlement = 2600 * g * 12^2 / 2 / 50e6*m
history "top"    { at = { 5*m, 2*m, 0 }, record = { "displacement" } }
history "middle" { at = { 6.1*m, 1.5*m, -4.5*m }, record = { "displacement", "stress", "nodal_stress" } }
for _, place in ipairs { "top", "middle" } do
  for _, axis in ipairs { "x", "y", "z" } do
    expect(place .. " stays along " .. axis) {
      history = place, component = "displacement." .. axis, value = 0*m, tolerance = 1e-9 * settlement,
    }
  end
end
local start = layers and -50e3 - 1800 * g * 3 - 2000 * g * 1.5 or -50e3 - 2600 * g * 4.5
if args.elements ~= "tet4" then  -- linear in each element, so exact at the nodes
  expect "stress from the nodes" {
    history = "middle", component = "nodal_stress.zz", value = start, tolerance = 1e-9 * 350e3,
  }
end
expect "stress" { that = function(result)
  local here = result.history("middle")
  local function stress(name) return here.at("stress." .. name, "rest") end
  local k0, density = layers and 0.5 or 0.7, layers and 2000 or 2600
  -- The mean of the element: within one element of the place; hexahedra of the layers have their centre there.
  local reach = (layers and args.elements == "hex8") and 0 or density * g * 0.8
  local worst = math.max(math.abs(stress "xx" - k0 * stress "zz"), math.abs(stress "yy" - k0 * stress "zz"),
                         math.abs(stress "xy"), math.abs(stress "yz"), math.abs(stress "zx"),
                         math.abs(stress "zz" - start) - reach)
  return worst < 1e-9 * 350e3, string.format("off by %.2g Pa at %.4g Pa", worst, start)
end }
