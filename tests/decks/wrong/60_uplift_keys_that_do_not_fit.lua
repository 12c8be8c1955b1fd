model "dam" {}
box "dam" { from = {0, 0, 0}, to = {8*m, 1*m, 10*m}, size = 2*m }
surface "base" { of = "dam", side = "bottom" }
material "concrete" { region = "dam", density = 2400*kg/m^3, young = 30*GPa, poisson = 0.2, expansion = 0 }
fix "foot" { surface = "base", x = 0, y = 0, z = 0 }
uplift "wet" { surface = "base", upstream_level = 9*m, downstream_level = 1*m, drain = 2*m }
uplift "dry" { surface = "base", upstream_level = 9*m, downstream_level = 1*m, gallery = 2*m }
uplift "reversed" { surface = "base", upstream_level = 1*m, downstream_level = 9*m }
uplift "percent" { surface = "base", upstream_level = 9*m, downstream_level = 1*m, drain = 2*m, drain_efficiency = 50 }
uplift "half" { surface = "base", upstream_level = 9*m }
pressure "silt" { surface = "base" , value = 3*m }
stage "gravity" { solve = static {} }
