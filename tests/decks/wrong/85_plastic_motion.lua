model "slope" {}
box "rock" { from = {0, 0, 0}, to = {1*m, 1*m, 1*m}, cells = {1, 1, 1} }
material "clay" {
  region = "rock", law = "von_mises", density = 2000*kg/m^3, young = 100*MPa, poisson = 0.3, yield_stress = 100*kPa,
}
fix { surface = "rock.bottom", x = 0, y = 0, z = 0 }
gravity { z = -9.81 }
stage "shake" { solve = dynamic { duration = 1*s } }
