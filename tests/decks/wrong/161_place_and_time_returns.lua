model "wall" {}
box "wall" { from = { 0, 0, 0 }, to = { 1, 1, 3 }, size = 0.5 }
material "concrete" { region = "wall", density = 2400, young = 30*GPa, poisson = 0.2 }
fix { surface = "wall.bottom", x = 0, y = 0, z = 0 }
pressure "silt" { surface = "wall.left", value = function(x, y, z, t) return t < 0.5 and 1000 or nil end }
pressure "ice" { surface = "wall.right", value = function(x, y, z, t) return (t*s) * (z*m) end }
stage "wave" { solve = dynamic { duration = 1*s } }
