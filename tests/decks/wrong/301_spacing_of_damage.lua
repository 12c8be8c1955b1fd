model "wall" {}
box "wall" { from = { 0, 0, 0 }, to = { 2, 1, 2 }, cells = { 8, 4, 8 } }
material "concrete" {
  region = "wall", law = "damage", density = 2400*kg/m^3, young = 30*GPa, poisson = 0.2, tensile_strength = 2.5*MPa,
  fracture_energy = 100*J/m^2, crack_spacing = 2*m,
}
material "rock" {
  region = "wall", law = "breakage", density = 2400*kg/m^3, young = 30*GPa, poisson = 0.2, tensile_strength = 2.5*MPa,
  fracture_energy = 100*J/m^2, cohesion = 4*MPa, friction = 40*deg, crack_spaceing = -2*m,
}
