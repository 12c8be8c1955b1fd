model "springs" {}
box "rubble" { from = {0, 0, 0}, to = {1*m, 1*m, 1*m}, cells = {2, 2, 2}, elements = "tet4" }
material "too wide" {
  region = "rubble", law = "discrete_spring", density = 2600*kg/m^3, young = 10*GPa, packing = "irregular",
  poisson = 0.3,
}
material "too soft" {
  region = "rubble", law = "discrete_spring", density = 2600*kg/m^3, young = 10*GPa, poisson = -0.7, rigidity = 3,
}
material "typed" {
  region = "rubble", law = "discrete_springs", density = 2600*kg/m^3, young = 10*GPa, poisson = 0.2,
}
