-- Case D0 staged: gravity and water, then from summer to winter; every element its own block, the dam and its base may
--                 crack in tension at 1.5 MPa. Where and when does the first contact crack?
-- Source: independent numpy program, direct solution with elastic springs (nothing cracked before, so it is exact).
-- Accept: load factor 1 %, same place.
-- Runs: | fine=true
local args = deck.args { fine = { default = false, doc = "half the element size" } }
local d0 = require "d0"
model "d0_staged" { reference_temperature = 15*degC }
d0.body(args.fine and "r2_ny1" or "r1_ny1")
d0.supports()
d0.loads()
d0.explode(
  { normal_stiffness = 1e11*Pa/m, shear_stiffness = 1e11*Pa/m },
  { law = "brittle", tensile_strength = 1.5*MPa, cohesion = 1e15*Pa, friction = 0.7 })
stage "gravity"  { solve = static { tolerance = 1e-6 } }
stage "summer"   { apply = d0.climate(d0.season.summer), solve = thermal { steady = true } }
stage "winter"   { apply = d0.climate(d0.season.winter), solve = thermal { steady = true } }
stage "fracture" { solve = fracture { from = "summer", to = "winter", increments = 4, tolerance = 1e-6 } }

local onset, x = args.fine and 0.4744 or 0.5451, args.fine and 4 or 8
expect "nothing cracks before" { that = function(result) return result.stage("gravity").cracks == 0 end }
expect "first crack at load factor" { that = function(result)
  local found = result.stage("fracture").first_crack
  return math.abs(found / onset - 1) < 0.01, string.format("%.4f, numpy %.4f", found, onset)
end }
expect "first crack at place" { that = function(result)
  local place = result.stage("fracture").first_crack_place
  return math.abs(place.x - x) < 1e-6 and math.abs(place.z) < 1e-6,
         string.format("(%g, %g) m, numpy (%g, 0) m", place.x, place.z, x)
end }
