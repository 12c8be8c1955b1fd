model "dam" {}
box "dam" { from = {0, 0, 0}, to = {8*m, 1*m, 10*m}, size = 2*m }
surface "base" { of = "dam", side = "bottom" }
material "concrete" { region = "dam", density = 2400*kg/m^3, young = 30*GPa, poisson = 0.2, expansion = 0 }
fix "foot" { surface = "base", x = 0, y = 0, z = 0 }
uplift { surface = "base", upstream_level = 9*m, downstream_level = 1*m, drain = 9*m, drain_efficiency = 0.5 }
stage "gravity" { solve = static {} }
