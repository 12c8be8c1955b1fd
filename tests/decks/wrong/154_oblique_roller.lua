model "x" {}
extrude "dam" { section = { {0,0}, {50,0}, {8,60}, {0,60} }, length = 10, size = 5 }
material "c" { region = "dam", density = 2400, young = 30*GPa, poisson = 0.2 }
surface "slope" { of = "dam", facing = {1,0,0.7} }
fix { surface = "slope", normal = true }
fix { surface = "dam.bottom", x = 0, y = 0, z = 0 }
gravity { z = -9.81 }
stage "w" { solve = static {} }
