model "wrong" {}
box "under" { from = {0,0,0}, to = {1,1,1}, cells = {1,1,1} }
box "over" { from = {0,0,1}, to = {1,1,2}, cells = {1,1,1} }
box "top" { from = {0,0,2}, to = {1,1,3}, cells = {1,1,1} }
material "rock" { region = { "under", "over", "top" }, density = 2400*kg/m^3, young = 30*GPa, poisson = 0.2 }
joint "glued" { between = { "under", "over" }, law = "elastic" }
joint "tough" {
  between = { "over", "top" }, law = "softening", tensile_strength = 1*MPa, cohesion = 2*MPa, fracture_energy = 100*J/m^2,
}
fix { surface = "under.bottom", x = 0, y = 0, z = 0 }
grouting { of = { "glued", "tough" } }
grouting { of = "tugh" }
stage "fill" { solve = static {} }
