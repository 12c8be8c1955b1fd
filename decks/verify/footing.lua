-- Case P31: a rigid smooth strip footing of half width 1 on clay without friction, 6 x 4 of it, plane strain.
-- Source: Prandtl 1921: 5.1416 times the cohesion. CalculiX 2.20, C3D8I, elements of 0.25: plateau at 5.52 for a half
--   width of 1 and 4.91 for 1.125, the last node that goes down and the middle of the gap beside it.
-- Accept: -5 % to +12 % on a plateau. With formulation=full hex8 goes on rising and tet4 ends at 6.55.
-- Runs: elements=hex8 | elements=wedge6 | elements=tet4
local args = deck.args {
  formulation = { default = "", doc = "full to see it lock; the program's choice unless given" },
  elements    = { default = "hex8", doc = "hex8, wedge6 or tet4" },
  size        = { default = 0.25, doc = "edge of the elements" },
}
local cohesion, size = 100e3, args.size

model "footing" {}
box "clay" { from = { 0, 0, 0 }, to = { 6, size, 4 }, size = size, elements = args.elements }
material "clay" {
  region = "clay", law = "von_mises", density = 2000*kg/m^3, young = 100*MPa, poisson = 0.3,
  yield_stress = math.sqrt(3) * cohesion*Pa, formulation = args.formulation ~= "" and args.formulation or nil,
}
surface "footing" { of = "clay", side = "top", box = { { -1, -1, 3.9 }, { 1, 1, 4.1 } } }
fix "sides" { surface = { "clay.left", "clay.right", "clay.front", "clay.back" }, normal = true }
fix "base" { surface = "clay.bottom", x = 0, y = 0, z = 0 }
displacement "push" { surface = "footing", z = -0.06*m }
stage "push" { solve = static { increments = 60, tolerance = 1e-5 } }
history "footing" { surface = "footing", record = { "reaction" } }

local function pressures(result)
  local p = result.history("footing").values("reaction.z", "push")
  for i, force in ipairs(p) do p[i] = -force / size / cohesion end
  return p
end
expect "bearing pressure" { that = function(result)
  local p = pressures(result)
  return p[#p] > 0.95 * 5.1416 and p[#p] < 1.12 * 5.1416, string.format("%.4g c, Prandtl 5.142 c", p[#p])
end }
expect "a plateau" { that = function(result)
  local p = pressures(result)
  local rise = p[#p] / p[#p - 12] - 1
  return math.abs(rise) < 0.005, string.format("rises by %.2g %% over the last fifth of the way", 100 * rise)
end }
