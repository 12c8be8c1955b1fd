model "wall" { reference_temperature = 10*degC }
box "wall" { from = { 0, 0, 0 }, to = { 1, 1, 3 }, size = 0.5 }
material "concrete" { region = "wall", density = 2400, young = 30*GPa, poisson = 0.2, conductivity = 2.6, heat_capacity = 960 }
surface "left" { of = "wall", side = "left" }
convection "plain" { surface = "left", film = 15, ambient = function(t) return 10 end }
convection "back" { surface = "left", film = 15, ambient = { { 0*days, 5*degC }, { 3*days, 8*degC }, { 2*days, 9*degC } } }
convection "unit" { surface = "left", film = 15, ambient = in_time { { 0*m, 5*degC } } }
convection "kelvin" { surface = "left", film = 15, ambient = in_time { { 0*s, 278*K } } }
convection "row" { surface = "left", film = 15, ambient = { 5*degC, 8*degC } }
convection "columns" { surface = "left", film = 15, ambient = { time = { 0, 1 }, air = { 5, 6 }, water = { 7, 8 } } }
convection "film" { surface = "left", ambient = 5*degC, film = 15, below = { {0*days, 5*m}, {9*days, 9*m} } }
gravity { z = function(t) return -9.81 end }
initial_temperature { value = in_time { { 0, 15 } } }
in_time(5)
