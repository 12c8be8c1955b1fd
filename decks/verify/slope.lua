-- Case strength reduction: a slope of 10 m at 45 deg that charts put at the limit: the safety factor,
--   Mohr-Coulomb without dilation, plane strain.
-- Source: limit analysis: 45 deg with phi = 20 deg falls at height 16.16 c / gamma (Chen 1975, Limit Analysis and Soil
--   Plasticity; Taylor's chart of 1937: stability number 0.062). It holds for flow with dilation; free slopes hardly feel
--   that (Griffiths & Lane 1999), and elements of 1 m follow flow without it better.
-- Accept: 3 %.
-- Runs: factor=1
local args = deck.args {
  size   = { default = 1, doc = "edge of the elements, m" },
  factor = { default = 1, doc = "safety factor by the chart" },
}
local height, gamma = 10, 20e3
local cohesion, friction = args.factor * gamma * height / 16.16, math.atan(args.factor * math.tan(math.rad(20)))

model "slope" {}
extrude "soil" {
  section = { { -15, -5 }, { 30, -5 }, { 30, height }, { height, height }, { 0, 0 }, { -15, 0 } },
  length = args.size, layers = 1, size = args.size,
}
material "soil" {
  region = "soil", law = "mohr_coulomb", density = gamma / 10 * kg/m^3, young = 100*MPa, poisson = 0.3,
  cohesion = cohesion*Pa, friction = friction,
}
surface "bottom" { of = "soil", side = "bottom" }
surface "slice" { of = "soil", side = { "front", "back" } }
surface "far" { of = "soil", plane = { { 30, 0, 0 }, { 1, 0, 0 } } }
surface "near" { of = "soil", plane = { { -15, 0, 0 }, { 1, 0, 0 } } }
fix "bottom" { surface = "bottom", x = 0, y = 0, z = 0 }
fix "sides" { surface = { "far", "near", "slice" }, normal = true }
gravity { z = -10 }
stage "safety" {
  solve = strength_reduction {
    between = { 0.9 * args.factor, 1.2 * args.factor }, width = 0.03, tolerance = 2e-5, max_steps = 4000,
  },
}
expect "safety factor" { that = function(result)
  local s = result.stage("safety")
  local middle = (s.safety_factor + s.falling_factor) / 2
  return s.converged and math.abs(middle / args.factor - 1) < 0.03,
    string.format("stands at %.4g, falls at %.4g, chart %.4g", s.safety_factor, s.falling_factor, args.factor)
end }
