model "block" {}
box "block" { from = {0,0,1*m}, to = {1*m,1*m,2*m}, cells = {1,1,1} }
material "rock" { region = "block", density = 2600*kg/m^3, young = 30*GPa, poisson = 0.2 }
stage "fall" { solve = dynamic { duration = 1*s, large_displacement = true,
  stiffness_damping = 1e-4*s } }
stage "swing" { solve = dynamic { duration = 1*s, contact_damping = 1e-4*s } }
