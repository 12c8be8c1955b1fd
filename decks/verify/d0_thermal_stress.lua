-- Case D0 thermal stress: the dam goes from steady summer to steady winter, without weight and water.
-- Source: independent numpy finite elements on the same mesh; thermal strain from the temperature at Gauss points.
-- Accept: 1e-4 of the largest displacement or stress.
-- Runs: | fine=true
local args = deck.args { fine = { default = false, doc = "half the element size" } }
local d0 = require "d0"
model "d0_thermal_stress" { reference_temperature = 15*degC }
d0.body(args.fine and "r2_ny1" or "r1_ny1")
d0.supports()
stage "summer" { apply = d0.climate(d0.season.summer), solve = thermal { steady = true, tolerance = 1e-12 } }
stage "winter" { apply = d0.climate(d0.season.winter), solve = thermal { steady = true, tolerance = 1e-12 } }
stage "change" { solve = fracture { from = "summer", to = "winter", increments = 1, tolerance = 1e-8 } }

local u = args.fine
  and { ["crest, upstream"] = { 0, 60, 0.02836337791, -0.02779120243 }, ["crest, downstream"] = { 8, 60, 0.02549541502, -0.03277566254 },
        heel = { 0, 0, 0.004514719037, -0.01432316407 }, toe = { 48, 0, 5.465672349e-05, -0.01732403591 } }
  or  { ["crest, upstream"] = { 0, 60, 0.02703790298, -0.02815513231 }, ["crest, downstream"] = { 8, 60, 0.02413774525, -0.03285780677 },
        heel = { 0, 0, 0.004565605755, -0.01451517914 }, toe = { 48, 0, 1.154272460e-05, -0.0175573165 } }
for name, place in pairs(u) do
  history(name) { at = { place[1], 0, place[2] }, record = { "displacement" } }
  for axis, value in pairs { x = place[3], z = place[4] } do
    expect(name .. ": u_" .. axis) {
      history = name, component = "displacement." .. axis, value = value, tolerance = 1e-4 * 0.0328,
    }
  end
end
d0.each_row("d0_thermal_stress.csv", args.fine and 2 or 1, function(r)
  local name = string.format("x = %.4g, z = %.4g", r.x, r.z)
  history(name) { at = { r.x, 6*m, r.z }, record = { "stress" } }
  for _, component in ipairs { "xx", "yy", "zz", "zx" } do
    expect(name .. ": s_" .. component) {
      history = name, component = "stress." .. component, value = r[component], tolerance = 1e-4 * 6.5e6,
    }
  end
end)
