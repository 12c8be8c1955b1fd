model "dam" {}
box "dam" { from = {0, 0, 0}, to = {8*m, 1*m, 10*m}, size = 2*m }
surface "base" { of = "dam", side = "bottom" }
material "concrete" { region = "dam", density = 2400*kg/m^3, young = 30*GPa, poisson = 0.2, expansion = 0 }
fix "foot" { surface = "base", x = 0, y = 0, z = 0 }
point_load "nothing" { at = {4*m, 0.5*m, 10*m} }
point_load "tons" { at = {4*m, 0.5*m, 10*m}, z = -20*kg }
point_load "nowhere" { z = -20*kN }
heat_source "flux" { value = 300*W/m^2 }
stage "gravity" { solve = static {} }
