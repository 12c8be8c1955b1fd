-- Case Poisson 0.4999: an elastic thick cylinder (radii 1 and 2) under pressure from inside, plane strain, whose volume hardly
--   changes.
-- Source: closed form (Lame): u(r) = p a^2 (1 + nu) / (E (b^2 - a^2)) ((1 - 2 nu) r + b^2 / r); hoop stress at b: 2 p a^2 / (b^2 - a^2).
-- Accept: widening 1 % with 12 hex8 across the wall, 2 % with tet4 (formulation=full: 64 % and 33 % too small);
--   mean stress of the elements, the same everywhere, 10 % of the pressure.
-- Runs: elements=hex8 | elements=tet4
-- One layer of wedge6 is plane triangles, whose own mean is no remedy here.
local args = deck.args {
  n           = { default = 12, doc = "elements across the wall and along the quarter" },
  elements    = { default = "hex8", doc = "hex8 or tet4" },
  formulation = { default = "bbar", doc = "bbar, or full to see it lock" },
}
local a, b, thick, young, poisson, p = 1, 2, 0.25, 1e9, 0.4999, 1e6
local n, accepted = math.tointeger(args.n), args.elements == "tet4" and 0.02 or 0.01

model "incompressible_ring" {}
local section = {}
for i = 0, n do
  local angle = math.pi / 2 * i / n
  section[#section + 1] = { b * math.cos(angle), b * math.sin(angle) }
end
for i = n, 0, -1 do
  local angle = math.pi / 2 * i / n
  section[#section + 1] = { a * math.cos(angle), a * math.sin(angle) }
end
section[n + 1][1], section[n + 2][1] = 0, 0  -- cos of a right angle is not quite 0
extrude "wall" {
  section = section, length = thick, layers = 1, size = b - a, elements = args.elements,
  corners = { 1, n + 1, n + 2, 2 * n + 2 },
  divisions = { [1] = n, [2] = n, [3] = n, [4] = n },
}
material "rubber" {
  region = "wall", density = 1000*kg/m^3, young = young*Pa, poisson = poisson, formulation = args.formulation,
}
surface "left"   { of = "wall", plane = { { 0, 0, 0 }, { 1, 0, 0 } } }
surface "bottom" { of = "wall", plane = { { 0, 0, 0 }, { 0, 0, 1 } } }
surface "slice"  { of = "wall", side = { "front", "back" } }
surface "bore"   { of = "wall", facing = { -1, 0, -1 }, within = 50*deg, box = { { 0, 0, 0 }, { 1, 1, 1 } } }
fix { surface = { "left", "bottom", "slice" }, normal = true }
pressure { surface = "bore", value = p*Pa }
stage "press" { solve = static { tolerance = 1e-6 } }

local function widening(r)
  return p * a^2 * (1 + poisson) / (young * (b^2 - a^2)) * ((1 - 2 * poisson) * r + b^2 / r)
end
for name, r in pairs { inside = a, outside = b } do
  history(name) { at = { r, 0, 0 }, record = { "displacement" } }
  expect(name) { history = name, component = "displacement.x", value = widening(r)*m, relative = accepted }
end

-- Mean stress is p a^2 / (b^2 - a^2) 2 (1 + nu) / 3 everywhere. Elements that differ from their neighbours show.
local points = {}
for i = 1, 8 do
  for k = 1, 5 do
    local r, angle = a + (b - a) * i / 9, math.pi / 2 * k / 6
    points[#points + 1] = string.format("point %d %d", i, k)
    history(points[#points]) { at = { r * math.cos(angle), thick / 2, r * math.sin(angle) }, record = { "stress" } }
  end
end
expect "mean stress" { that = function(result)
  local wanted, worst = p * a^2 / (b^2 - a^2) * 2 * (1 + poisson) / 3, 0
  for _, point in ipairs(points) do
    local h = result.history(point)
    local mean = (h.at("stress.xx") + h.at("stress.yy") + h.at("stress.zz")) / 3
    worst = math.max(worst, math.abs(mean - wanted))
  end
  return worst < 0.1 * p, string.format("off by at most %.3g of the pressure inside", worst / p)
end }
