model "wall" {}
box "wall" { from = { 0, 0, 0 }, to = { 1, 1, 2 }, size = 1 }
fix { surface = "wall.bottom", x = 0, y = 0, z = 0 }
material "concrete" { region = "wall", density = 2400*kg/m^3, young = 30*GPa, poisson = 0.2 }
gravity { z = -9.81 }
stage "safety" { solve = strength_reduction { between = { 1, 3 } } }
