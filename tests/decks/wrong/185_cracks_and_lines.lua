model "bar" {}
box "bar" { from = {0,0,0}, to = {4*m,1*m,1*m}, cells = {4,1,1} }
box "top" { from = {0,0,1*m}, to = {4*m,1*m,2*m}, cells = {4,1,1} }
material "rock" { region = { "bar", "top" }, density = 2600*kg/m^3, young = 30*GPa, poisson = 0.2 }
fix { surface = "bar.left", x = 0, y = 0, z = 0 }
fix { surface = "top.left", x = 0, y = 0, z = 0 }
joint "bed" { between = { "bar", "top" }, law = "elastic" }
crack_water { of = { "bed" }, level = 3*m }
crack_water { of = { "bad" }, level = 3*m }
fix { surface = "bar.bottom", line = { {1*m,1*m,0}, {1*m,1*m,1*m} }, z = 0 }
fix { surface = "bar.bottom", line = { {1.5*m,0,0}, {1.5*m,1*m,0} }, z = 0 }
stage "rest" { solve = static {} }
