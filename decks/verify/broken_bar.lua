-- Case breakage: a bar pulled apart takes the fracture energy times its area, whatever the size and the shape of the blocks; one
--   layer near the middle is 4 % weaker, so that the crack goes there.
-- Source: definition of the fracture energy (Hillerborg, Modeer & Petersson 1976); strength on the way.
-- Accept: 3 %; peak force 2 %, as it falls between two of the increments.
-- Runs: size=0.2 | size=0.1 | size=0.05 | size=0.1 elements=wedge6 | size=0.1 elements=tet4 |
--   size=0.05 elements=tet4 | size=0.2 law=damage | size=0.1 law=damage elements=wedge6 | size=0.05 law=damage |
--   size=0.1 law=damage elements=tet4
local args = deck.args {
  size     = { default = 0.1, doc = "edge of the elements, m: 0.2, 0.1 or 0.05" },
  elements = { default = "hex8", doc = "hex8, wedge6 or tet4" },
  law      = { default = "breakage", doc = "breakage or damage" },
}
local length, width, energy = 0.6, 0.2, 100
local move = 0.083*mm  -- nearly what the crack opens to until it carries nothing
local across, layers = math.floor(width / args.size + 0.5), math.floor(length / args.size / 2)
local first, last = layers * args.size, (layers + 1) * args.size

model "broken_bar" {}
local regions = {}
local function piece(name, x0, x1, tensile)
  local cells = math.floor((x1 - x0) / args.size + 0.5)
  box(name) { from = { x0, 0, 0 }, to = { x1, width, width }, cells = { cells, across, across }, elements = args.elements }
  material(name) {
    region = name, law = args.law, density = 2400*kg/m^3, young = 30*GPa, poisson = 0.2,
    tensile_strength = tensile, fracture_energy = energy*J/m^2,
    cohesion = args.law == "breakage" and 5*MPa or nil, friction = args.law == "breakage" and 35*deg or nil,
  }
  regions[#regions + 1] = name
end
piece("one", 0, first, 2.5*MPa)
piece("middle", first, last, 2.4*MPa)
piece("two", last, length, 2.5*MPa)
surface "near" { of = regions, plane = { { 0, 0, 0 }, { 1, 0, 0 } } }
surface "far" { of = regions, plane = { { length, 0, 0 }, { 1, 0, 0 } } }
surface "under" { of = regions, plane = { { 0, 0, 0 }, { 0, 0, 1 } } }
surface "front" { of = regions, plane = { { 0, 0, 0 }, { 0, 1, 0 } } }
fix { surface = "near", x = 0 }
fix { surface = "under", z = 0 }
fix { surface = "front", y = 0 }
history "far" { surface = "far", record = { "reaction" } }
history "blocks" { record = { "dissipation" } }
stage "pull" {
  apply = { displacement { surface = "far", x = move } },
  solve = static { tolerance = 1e-5, increments = 60 },
}

local area = width * width
expect "energy released" {
  history = "blocks", component = "dissipation.fracture", value = energy * area, relative = 0.03,
}
expect "work of the pull" { that = function(result)
  local force = result.history("far").values("reaction.x", "pull")
  local work, before, peak = 0, 0, 0
  for _, f in ipairs(force) do
    work = work + 0.5 * (before + f) * 0.083e-3 / #force
    peak, before = math.max(peak, f), f
  end
  return math.abs(work / (energy * area) - 1) < 0.03 and math.abs(peak / (2.4e6 * area) - 1) < 0.02,
    string.format("%.4g J, wanted %.4g; peak %.4g N, strength %.4g N", work, energy * area, peak, 2.4e6 * area)
end }
