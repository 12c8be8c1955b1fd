model "column" {}
box "column" { from = {0, 0, 0}, to = {1*m, 1*m, 4*m}, cells = {1, 1, 4} }
surface "foot" { of = "column", side = "bottom" }
material "concrete" { region = "column", density = 2400*kg/m^3, young = 30*GPa, poisson = 0.2 }
fix "foot"
fix "side" { surface = "fot", normal = true }
stage "gravity" { solve = static {} }
