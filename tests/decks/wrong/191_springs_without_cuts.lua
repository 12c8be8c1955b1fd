model "springs" {}
box "wall" { from = {0, 0, 0}, to = {1*m, 1*m, 1*m}, cells = {2, 2, 2} }
box "base" { from = {0, 0, -1*m}, to = {1*m, 1*m, 0}, cells = {2, 2, 2} }
material "bricks" {
  region = { "wall", "base" }, law = "discrete_spring", density = 2600*kg/m^3, young = 10*GPa, poisson = 0.2,
}
crackable "wall" { region = "wall", law = "elastic" }
fix { surface = "base.bottom", x = 0, y = 0, z = 0 }
gravity { z = -9.81 }
stage "stand" { solve = static {} }
