-- Case P9: NAFEMS LE10, a quarter of a thick elliptic plate with an elliptic hole under 1 MPa on its top.
-- Source: NAFEMS, Standard Benchmark Tests (LE10): s_yy(D) = -5.38 MPa at D = (2, 0, 0.6) on the rim of the hole. wedge6 and
--         tet4: an independent numpy program on the same mesh, -5.0768 and -4.7975 MPa (CalculiX 2.20 on others of that
--         size: C3D8 -5.69, C3D8I -5.56, C3D6 -4.98, C3D4 -4.76).
-- Accept: 7 % of NAFEMS at the node (tet4 11 %, which lies too low on any such mesh); 1e-4 of numpy.
-- Runs: elements=hex8 | elements=wedge6 | elements=tet4
local args = deck.args {
  elements = { default = "hex8", doc = "hex8, wedge6 or tet4" },
  n        = { default = 8, doc = "cells over the thickness; 3 n across, 4 n around" },
}
local n, thick = math.tointeger(args.n), 0.6

model "le10" {}
-- Across r = 0 to 1 and around a = 0 to 1, from the hole's ellipse 2 x 1 to the rim's 3.25 x 2.75.
local function x(r, a) return (2 + 1.25 * r) * math.cos(a * math.pi / 2) end
local function y(r, a) return (1 + 1.75 * r) * math.sin(a * math.pi / 2) end
box "plate" {
  from = { 0, 0, 0 }, to = { 1, 1, thick }, cells = { 3 * n, 4 * n, n }, elements = args.elements, x = x, y = y,
}
-- The plate rests on the middle line of its rim: on bars that touch it along this line alone and do not move.
box "bars" {
  from = { 0, 0, 0 }, to = { 1, 1, 1 }, cells = { 1, 4 * n, 1 }, elements = args.elements,
  x = function(r, a, h) return x(1 + 0.05 * (r + h), a) end,
  y = function(r, a, h) return y(1 + 0.05 * (r + h), a) end,
  z = function(r, a, h) return thick / 2 + 0.1 * (h - r) end,
}
material "steel" { region = { "plate", "bars" }, young = 210*GPa, poisson = 0.3, density = 7850*kg/m^3 }
surface "x"    { of = "plate", plane = { { 0, 0, 0 }, { 1, 0, 0 } } }
surface "y"    { of = "plate", plane = { { 0, 0, 0 }, { 0, 1, 0 } } }
surface "top"  { of = "plate", side = "top" }
surface "bars" { of = "bars" }
surface "rim"  { of = "plate", facing = { 1, 1, 0 }, within = 50*deg }
fix "symmetry" { surface = { "x", "y" }, normal = true }
fix "rim" { surface = "rim", x = 0, y = 0 }
fix "bars" { surface = "bars", x = 0, y = 0, z = 0 }
pressure "top" { surface = "top", value = 1*MPa }
stage "pressure" { solve = static { tolerance = 1e-8 } }

history "D" { at = { 2, 0, thick }, record = { "nodal_stress" } }
expect "stress at D, NAFEMS" {
  history = "D", component = "nodal_stress.yy", value = -5.38e6, relative = args.elements == "tet4" and 0.11 or 0.07,
}
local numpy = { wedge6 = -5.0768e6, tet4 = -4.7975e6 }
if n == 8 and numpy[args.elements] then
  expect "stress at D, numpy" {
    history = "D", component = "nodal_stress.yy", value = numpy[args.elements], relative = 1e-4,
  }
end
