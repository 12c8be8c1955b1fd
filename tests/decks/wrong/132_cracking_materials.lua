model "blocks" {}
box "one" { from = { 0, 0, 0 }, to = { 1, 1, 1 }, size = 1 }
material "sharp" {
  region = "one", law = "breakage", density = 2400*kg/m^3, young = 30*GPa, poisson = 0.2,
  tensile_strength = 6*MPa, fracture_energy = 500*J/m^2, cohesion = 4*MPa, friction = 40*deg,
}
material "weak" {
  region = "one", law = "damage", density = 2400*kg/m^3, young = 30*GPa, poisson = 0.2,
  tensile_strength = 2*MPa, fracture_energy = 100*J/m^2, compressive_strength = 1*MPa,
}
material "slate" {
  region = "one", law = "jointed", density = 2700*kg/m^3, young = 30*GPa, poisson = 0.2,
  dip = 30*deg, dip_direction = 90*deg, cohesion = 0*Pa, friction = 25*deg, dilation = 30*deg,
}
material "crumbs" {
  region = "one", law = "breakage", density = 2400*kg/m^3, young = 30*GPa, poisson = 0.2,
  tensile_strength = -1*MPa, fracture_energy = 100*N/m, cohesion = 4*MPa, friction = 40*deg,
}
stage "rest" { solve = static {} }
stage "safety" { solve = strength_reduction { between = { 3, 1 } } }
