-- Case P7: thick sphere, radii 1 and 2, 1 MPa inside; an octant of three patches of n x n x n elements.
-- Source: closed form (Lame): u_r(a) = 4.0e-6, u_r(b) = 1.5e-6, s_t(a) = 0.7143 MPa. CalculiX 2.20, C3D8 on the same
--         meshes: u_r(a) 0.9684 (n = 4) and 0.9917 (n = 8) of it.
-- Accept: 1e-4 of the closed form from CalculiX, which prints no more; from the closed form 4 % (n = 4) and 1 % (n = 8) in u_r.
-- Runs: elements=hex8 n=4 | elements=hex8 n=8 | elements=wedge6 n=4 | elements=wedge6 n=8
local args = deck.args {
  elements = { default = "hex8", doc = "hex8 or wedge6" },
  n        = { default = 8, doc = "4 or 8 elements along each side (tests/data/verify_curved_meshes.py)" },
}
local n = math.tointeger(args.n)

model "sphere" {}
import_mesh { file = "sphere_" .. n .. "_" .. args.elements .. ".msh" }
material "steel" { region = "body", young = 200*GPa, poisson = 0.3, density = 7850*kg/m^3 }
surface "x" { of = "body", plane = { { 0, 0, 0 }, { 1, 0, 0 } } }
surface "y" { of = "body", plane = { { 0, 0, 0 }, { 0, 1, 0 } } }
surface "z" { of = "body", plane = { { 0, 0, 0 }, { 0, 0, 1 } } }
fix "symmetry" { surface = { "x", "y", "z" }, normal = true }
-- Along the radius, which on flat facets is not their normal.
local function ray(axis)
  return function(...) return 1e6 * select(axis, ...) / math.sqrt((...)^2 + select(2, ...)^2 + select(3, ...)^2) end
end
traction "inside" { surface = "inner", x = ray(1), y = ray(2), z = ray(3) }
stage "pressure" { solve = static { tolerance = 1e-9 } }

history "inner" { at = { 1, 0, 0 }, record = { "displacement", "stress" } }
history "outer" { at = { 2, 0, 0 }, record = { "displacement" } }
local off = n == 4 and 0.04 or 0.01
expect "widening inside, closed form" { history = "inner", component = "displacement.x", value = 4e-6, relative = off }
expect "widening outside, closed form" { history = "outer", component = "displacement.x", value = 1.5e-6, relative = off }
if args.elements == "hex8" then
  expect "widening inside, CalculiX" {
    history = "inner", component = "displacement.x", value = (n == 4 and 0.9684 or 0.9917) * 4e-6, tolerance = 4e-10,
  }
end
