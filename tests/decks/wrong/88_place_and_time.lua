model "wall" {}
box "wall" { from = { 0, 0, 0 }, to = { 1, 1, 3 }, size = 0.5 }
material "concrete" { region = "wall", density = 2400, young = 30*GPa, poisson = 0.2 }
fix { surface = "wall.bottom", x = 0, y = 0, z = 0 }
water_pressure "flood" { surface = "wall.left", level = in_time(function(x, y, z, t) return z + t end) }
pressure "silt" { surface = "wall.left", value = in_time(function(z, t) return z * t end) }
pressure "ice" { surface = "wall.left", value = function(t, x, y, z) return t end }
initial_temperature { value = function(x, y, z, t) return 10 + t end }
convection "air" { surface = "wall.right", ambient = 10*degC, film = function(x, y, z, t) return 10 + t end }
stage "wave" { solve = dynamic { duration = 1*s } }
