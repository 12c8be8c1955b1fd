model "wall" {}
box "wall" { from = { 0, 0, 0 }, to = { 1, 1, 2 }, size = 1 }
material "concrete" {
  region = "wall", density = 2400*kg/m^3, young = 30*GPa, poisson = 0.2, conductivity = 2.5*W/(m*K), heat_capacity = 960*J/(kg*K),
}
fix { surface = "wall.bottom", x = 0, y = 0, z = 0 }
stage "without end" { solve = coupled { every = 10*days } }
stage "too long" { solve = coupled {
  duration = 10*days,
  every = 20*days,
} }
stage "too short" { solve = coupled { duration = 365*days, every = 1*s } }
stage "backwards" { solve = coupled { duration = 365*days, every = -10*days, increments = 0 } }
stage "of the other" { solve = coupled { duration = 365*days, steady = true, intervall = 2 } }
