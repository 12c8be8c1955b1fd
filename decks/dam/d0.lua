-- Reference dam D0, elastic: own weight and a full reservoir on dam and rock, compared with CalculiX 2.20 on the same mesh.
-- ashlar run d0.lua                   312 elements
-- ashlar run d0.lua --set fine=true  2496 elements
local args = deck.args {
  fine = { default = false, doc = "the mesh with half the element size" },
}

model "d0" {}

import_mesh { file = args.fine and "d0_fine.msh" or "d0_coarse.msh" }

material "concrete" { region = "concrete", young = 20*GPa, poisson = 0.2, density = 2400*kg/m^3 }
material "rock"     { region = "rock",     young = 20*GPa, poisson = 0.2, density = 2650*kg/m^3 }

fix "base"         { surface = "bottom", x = 0, y = 0, z = 0 }
fix "sides"        { surface = "xside", normal = true }
fix "plane_strain" { surface = "yside", normal = true }
gravity            { z = -9.81 }
water_pressure "reservoir" { surface = "up_wet", level = 55*m }

stage "gravity" { solve = static { tolerance = 1e-8 } }

history "crest"   { at = { 0, 0, 60*m }, record = { "displacement" } }
history "heel"    { at = { 0, 0, 0 }, record = { "displacement" } }
history "toe"     { at = { 48*m, 0, 0 }, record = { "displacement" } }
history "support" { surface = "bottom", record = { "reaction" } }
history "water"   { surface = "up_wet", record = { "load" } }

-- CalculiX, plain 8-node bricks (C3D8) with consistent water loads.
local reference = args.fine and {
  crest = { x = 2.292586*mm, z = -4.443912*mm }, heel = { x = 0.881835*mm, z = -2.98756*mm }, toe = { x = 0.494324*mm, z = -3.20063*mm },
} or {
  crest = { x = 2.297297*mm, z = -4.419904*mm }, heel = { x = 0.858090*mm, z = -3.00099*mm }, toe = { x = 0.498173*mm, z = -3.17676*mm },
}
for _, place in ipairs { "crest", "heel", "toe" } do
  for _, axis in ipairs { "x", "z" } do
    expect(place .. " " .. axis .. " as CalculiX") {
      history = place, component = "displacement." .. axis, value = reference[place][axis], relative = 1e-4,
    }
  end
end

-- By hand: weights of rock and dam, thrust of 55 m of water on 12 m of dam.
expect "support carries the weight" {
  history = "support", component = "reaction.z", relative = 1e-5,
  value = ((168 * 60) * 2650 + (28 * 50 + 8 * 10) * 2400) * 12 * 9.81,
}
expect "water thrust" {
  history = "water", component = "load.x", value = 1000 * 9.81 * 55^2 / 2 * 12, relative = 1e-5,
}

output "fields" { record = { "displacement", "stress", "principal_stress" } }
picture "settlement" { of = "displacement", deform = 2000 }
picture "stress"     { of = "principal_stress" }
