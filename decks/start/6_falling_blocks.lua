-- A cube of eight blocks falls on its edge and breaks apart: large displacement.
-- ashlar run 6_falling_blocks.lua
model "falling_blocks" {}
box "ground" { from = { -2, -2, -0.1 }, to = { 2, 2, 0 }, cells = { 4, 4, 1 } }
local cosine, sine = math.cos(30*deg), math.sin(30*deg)
box "blocks" {  -- turned about y
  from = { -0.2, -0.2, -0.2 }, to = { 0.2, 0.2, 0.2 }, cells = { 2, 2, 2 },
  x = function(x, y, z) return cosine * x + sine * z end, z = function(x, y, z) return 0.4 - sine * x + cosine * z end,
}
material "rock" { region = { "ground", "blocks" }, density = 2500*kg/m^3, young = 5*GPa, poisson = 0.2 }
-- Every element is a block. Blocks touch each other and the ground wherever they meet; the stiffness of their contacts
-- has to be given, since nobody knows before where that will be.
crackable "contacts" {
  region = "blocks", law = "frictional", friction = 25*deg, normal_stiffness = 2*GPa/m, shear_stiffness = 2*GPa/m,
}
surface "held" { of = "ground" }
fix { surface = "held", x = 0, y = 0, z = 0 }
gravity { z = -9.81 }
-- contact_damping: what a bounce loses. Steps of a third keep the energy of impacts better.
stage "fall" {
  solve = dynamic {
    duration = 5*s, large_displacement = true, contact_damping = 1e-4*s, record_every = 0.02*s, time_factor = 0.3,
  },
}

output "fields" { record = { "displacement" } }
picture "fallen" { of = "displacement", stage = "fall", deform = 1 }
history "all" { record = { "energy" } }
expect "energy is accounted for" { that = function(result)
  local drift = result.stage("fall").energy_drift
  return drift < 1e-3, string.format("%.2g of the peak", drift)
end }
