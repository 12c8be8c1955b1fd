model "dam" {}
box "rock" { from = { 0, 0, -2 }, to = { 4, 1, 0 }, size = 1 }
box "dam" { from = { 0, 0, 0 }, to = { 2, 1, 4 }, size = 1 }
material "concrete" { region = { "dam", "rock" }, density = 2400, young = 30*GPa, poisson = 0.2 }
surface "base" { of = "dam", side = "bottom" }
surface "contact" { joint = "contact" }
stage "weight" { solve = static {} }
