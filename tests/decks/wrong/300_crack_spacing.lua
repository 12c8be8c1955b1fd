model "wall" {}
box "wall" { from = { 0, 0, 0 }, to = { 2, 1, 2 }, cells = { 8, 4, 8 } }
fix { surface = "wall.bottom", x = 0, y = 0, z = 0 }
material "concrete" {
  region = "wall", law = "breakage", density = 2400*kg/m^3, young = 30*GPa, poisson = 0.2, tensile_strength = 2.5*MPa,
  fracture_energy = 100*J/m^2, cohesion = 4*MPa, friction = 40*deg, crack_spacing = 0.5*m,
}
gravity { z = -9.81 }
stage "weight" { solve = static {} }
