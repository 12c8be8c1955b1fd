model "wall" {}
box "wall" { from = { 0, 0, 0 }, to = { 1, 1, 2 }, size = 1 }
material "concrete" {
  region = "wall", density = 2400*kg/m^3, young = 30*GPa, poisson = 0.2, conductivity = 2.5*W/(m*K), heat_capacity = 960*J/(kg*K),
}
fix { surface = "wall.bottom", x = 0, y = 0, z = 0 }
stage "gravity" { solve = static {} }
stage "year" { solve = coupled { duration = 365*days } }
stage "crack" { solve = fracture { from = "gravity", to = "year" } }
