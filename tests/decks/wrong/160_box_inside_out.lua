model "arch" {}
box "arch" {
  from = { 0, 0, 0 }, to = { 1.5, 10*m, 20*m }, cells = { 6, 2, 4 },
  x = function(angle, r, z) return (100 + r) * math.cos(angle) end,
  y = function(angle, r, z) return (100 + r) * math.sin(angle) end,
}
material "concrete" { region = "arch", density = 2400*kg/m^3, young = 30*GPa, poisson = 0.2 }
surface "foot" { of = "arch", side = "bottom" }
fix { surface = "foot", x = 0, y = 0, z = 0 }
gravity { z = -9.81 }
stage "gravity" { solve = static {} }
