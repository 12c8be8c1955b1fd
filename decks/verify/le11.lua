-- Case P10: NAFEMS LE11, a solid of cylinder, taper and sphere, warm as T = r + z between ends that cannot move apart.
-- Source: NAFEMS, Standard Benchmark Tests (LE11): s_zz(A) = -105 MPa at A = (1, 0, 0). CalculiX 2.20, C3D8 on the same mesh: -108.2.
-- Accept: 4 %.
-- Runs: elements=hex8 | elements=wedge6
local args = deck.args { elements = { default = "hex8", doc = "hex8 or wedge6 (tests/data/verify_curved_meshes.py)" } }

model "le11" {}
import_mesh { file = "le11_" .. args.elements .. ".msh" }
material "steel" { region = "body", young = 210*GPa, poisson = 0.3, density = 7850*kg/m^3, expansion = 2.3e-4/K }
surface "x"    { of = "body", plane = { { 0, 0, 0 }, { 1, 0, 0 } } }
surface "y"    { of = "body", plane = { { 0, 0, 0 }, { 0, 1, 0 } } }
surface "ends" { of = "body", side = { "bottom", "top" } }
fix "symmetry" { surface = { "x", "y", "ends" }, normal = true }
temperature_field { value = function(x, y, z) return math.sqrt(x^2 + y^2) + z end }
stage "warm" { solve = static { tolerance = 1e-8 } }

history "A" { at = { 1, 0, 0 }, record = { "stress" } }
expect "axial stress at A" { history = "A", component = "stress.zz", value = -105e6, relative = 0.04 }
