model "column" {}
box "column" { from = {0, 0, 0}, to = {1*m, 1*m, 4*m}, cells = {1, 1, 4} }
surface "foot" { of = "column", side = "bottom" }
material "concrete" { region = "column", density = 2400*kg/m^3, young = 30*GPa, poisson = 0.2 }
box "cap" { from = {0, 0, 4*m}, to = {1*m, 1*m, 5*m}, cells = {1, 1, 1} }
joint "seam" { between = { "column", "cap" }, law = "brittle", tensile_strength = 2*MPa, cohesion = 0.5*MPa, friction = 45 }
fix "foot" { surface = "foot", x = 0, y = 0, z = 0 }
gravity { z = -9.81 }
stage "gravity" { solve = static {} }
