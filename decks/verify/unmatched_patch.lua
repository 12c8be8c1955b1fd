-- Case patch of contacts: two layers of different elements and divisions, tied by an elastic joint, under a uniform stress
--   across the joint, along it, and in shear over it.
-- Source: exact: a uniform stress passes from any mesh to any other, and springs open by stress / stiffness.
-- Accept: 1e-6 of the stress with triangles and parallelograms, 1e-3 with general quads; the forces on the two sides of the
--   joint balance to 1e-10.
-- Runs: lower=hex8 upper=tet4 | lower=tet4 upper=wedge6 | lower=wedge6 upper=hex8 | lower=hex8 upper=hex8 |
--       lower=hex8 upper=hex8 bend=0.05
local args = deck.args {
  lower = { default = "hex8", doc = "elements of the lower layer, 3 x 3 x 2" },
  upper = { default = "tet4", doc = "elements of the upper layer, 4 x 5 x 3" },
  bend = { default = 0, doc = "how far nodes inside move along x, m: faces in the joint become general quads" },
}
local accepted = args.bend > 0 and 1e-3 or 1e-6
local size, stiffness, young, poisson = 1e6, 1e12, 30e9, 0.2

local function bent(by)
  if args.bend == 0 then return nil end
  return function(x, y, z) return x + by * args.bend * math.sin(math.pi * x) * math.sin(math.pi * y) end
end

model "unmatched_patch" {}
box "lower" { from = { 0, 0, 0 }, to = { 1, 1, 0.5 }, cells = { 3, 3, 2 }, elements = args.lower, x = bent(1) }
box "upper" { from = { 0, 0, 0.5 }, to = { 1, 1, 1.2 }, cells = { 4, 5, 3 }, elements = args.upper, x = bent(-1) }
material "concrete" { region = { "lower", "upper" }, young = young*Pa, poisson = poisson, density = 2400*kg/m^3 }
joint "plane" {
  between = { "lower", "upper" }, law = "elastic", normal_stiffness = stiffness*Pa/m, shear_stiffness = stiffness*Pa/m,
}
local outside = {
  lower = { "lower.left", "lower.right", "lower.front", "lower.back", "lower.bottom" },
  upper = { "upper.left", "upper.right", "upper.front", "upper.back", "upper.top" },
}

local stages = {
  { name = "across", xx = 0, yy = 0, zz = size, zx = 0 },
  { name = "along", xx = size, yy = -size / 2, zz = 0, zx = 0 },
  { name = "over", xx = 0, yy = 0, zz = 0, zx = size / 2 },
}
for _, s in ipairs(stages) do
  local trace = s.xx + s.yy + s.zz
  local function strain(normal) return ((1 + poisson) * normal - poisson * trace) / young end
  local exx, eyy, ezz, gzx = strain(s.xx), strain(s.yy), strain(s.zz), 2 * (1 + poisson) * s.zx / young
  local apply = {}
  for layer, jump in pairs { lower = 0, upper = 1 / stiffness } do
    apply[#apply + 1] = displacement {
      surface = outside[layer],
      x = function(x, y, z) return exx * x + gzx * z + jump * s.zx end,
      y = function(x, y, z) return eyy * y end,
      z = function(x, y, z) return ezz * z + jump * s.zz end,
    }
  end
  stage(s.name) { apply = apply, solve = static { tolerance = 1e-12 } }
end

for number, place in ipairs { { 0.3, 0.3, 0.45 }, { 0.3, 0.3, 0.55 }, { 0.9, 0.1, 0.3 }, { 0.6, 0.95, 0.6 }, { 0.5, 0.5, 1.1 } } do
  local name = "stress " .. number
  history(name) { at = place, record = { "stress" } }
  for _, s in ipairs(stages) do
    for _, component in ipairs { "xx", "yy", "zz", "zx" } do
      expect(name .. " " .. s.name .. " " .. component) {
        history = name, component = "stress." .. component, stage = s.name, value = s[component]*Pa, tolerance = accepted * size * Pa,
      }
    end
  end
end

-- What holds each layer from outside is what the other one feels through the joint.
for layer in pairs(outside) do
  surface(layer .. " outside") { of = layer }
  history(layer) { surface = layer .. " outside", record = { "reaction" } }
end
expect "balance" { that = function(result)
  local worst = 0
  for _, s in ipairs(stages) do
    local function forces(layer, axis) return result.history(layer).at("reaction." .. axis, s.name) end
    for _, axis in ipairs { "x", "y", "z" } do
      worst = math.max(worst, math.abs(forces("lower", axis) + forces("upper", axis)) / size)
    end
  end
  return worst < 1e-10, string.format("off by %.1e of a face's force", worst)
end }
