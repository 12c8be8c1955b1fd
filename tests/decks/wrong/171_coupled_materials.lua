model "wall" {}
box "wall" { from = { 0, 0, 0 }, to = { 1, 1, 2 }, size = 1 }
box "slab" { from = { 0, 0, 2 }, to = { 1, 1, 3 }, size = 1 }
material "concrete" { region = "wall", density = 2400*kg/m^3, young = 30*GPa, poisson = 0.2, conductivity = 2.5*W/(m*K) }
material "steel" { region = "slab", density = 7800*kg/m^3, young = 200*GPa, poisson = 0.3, heat_capacity = 500*J/(kg*K) }
convection { surface = "wall.left", ambient = 10*degC, film = 15*W/(m^2*K) }
stage "year" { solve = coupled { duration = 365*days } }
