model "wall" { reference_temperature = 10*degC }
box "wall" { from = { 0, 0, 0 }, to = { 1, 1, 3 }, size = 0.5 }
material "concrete" { region = "wall", density = 2400, young = 30*GPa, poisson = 0.2, conductivity = 2.6, heat_capacity = 960 }
convection { surface = "wall.left", film = 15, ambient = in_time(function(t) return 10 + 8*math.sin(2*math.pi*t/year) end) }
stage "heat" { solve = thermal { duration = 2*days, record_every = 1*days } }
