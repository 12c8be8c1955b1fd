model "wrong" {}
box "under" { from = {0,0,0}, to = {1,1,1}, cells = {1,1,1} }
box "over" { from = {0,0,1}, to = {1,1,2}, cells = {1,1,1} }
material "rock" { region = { "under", "over" }, density = 2400*kg/m^3, young = 30*GPa, poisson = 0.2 }
joint "plane" { between = { "under", "over" }, law = "elastic", conductance = 0*W/(m^2*K) }
joint "again" { between = { "under", "over" }, law = "elastic", open_conductance = -1*W/(m^2*K) }
crackable "all" { region = "under", law = "elastic", open_conductance = 1*W/(m^2*K) }
