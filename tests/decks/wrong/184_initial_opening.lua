model "bar" {}
box "bar" { from = {0,0,0}, to = {4*m,1*m,1*m}, cells = {4,1,1} }
box "top" { from = {0,0,1*m}, to = {4*m,1*m,2*m}, cells = {4,1,1} }
material "rock" { region = { "bar", "top" }, density = 2600*kg/m^3, young = 30*GPa, poisson = 0.2 }
fix { surface = "bar.left", x = 0, y = 0, z = 0 }
fix { surface = "top.left", x = 0, y = 0, z = 0 }
joint "bed" { between = { "bar", "top" }, law = "elastic", initial_opening = 1*mm }
stage "rest" { solve = static {} }
