box "rock" { from = {0, 0, -1}, to = {1, 1, 0}, cells = {2, 2, 2} }
solid "dam" { file = "solid_small.off", unit = 1*km, size = 0.3 }
material "concrete" { region = { "dam", "rock" }, density = 2400, young = 30e9, poisson = 0.2 }
fix { surface = "rock.bottom", x = 0, y = 0, z = 0 }
gravity { z = -9.81 }
stage "weight" { solve = static {} }
