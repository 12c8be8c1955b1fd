model "column" {}
box "column" { from = {0, 0, 0}, to = {1*m, 1*m, 4*m}, size = 1*m }
surface "foot" { of = "column", side = "bottom" }
material "concrete" { region = "column", density = 2400*kg/m^3, young = 30*GPa, poisson = 0.2 }
fixed_temperature { surface = "foot", value = 5*degC }
stage "winter" { solve = thermal { duration = 100*days } }
