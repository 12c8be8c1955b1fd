-- Case breakage: an L-shaped panel of concrete bent open at its inner corner until it cracks (Winkler's test).
-- Source: test: Winkler, Hofstetter & Lehar 2004 (Int. J. Numer. Anal. Meth. Geomech. 28): peak load usually
--   quoted as 7 to 8 kN.
-- Accept: peak within 15 % of 7.5 kN; coarser elements carry more (8.7 kN with 25 mm).
-- Runs: size=12.5
local args = deck.args {
  size       = { default = 12.5, doc = "edge of the elements, mm" },
  law        = { default = "breakage", doc = "breakage or damage" },
  increments = { default = 50, doc = "of the movement" },
}
local short, long = math.floor(250 / args.size + 0.5), math.floor(500 / args.size + 0.5)
local edge, breaks = args.size * 1e-3, args.law == "breakage"

model "l_panel" {}
box "foot" { from = { 0, 0, 0 }, to = { 0.25, 0.1, 0.25 }, cells = { short, 1, short } }
box "head" { from = { 0, 0, 0.25 }, to = { 0.5, 0.1, 0.5 }, cells = { long, 1, short } }
material "concrete" {
  region = { "foot", "head" }, law = args.law, density = 2400*kg/m^3, young = 25.85*GPa, poisson = 0.18,
  tensile_strength = 2.7*MPa, fracture_energy = 65*N/m, cohesion = breaks and 8*MPa or nil,
  friction = breaks and 30*deg or nil,
}
surface "push" { of = "head", side = "bottom", box = { { 0.47 - 0.55 * edge, -1, 0.2 }, { 0.47 + 0.45 * edge, 1, 0.3 } } }
fix { surface = "foot.bottom", x = 0, y = 0, z = 0 }
fix { surface = { "foot.front", "head.front" }, y = 0 }
history "push" { surface = "push", record = { "reaction" } }
history "blocks" { record = { "dissipation" } }
stage "push" {
  apply = { displacement { surface = "push", z = 0.6*mm } },
  solve = static { tolerance = 1e-4, increments = args.increments, max_steps = 20000 },
}
expect "peak" { that = function(result)
  local force, peak, at = result.history("push").values("reaction.z", "push"), 0, 0
  for i, f in ipairs(force) do if f > peak then peak, at = f, i end end
  return math.abs(peak / 7.5e3 - 1) < 0.15, string.format("%.4g kN at %.3g mm", peak / 1e3, at * 0.6 / #force)
end }
picture "cracks" { of = "damage", deform = 100 }
