-- Case P38: a notched beam bent at three points (Petersson 1981): span 2 m, depth 0.2 m, width 0.05 m, notch of half the
--   depth, E 30 GPa, nu 0.2, tensile strength 3.33 MPa, fracture energy 124 J/m^2, which cracks in its middle plane only.
-- Source: exact solution of the same discrete beam, an independent numpy program: 851.3 N with 20 elements over the depth
--   and 848.0 N with 40, springs of 1e13 Pa/m.
-- Accept: 2 % on the same mesh; 5 % between 10, 20 and 40 elements.
-- Runs: n=20 | n=10 | n=40
local args = deck.args { n = { default = 20, doc = "elements over the depth: 10, 20 or 40; all are square" } }
local span, depth, width, notch = 2, 0.2, 0.05, 0.1
local half, n = args.n * span / depth / 2, args.n
local wanted = ({ [10] = 851.3, [20] = 851.3, [40] = 848.0 })[n]
local accepted = n == 10 and 0.05 or 0.02

model "notched_beam" {}
local regions = {}
for side, x in pairs { left = -span / 2, right = 0 } do
  for part, z in pairs { lower = 0, upper = notch } do
    local name = side .. "_" .. part
    box(name) {
      from = { x, 0, z }, to = { x + span / 2, width, z + depth - notch }, cells = { half, 1, n // 2 },
    }
    regions[#regions + 1] = name
  end
end
material "concrete" { region = regions, density = 2400*kg/m^3, young = 30*GPa, poisson = 0.2 }
joint "notch" { between = { "left_lower", "right_lower" }, law = "frictional", friction = 0, normal_stiffness = 1e11*Pa/m, shear_stiffness = 1e10*Pa/m }
joint "plane" {
  between = { "left_upper", "right_upper" }, law = "softening", tensile_strength = 3.33*MPa, cohesion = 10*MPa,
  fracture_energy = 124*J/m^2, normal_stiffness = 1e13*Pa/m, shear_stiffness = 4e12*Pa/m,
}
surface "bottom" { of = { "left_lower", "right_lower" }, side = "bottom" }
surface "top" { of = { "left_upper", "right_upper" }, side = "top" }
local function across(x, z) return { { x, 0, z }, { x, width, z } } end
fix { surface = "bottom", line = across(-span / 2, 0), x = 0, y = 0, z = 0 }
fix { surface = "bottom", line = across(span / 2, 0), z = 0 }
stage "bend" {
  apply = { displacement { surface = "top", line = across(0, depth), z = -0.8*mm } },
  solve = static { tolerance = 1e-5, increments = 32 },
}
history "load" { surface = "top", record = { "reaction" } }
history "contacts" { record = { "dissipation", "cracked_area" } }
expect "peak" { that = function(result)
  local peak, at = 0, 0
  for i, force in ipairs(result.history("load").values("reaction.z", "bend")) do
    if -force > peak then peak, at = -force, 0.8 * i / 32 end
  end
  return math.abs(peak / wanted - 1) < accepted, string.format("%.1f N at %.3f mm, wanted %.1f", peak, at, wanted)
end }
