-- Case heat through contacts: two layers of different elements and divisions between two temperatures, heat passes a joint
--   of 5.4 W/(m2 K), or of none given.
-- Source: closed form: resistances in a row, height / conductivity of each layer and 1 / conductance of the joint.
-- Accept: 0.05 % of the difference with a conductance; 0.5 % of the difference without, when the joint may resist by a tenth of the half
--   elements beside it.
-- Runs: lower=hex8 upper=tet4 | lower=tet4 upper=wedge6 | lower=hex8 upper=hex8 conductance=0
local args = deck.args {
  lower = { default = "hex8", doc = "elements of the lower layer, 3 x 3 x 10" },
  upper = { default = "tet4", doc = "elements of the upper layer, 4 x 5 x 14" },
  conductance = { default = 5.4, doc = "of the joint, W/(m^2 K); 0: not given" },
}
local conductivity, hot, h = 2.7, 20, args.conductance

model "unmatched_heat" { reference_temperature = 0*degC }
box "lower" { from = { 0, 0, 0 }, to = { 1, 1, 0.5 }, cells = { 3, 3, 10 }, elements = args.lower }
-- A little aside: nodes that lie on each other are one, and conduct as one.
local aside = 2e-5
box "upper" { from = { aside, aside, 0.5 }, to = { 1 + aside, 1 + aside, 1.2 }, cells = { 4, 5, 14 }, elements = args.upper }
material "concrete" {
  region = { "lower", "upper" }, young = 30*GPa, poisson = 0.2, density = 2400*kg/m^3,
  conductivity = conductivity*W/(m*K), heat_capacity = 960*J/(kg*K),
}
joint "plane" { between = { "lower", "upper" }, law = "elastic", conductance = h > 0 and h*W/(m^2*K) or nil }
fixed_temperature { surface = "lower.bottom", value = 0*degC }
fixed_temperature { surface = "upper.top", value = hot*degC }
stage "steady" { solve = thermal { steady = true } }

local flow = hot / (1.2 / conductivity + (h > 0 and 1 / h or 0))
local wanted = {
  { "low", 0.2, flow * 0.2 / conductivity },
  { "below", 0.5 - 1e-6, flow * 0.5 / conductivity },
  { "above", 0.5 + 1e-6, hot - flow * 0.7 / conductivity },
  { "high", 0.9, hot - flow * 0.3 / conductivity },
}
for _, w in ipairs(wanted) do
  history(w[1]) { at = { 0.37, 0.42, w[2] }, record = { "temperature" } }
  expect(w[1]) {
    history = w[1], component = "temperature", value = w[3]*degC, tolerance = (h > 0 and 0.01 or 0.1)*K,
  }
end
