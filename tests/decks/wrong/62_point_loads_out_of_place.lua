model "dam" {}
box "dam" { from = {0, 0, 0}, to = {8*m, 1*m, 10*m}, size = 2*m }
surface "base" { of = "dam", side = "bottom" }
material "concrete" { region = "dam", density = 2400*kg/m^3, young = 30*GPa, poisson = 0.2, expansion = 0 }
fix "foot" { surface = "base", x = 0, y = 0, z = 0 }
point_load "crane" { at = {4*m, 0.5*m, 10.2*m}, z = -200*kN }
heat_source "hydration" { region = "lift", value = 300*W/m^3 }
stage "gravity" { solve = static {} }
