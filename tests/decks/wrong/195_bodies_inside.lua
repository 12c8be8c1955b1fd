model "inside" {}
box "ground" { from = {0, 0, 0}, to = {2*m, 2*m, 1*m}, cells = {2, 2, 1} }
box "block" { from = {0.6*m, 0.6*m, 0.9*m}, to = {1.2*m, 1.2*m, 1.5*m}, cells = {1, 1, 1} }
material "rock" { region = { "ground", "block" }, density = 2500*kg/m^3, young = 5*GPa, poisson = 0.2 }
joint "touch" {
  between = { "ground", "block" }, law = "frictional", friction = 30*deg, normal_stiffness = 1*GPa/m, shear_stiffness = 1*GPa/m,
}
fix { surface = "ground.bottom", x = 0, y = 0, z = 0 }
gravity { z = -9.81 }
stage "fall" { solve = dynamic { duration = 1*s, large_displacement = true } }
