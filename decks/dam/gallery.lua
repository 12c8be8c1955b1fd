-- Gravity dam with a drainage gallery near its heel: own weight and reservoir on dam and rock.
-- The dam's section has a hole, so it is cut into triangles, each split into three quads: fine at the gallery, growing away
-- from it. The rock is meshed in rows; its columns follow the dam's base.
local args = deck.args {
  water    = { default = 55, unit = m, doc = "reservoir level above the base" },
  elements = { default = "hex8", doc = "hex8, wedge6 or tet4" },
}
local length = 3*m

model "gallery" {}

-- 2 m wide, 3 m high, with a round vault.
local gallery = { { 4, 4 }, { 6, 4 } }
for i = 0, 8 do
  local angle = math.pi * i / 8
  gallery[#gallery + 1] = { 5 + math.cos(angle), 6 + math.sin(angle) }
end

extrude "dam" {
  section = { {0,0}, {48*m,0}, {8*m,50*m}, {8*m,60*m}, {0,60*m} }, holes = { gallery },
  size = 3*m, hole_size = 0.3*m, grow = 1.25, length = length, layers = 1, elements = args.elements,
}
extrude "rock" {
  section = { {-60*m,-60*m}, {108*m,-60*m}, {108*m,0}, {-60*m,0} },
  size = 8*m, grow = 1.25, length = length, layers = 1, elements = args.elements,
}

surface "upstream"  { of = "dam", facing = { -1, 0, 0 }, within = 10*deg, box = { {-1*m,-1*m,-1*m}, {1*m,length+1*m,61*m} } }
surface "gallery"   { of = "dam", box = { {3.9*m,0.1*m,3.9*m}, {6.1*m,length-0.1*m,7.1*m} } }
surface "bottom"    { of = "rock", side = "bottom" }
surface "far_field" { of = "rock", side = { "left", "right" } }
surface "slice"     { of = { "dam", "rock" }, side = { "front", "back" } }

material "concrete" { region = "dam", young = 20*GPa, poisson = 0.2, density = 2400*kg/m^3 }
material "granite"  { region = "rock", young = 25*GPa, poisson = 0.22, density = 2650*kg/m^3 }

fix "base"         { surface = "bottom", x = 0, y = 0, z = 0 }
fix "rollers"      { surface = "far_field", normal = true }
fix "plane_strain" { surface = "slice", normal = true }
gravity            { z = -9.81 }
water_pressure "reservoir" { surface = "upstream", level = args.water }

stage "gravity" { solve = static { tolerance = 1e-6 } }
-- The drains fail: the gallery fills up to the level of the reservoir.
stage "flooded" {
  apply = { water_pressure "flood" { surface = "gallery", level = args.water } }, solve = static { tolerance = 1e-6 },
}

history "crest"   { at = { 0, 0, 60*m }, record = { "displacement" } }
history "sole"    { at = { 5*m, 0, 4*m }, record = { "displacement" } }
history "vault"   { at = { 5*m, 0, 7*m }, record = { "displacement" } }
history "support" { surface = "bottom", record = { "reaction" } }
history "flood"   { surface = "gallery", record = { "load" } }
history "water"   { surface = "upstream", record = { "load" } }
output "fields"   { record = { "displacement", "stress", "principal_stress" } }
picture "stress"  { of = "principal_stress", section = "y" }

-- By hand: sections and weights, the gallery left out; eight chords of the vault turn by pi / 8 each.
local hole = 2 * 2 + 8 * 0.5 * math.sin(math.pi / 8)
expect "the rock carries dam and rock less the gallery" {
  history = "support", stage = "gravity", component = "reaction.z", relative = 1e-4,
  value = ((168 * 60) * 2650 + (28 * 50 + 8 * 10 - hole) * 2400) * 3 * 9.81,
}
expect "the water in the gallery weighs on its wall" {
  history = "flood", component = "load.z", stage = "flooded", value = -hole * 3 * 1000 * 9.81, relative = 1e-6,
}
expect "water thrust" { history = "water", component = "load.x", value = 1000 * 9.81 * 55^2 / 2 * 3, relative = 1e-3 }
expect "the gallery is squeezed" {
  that = function(result)
    return result.history("vault").at("displacement.z") < result.history("sole").at("displacement.z")
  end,
}
