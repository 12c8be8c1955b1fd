-- Case a contraction joint through the seasons: two blocks between two abutments, the joint between them open from the
--   start or not, grouted in winter or never.
-- Source: closed form: free, the joint is wider by expansion * cooling * length; grout makes the width of the moment the one
--   at which it closes; where it is closed, stress = -young * (the rest of the expansion) / (length + young / stiffness).
-- Accept: 0.1 %.
-- Runs: opening=0 | opening=0.4 | opening=0.4 grouted=false | opening=0 grouted=false | elements=tet4
local args = deck.args {
  opening = { default = 0.4, doc = "of the joint at the start, mm" },
  grouted = { default = true, doc = "whether it is grouted after the first winter" },
  elements = { default = "hex8", doc = "hex8, wedge6 or tet4" },
}
local young, expansion, length, stiffness = 20e9, 1e-5, 12, 1e12
local opening = args.opening * 1e-3

model "contraction_joint" { reference_temperature = 15*degC }
box "left" { from = { 0, 0, 0 }, to = { length / 2, 1, 1 }, cells = { 3, 1, 1 }, elements = args.elements }
box "right" { from = { length / 2, 0, 0 }, to = { length, 1, 1 }, cells = { 3, 1, 1 }, elements = args.elements }
material "concrete" {
  region = { "left", "right" }, young = young*Pa, poisson = 0, density = 2400*kg/m^3, expansion = expansion/K,
}
joint "joint" {
  between = { "left", "right" }, law = "frictional", friction = 35*deg, initial_opening = opening*m,
  normal_stiffness = stiffness*Pa/m, shear_stiffness = stiffness*Pa/m,
}
-- Nothing presses the blocks together at first: each is held at its abutment, and moves along x only.
fix { surface = "left.left", x = 0 }
fix { surface = "right.right", x = 0 }
surface "sides" { of = { "left", "right" }, side = { "front", "back", "bottom", "top" } }
fix { surface = "sides", y = 0, z = 0 }
local seasons = { { "winter", 3 }, { "summer", 25 }, { "cold winter", -5 }, { "hot summer", 60 } }
local filled = 0  -- the width that grout has taken
for i, season in ipairs(seasons) do
  local name, temperature = season[1], season[2]
  local apply = { temperature_field { value = temperature*degC } }
  if args.grouted and i == 2 then apply[2] = grouting { of = "joint" } end
  stage(name) { apply = apply, solve = static { tolerance = 1e-9 } }
  local width = opening - filled - expansion * (temperature - 15) * length
  if args.grouted and i == 1 then filled = width end
  local stress = width < 0 and young * width / (length + young / stiffness) or 0
  local tolerance = math.max(1e-3 * -stress, 10)
  expect(name) { history = "middle", component = "stress.xx", stage = name, value = stress*Pa, tolerance = tolerance*Pa }
  expect(name .. ", push") {
    history = "abutment", component = "reaction.x", stage = name, value = -stress*N, tolerance = tolerance*N,
  }
end
history "middle" { at = { 4.5, 0.5, 0.5 }, record = { "stress" } }
history "abutment" { surface = "left.left", record = { "reaction" } }
output "joint" { record = { "displacement", "stress", "opening" } }
