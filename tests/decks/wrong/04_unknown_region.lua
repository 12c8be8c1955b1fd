model "column" {}
box "column" { from = {0, 0, 0}, to = {1*m, 1*m, 4*m}, cells = {1, 1, 4} }
surface "foot" { of = "column", side = "bottom" }
material "concrete" { region = "column", density = 2400*kg/m^3, young = 30*GPa, poisson = 0.2 }
material "rock" { region = "colum", density = 2600*kg/m^3, young = 30*GPa, poisson = 0.2 }
fix "foot" { surface = "foot", x = 0, y = 0, z = 0 }
gravity { z = -9.81 }
stage "gravity" { solve = static {} }
