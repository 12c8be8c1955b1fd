-- Case breakage (crack_spacing): a strip of triangles that lie anyhow, alike everywhere, is pulled apart: all of it
--   reaches its strength at once, and one crack is to take it all.
-- Source: equilibrium by hand: behind an open crack nothing bears load, so where cracks keep a distance nothing else is
--   cracked.
-- Accept: of 171 points, 10 mm apart, those that are cracked lie within 30 mm along the strip, from edge to edge, at
--   most 13 of them in 9 rows; four fifths of the load are lost. With spacing=0 21 are cracked: a band of triangles.
-- Runs: size=10
local args = deck.args {
  size    = { default = 10, doc = "edge of the triangles, mm" },
  spacing = { default = 150, doc = "least distance between cracks, mm; 0: none kept" },
}
local depth, thick = 0.1, 0.05

model "one_crack" {}
extrude "strip" {
  section = { { 0, 0 }, { 0.2, 0 }, { 0.2, depth }, { 0, depth } },
  length = thick, layers = 1, size = args.size*mm, elements = "wedge6", structured = false,
}
material "concrete" {
  region = "strip", law = "breakage", density = 2400*kg/m^3, young = 30*GPa, poisson = 0, tensile_strength = 3*MPa,
  fracture_energy = 100*J/m^2, cohesion = 9*MPa, friction = 30*deg, crack_spacing = args.spacing*mm,
}
surface "left"  { of = "strip", side = "left" }
surface "right" { of = "strip", side = "right" }
surface "front" { of = "strip", side = "front" }
fix { surface = "left", x = 0, z = 0 }
fix { surface = "front", y = 0 }
history "pull" { surface = "right", record = { "reaction" } }
local function point(i, k) return string.format("at %d %d", i, k) end
for i = 1, 19 do
  for k = 1, 9 do
    history(point(i, k)) { at = { 0.01 * i, thick / 2, 0.01 * k }, record = { "damage" } }
  end
end
stage "pull" {
  apply = { displacement { surface = "right", x = 0.07*mm, z = 0*m } },
  solve = static { tolerance = 1e-4, increments = 20, max_steps = 20000 },
}
expect "one crack" { that = function(result)
  local first, last, rows, cracked = 20, 0, {}, 0
  for i = 1, 19 do
    for k = 1, 9 do
      if result.history(point(i, k)).at("damage") > 0.05 then
        first, last, rows[k], cracked = math.min(first, i), math.max(last, i), true, cracked + 1
      end
    end
  end
  return last - first <= 3 and #rows == 9 and cracked <= 13,
    string.format("%d points, from %d mm to %d mm, in %d of 9 rows", cracked, 10 * first, 10 * last, #rows)
end }
expect "load lost" { that = function(result)
  local force, most = result.history("pull").values("reaction.x", "pull"), 0
  for _, f in ipairs(force) do most = math.max(most, f) end
  return force[#force] < 0.2 * most, string.format("%.3g kN of %.3g kN left", force[#force] / 1e3, most / 1e3)
end }
