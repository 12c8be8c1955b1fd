model "bar" {}
box "bar" { from = {0,0,0}, to = {4*m,1*m,1*m}, cells = {4,1,1} }
material "rock" { region = "bar", density = 2600*kg/m^3, young = 30*GPa, poisson = 0.2 }
surface "left" { of = "bar", side = "left" }
surface "right" { of = "bar", side = "right" }
fix { surface = "left", x = 0, y = 0, z = 0 }
box "top" { from = {0,0,1*m}, to = {4*m,1*m,2*m}, cells = {3,1,1} }
material "soil" { region = "top", density = 2000*kg/m^3, young = 1*GPa, poisson = 0.2 }
fix { surface = "top.left", x = 0, y = 0, z = 0 }
stage "rest" { solve = static {} }
