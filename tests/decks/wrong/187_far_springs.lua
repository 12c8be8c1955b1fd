model "blocks" {}
box "ground" { from = {0,0,0}, to = {1*m,1*m,1*m}, cells = {1,1,1} }
box "block" { from = {0,0,1*m}, to = {1*m,1*m,2*m}, cells = {1,1,1} }
material "rock" { region = { "ground", "block" }, density = 2600*kg/m^3, young = 30*GPa, poisson = 0.2 }
joint "bed" { between = { "ground", "block" }, law = "frictional", friction = 35*deg, initial_opening = 1*mm, normal_stiffness = 1e9*Pa/m }
fix { surface = "ground.bottom", x = 0, y = 0, z = 0 }
stage "fall" { solve = dynamic { duration = 1*s, large_displacement = true } }
