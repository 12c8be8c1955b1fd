model "bar" {}
box "bar" { from = {0,0,0}, to = {4*m,1*m,1*m}, cells = {4,1,1} }
material "rock" { region = "bar", density = 2600*kg/m^3, young = { 30*GPa }, poisson = 0.2 }
surface "left" { of = "bar", side = "left" }
surface "right" { of = "bar", side = "right" }
fix { surface = "left", x = 0, y = 0, z = 0 }

stage "rest" { solve = static {} }
