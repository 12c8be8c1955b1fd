model "ground" {}
box "soil" { from = { 0, 0, -3 }, to = { 1, 1, 0 }, size = 0.5 }
initial_stress "none" { region = "soil" }
initial_stress "both" { region = "soil", level = 0, k0 = 0.5, xx = 3*MPa }
initial_stress "half" { region = "soil", level = 0, k0_x = 0.5 }
initial_stress "floating" { region = "soil", k0 = 0.5 }
initial_stress "slanted" { region = "soil", level = 0, k0 = 0.5, unit_weight = 20*kPa }
initial_stress "spelt" { region = "soil", levels = 0, k0 = 0.5 }
