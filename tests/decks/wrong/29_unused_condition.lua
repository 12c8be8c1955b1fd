model "column" {}
box "column" { from = {0, 0, 0}, to = {1*m, 1*m, 4*m}, size = 1*m }
surface "foot" { of = "column", side = "bottom" }
material "concrete" { region = "column", density = 2400*kg/m^3, young = 30*GPa, poisson = 0.2, expansion = 1e-5/K }
fix "foot" { surface = "foot", x = 0, y = 0, z = 0 }
convection "air" { surface = "foot", ambient = 10*degC, film = 15*W/(m^2*K) }
stage "gravity" { solve = static {} }
