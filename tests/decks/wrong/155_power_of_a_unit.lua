model "bar" {}
box "bar" { from = { 0, 0, 0 }, to = { 4, 1, 1 }, size = 1 }
material "rock" { region = "bar", density = 2600*kg/m^1e308, young = 30*GPa, poisson = 0.2 }
