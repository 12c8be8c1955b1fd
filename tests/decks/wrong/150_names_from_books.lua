model "wall" {}
box "wall" { from = { 0, 0, 0 }, to = { 1, 1, 3 }, size = 0.5 }
material "concrete" { region = "wall", rho = 2400, E = 30*GPa, nu = 0.2, thermal_expansion = 1e-5, capacity = 960 }
