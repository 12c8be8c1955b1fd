model "column" {}
import_mesh { file = "truncated.msh" }
material "concrete" { region = "body", density = 2400*kg/m^3, young = 30*GPa, poisson = 0.2 }
fix "foot" { surface = "foot", x = 0, y = 0, z = 0 }
stage "gravity" { solve = static {} }
