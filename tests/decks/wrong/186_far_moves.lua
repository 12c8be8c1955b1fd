model "blocks" {}
box "ground" { from = {0,0,0}, to = {1*m,1*m,1*m}, cells = {1,1,1} }
box "block" { from = {0,0,1*m}, to = {1*m,1*m,2*m}, cells = {1,1,1} }
material "rock" { region = "ground", density = 2600*kg/m^3, young = 30*GPa, poisson = 0.2 }
material "soft" { region = "block", density = 2600*kg/m^3, young = 30*GPa, poisson = 0.2, formulation = "bbar" }
joint "bed" { between = { "ground", "block" }, law = "brittle", friction = 35*deg, tensile_strength = 1*MPa, cohesion = 1*MPa }
fix { surface = "ground.bottom", x = 0, y = 0, z = 0 }
water_pressure "lake" { surface = "block.left", level = 2*m }
stage "fall" { solve = dynamic { duration = 1*s, large_displacement = true } }
stage "lean" { solve = static {} }
