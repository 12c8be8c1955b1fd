-- Case P37: a disc of 0.1 m squeezed along its diameter between platens on 5 degrees of arc, cracked between any two of its tet4.
-- Source: Hondros 1959: in the middle 2 P / (pi D t) across, three times that along the load; it splits where the former is
--   the tensile strength, 3 MPa; a slice of 5 mm of the disc that the case names (t = 50 mm, 23.56 kN).
-- Accept: elastic field 3 %, peak load -10 % to +20 %, the first crack near the loaded diameter; at the end the disc
--   has parted within a fifth of the radius of that diameter, by more than twice as much as either half has spread at any
--   height and five times in the mean; energy of the motion kept to 1e-3 of its peak.
-- Runs: size=4.5
local args = deck.args { size = { default = 4.5, doc = "edge of the elements, mm" } }
local diameter, thickness, strength, sides = 0.1, 0.005, 3e6, 72
local load = math.pi * diameter * thickness * strength / 2

model "brazilian_disc" {}
local outline = {}
for i = 0, sides - 1 do
  local angle = 2 * math.pi * (i + 0.5) / sides
  outline[#outline + 1] = { diameter / 2 * math.cos(angle), diameter / 2 * math.sin(angle) }
end
extrude "disc" { section = outline, length = thickness, layers = 1, size = args.size*mm, elements = "tet4" }
material "rock" { region = "disc", density = 2400*kg/m^3, young = 30*GPa, poisson = 0.2 }
crackable "rock" {
  region = "disc", law = "softening", tensile_strength = strength*Pa, cohesion = 12*MPa, friction = 45*deg,
  fracture_energy = 10*J/m^2, stiffness_factor = 20,
}
surface "above" { of = "disc", facing = { 0, 0, 1 }, within = 4*deg }
surface "below" { of = "disc", facing = { 0, 0, -1 }, within = 4*deg }
surface "side" { of = "disc", side = "front" }
fix { surface = "below", x = 0, z = 0 }
fix { surface = "side", y = 0 }
local function squeezed(by) return displacement { surface = "above", x = 0, z = by } end
stage "elastic" { apply = { squeezed(-0.005*mm) }, solve = static { tolerance = 1e-6, increments = 1 } }
stage "squeeze" { apply = { squeezed(-0.065*mm) }, solve = static { tolerance = 1e-4, increments = 5 } }
-- It splits faster than any platen follows: the motion itself, squeezed on at 40 mm/s.
stage "split" {
  apply = { squeezed(in_stage { time = { 0*s, 0.5e-3*s }, value = { -0.065*mm, -0.085*mm } }) },
  solve = dynamic { duration = 0.5e-3*s, local_damping = 0.05, record_every = 5e-6*s },
}

history "load" { surface = "above", record = { "reaction" } }
history "contacts" { record = { "dissipation", "cracked_area" } }
-- Around the middle, where single tetrahedra scatter about the field.
local places = {}
for i = 0, 31 do
  local angle, radius = math.pi * (i + 0.5) / 16, i % 2 == 0 and 0.004 or 0.008
  places[i + 1] = { name = "middle " .. i, x = radius * math.cos(angle), z = radius * math.sin(angle) }
  history(places[i + 1].name) { at = { places[i + 1].x, thickness / 2, places[i + 1].z }, record = { "stress" } }
end
-- Both halves, near the loaded diameter and further out.
local heights, sides_of = { -0.03, -0.015, 0, 0.015, 0.03 }, { -0.035, -0.01, 0.01, 0.035 }
local function beside(x, z) return string.format("at %g, %g", x, z) end
for _, z in ipairs(heights) do
  for _, x in ipairs(sides_of) do history(beside(x, z)) { at = { x, thickness / 2, z }, record = { "displacement" } } end
end
-- Stress of two point loads P = 1 on a disc, across and along.
local function exact(x, z)
  local r = diameter / 2
  local above, below = x^2 + (r - z)^2, x^2 + (r + z)^2
  local unit = 2 / (math.pi * thickness)
  return unit * (1 / diameter - (r - z) * x^2 / above^2 - (r + z) * x^2 / below^2),
    unit * (1 / diameter - (r - z)^3 / above^2 - (r + z)^3 / below^2)
end
expect "elastic field" { that = function(result)
  local force = -result.history("load").at("reaction.z", "elastic")
  local across, along, wanted_across, wanted_along = 0, 0, 0, 0
  for _, place in ipairs(places) do
    local xx, zz = exact(place.x, place.z)
    wanted_across, wanted_along = wanted_across + force * xx / #places, wanted_along + force * zz / #places
    across = across + result.history(place.name).at("stress.xx", "elastic") / #places
    along = along + result.history(place.name).at("stress.zz", "elastic") / #places
  end
  return math.abs(across / wanted_across - 1) < 0.03 and math.abs(along / wanted_along - 1) < 0.03,
    string.format("%.4g and %.4g Pa, wanted %.4g and %.4g", across, along, wanted_across, wanted_along)
end }
expect "peak and crack" { that = function(result)
  local peak = 0
  for _, force in ipairs(result.history("load").values("reaction.z", "split")) do peak = math.max(peak, -force) end
  local place = result.stage("split").first_crack_place
  return peak > 0.9 * load and peak < 1.2 * load and math.abs(place.x) < diameter / 10,
    string.format("peak %.4g N, wanted %.4g; first crack at x = %.2g, z = %.2g; cracked %.3g m^2 of %.3g", peak, load, place.x,
      place.z, result.stage("split").cracked_area, diameter * thickness)
end }
expect "crack along the loaded diameter" { that = function(result)
  local parted, spread, clear = 0, 0, true
  for _, z in ipairs(heights) do
    local u = {}
    for i, x in ipairs(sides_of) do u[i] = result.history(beside(x, z)).at("displacement.x", "split") end
    local across, within = u[3] - u[2], math.max(math.abs(u[2] - u[1]), math.abs(u[4] - u[3]))
    parted, spread, clear = parted + across / #heights, spread + within / #heights, clear and across > 2 * within
  end
  return clear and parted > 5 * spread,
    string.format("parted by %.3g mm, halves spread by %.2g mm, means over the height", 1e3 * parted, 1e3 * spread)
end }
expect "energy" { that = function(result)
  local drift = result.stage("split").energy_drift
  return drift < 1e-3, string.format("kept to %.1e", drift)
end }
