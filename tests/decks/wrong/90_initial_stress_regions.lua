model "ground" {}
box "soil" { from = { 0, 0, -3 }, to = { 1, 1, 0 }, size = 0.5 }
material "soil" { region = "soil", density = 1800, young = 50*MPa, poisson = 0.3 }
initial_stress { level = 0, k0 = 0.5 }
initial_stress "again" { region = "soil", level = 0, k0 = 0.6 }
initial_stress "rock" { region = "sail", level = 0, k0 = 0.6 }
stage "rest" { solve = static {} }
