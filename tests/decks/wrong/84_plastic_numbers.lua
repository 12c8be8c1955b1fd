model "slope" {}
box "rock" { from = {0, 0, 0}, to = {1*m, 1*m, 1*m}, cells = {1, 1, 1} }
material "too much dilation" {
  region = "rock", law = "drucker_prager", density = 2600*kg/m^3, young = 10*GPa, poisson = 0.2, cohesion = 1*MPa,
  friction = 30*deg,
  dilation = 40*deg,
}
material "both ways" {
  region = "rock", law = "drucker_prager", density = 2600*kg/m^3, young = 10*GPa, poisson = 0.2, cohesion = 1*MPa,
  cone_slope = 0.2,
}
material "half" {
  region = "rock", law = "drucker_prager", density = 2600*kg/m^3, young = 10*GPa, poisson = 0.2, cohesion = 1*MPa,
}
material "brittle" {
  region = "rock", law = "von_mises", density = 2600*kg/m^3, young = 10*GPa, poisson = 0.2, yield_stress = 1*MPa,
  hardening = -20*GPa,
}
material "typed" {
  region = "rock", law = "drucker_prager", density = 2600*kg/m^3, young = 10*GPa, poisson = 0.2, cohesion = -1*MPa,
  friction = 30*deg, match = "outter", formulation = "bar",
}
