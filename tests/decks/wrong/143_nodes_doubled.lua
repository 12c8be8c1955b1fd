model "imported" {}
import_mesh { file = "mesh_nodes_doubled.msh" }
material "rock" { region = "bar", density = 2600*kg/m^3, young = 30*GPa, poisson = 0.2 }
stage "rest" { solve = static {} }
