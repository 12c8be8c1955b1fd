model "wall" {}
box "wall" { from = { 0, 0, 0 }, to = { 1, 1, 3 }, size = 0.5 }
material "concrete" { region = "wall", density = 2400, young = 30*GPa, poisson = 0.2 }
surface "left" { of = "wall", side = "left" }
surface "bottom" { of = "wall", side = "bottom" }
fix { surface = "bottom", x = 0, y = 0, z = 0 }
water_pressure "flood" {
  surface = "left",
  level = { { 0*s, 0*m }, { 2*s, 3*m } },
}
stage "wave" { solve = dynamic { duration = 1*s } }
