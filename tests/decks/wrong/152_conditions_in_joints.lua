model "dam" {}
box "rock" { from = { 0, 0, -2 }, to = { 4, 1, 0 }, size = 1 }
box "dam" { from = { 0, 0, 0 }, to = { 2, 1, 4 }, size = 1 }
material "concrete" { region = { "dam", "rock" }, density = 2400, young = 30*GPa, poisson = 0.2 }
joint "base" { between = { "dam", "rock" }, law = "frictional", friction = 40*deg }
surface "contact" { joint = "base" }
fix { surface = "contact", x = 0, y = 0, z = 0 }
uplift { surface = "contact", upstream_level = 3, downstream_level = 0 }
stage "weight" { solve = static {} }
