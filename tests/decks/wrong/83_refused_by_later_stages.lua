model "bar" {}
box "bar" { from = {0, 0, 0}, to = {4, 1, 1}, cells = {4, 1, 1} }
material "steel" { region = "bar", density = 7800, young = 200e9, poisson = 0.3, conductivity = 45 }
fix { surface = "bar.left", x = 0, y = 0, z = 0 }
gravity { z = -9.81 }
stage "weight" { solve = static {} }
stage "shake"  { solve = dynamic { duration = 1, time_step = 0.01 } }
