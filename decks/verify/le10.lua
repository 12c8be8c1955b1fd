-- Case P9: NAFEMS LE10, a quarter of a thick elliptic plate with an elliptic hole under 1 MPa on its top.
-- Source: NAFEMS, Standard Benchmark Tests (LE10): s_yy(D) = -5.38 MPa at D = (2, 0, 0.6).
-- Accept: 7 %; the mesh is 12 x 16 x 4, finer towards D.
-- Runs: elements=hex8 | elements=wedge6
local args = deck.args { elements = { default = "hex8", doc = "hex8 or wedge6 (tests/data/verify_curved_meshes.py)" } }

model "le10" {}
import_mesh { file = "le10_" .. args.elements .. ".msh" }
material "steel" { region = { "body", "holder" }, young = 210*GPa, poisson = 0.3, density = 7850*kg/m^3 }
surface "x" { of = "body", plane = { { 0, 0, 0 }, { 1, 0, 0 } } }
surface "y" { of = "body", plane = { { 0, 0, 0 }, { 0, 1, 0 } } }
fix "symmetry" { surface = { "x", "y" }, normal = true }
fix "rim" { surface = "rim", x = 0, y = 0 }
-- The middle line of the rim rests on wedges that touch it nowhere else and do not move.
fix "knife" { surface = "knife", x = 0, y = 0, z = 0 }
pressure "top" { surface = "top", value = 1*MPa }
stage "pressure" { solve = static { tolerance = 1e-8 } }

history "D" { at = { 2, 0, 0.6 }, record = { "stress", "displacement" } }
expect "stress at D" { history = "D", component = "stress.yy", value = -5.38e6, relative = 0.07 }
