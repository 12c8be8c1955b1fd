-- Case P10: NAFEMS LE11, a solid of cylinder, taper and sphere, warm as T = r + z between ends that cannot move apart.
-- Source: NAFEMS, Standard Benchmark Tests (LE11): s_zz(A) = -105 MPa at A = (1, 0, 0). Same mesh: an independent numpy
--         program, -103.543 (hex8), -93.107 (wedge6), -93.862 MPa (tet4). CalculiX 2.20, which takes the temperature of an
--         element's mean and not that of its Gauss points: C3D8 -107.3, C3D8I -105.1.
-- Accept: hex8 4 % of NAFEMS at the node, wedge6 and tet4 12 % on this mesh; 1e-4 of numpy.
-- Runs: elements=hex8 | elements=wedge6 | elements=tet4
local args = deck.args {
  elements = { default = "hex8", doc = "hex8, wedge6 or tet4" },
  n        = { default = 8, doc = "cells through the wall; 4 n along the profile, 2 n around" },
}
local n = math.tointeger(args.n)

-- The profile's two sides in (r, z), from t = 0 to 4: sphere, to the taper, taper to cylinder, cylinder.
local function arc(radius, degrees) return { radius * math.cos(math.rad(degrees)), radius * math.sin(math.rad(degrees)) } end
local function between(a, b, s) return { a[1] + (b[1] - a[1]) * s, a[2] + (b[2] - a[2]) * s } end
local corner = arc(1, 45)
local function inside(t) return t <= 2 and arc(1, 22.5 * t) or between(corner, { corner[1], 1.79 }, (t - 2) / 2) end
local outer = { arc(1.4, 30), { 1.1062, 1.045 }, { 1, 1.39 }, { 1, 1.79 } }
local function outside(t)
  if t <= 1 then return arc(1.4, 30 * t) end
  local side = math.min(math.floor(t), 3)
  return between(outer[side], outer[side + 1], t - side)
end
local function profile(s, t) return between(inside(t), outside(t), s) end

model "le11" { reference_temperature = 0*degC }
box "solid" {
  from = { 0, 0, 0 }, to = { 1, 4, math.pi / 2 }, cells = { n, 4 * n, 2 * n }, elements = args.elements,
  x = function(s, t, angle) return profile(s, t)[1] * math.cos(angle) end,
  y = function(s, t, angle) return -profile(s, t)[1] * math.sin(angle) end,
  z = function(s, t) return profile(s, t)[2] end,
}
material "steel" { region = "solid", young = 210*GPa, poisson = 0.3, density = 7850*kg/m^3, expansion = 2.3e-4/K }
surface "x" { of = "solid", plane = { { 0, 0, 0 }, { 1, 0, 0 } } }
surface "y" { of = "solid", plane = { { 0, 0, 0 }, { 0, 1, 0 } } }
surface "ends" { of = "solid", side = { "bottom", "top" } }
fix "symmetry" { surface = { "x", "y", "ends" }, normal = true }
temperature_field { value = function(x, y, z) return math.sqrt(x^2 + y^2) + z end }
stage "warm" { solve = static { tolerance = 1e-8 } }

history "A" { at = { 1, 0, 0 }, record = { "nodal_stress" } }
expect "axial stress at A, NAFEMS" {
  history = "A", component = "nodal_stress.zz", value = -105e6, relative = args.elements == "hex8" and 0.04 or 0.12,
}
if n == 8 then
  local numpy = { hex8 = -103.543e6, wedge6 = -93.107e6, tet4 = -93.862e6 }
  expect "axial stress at A, numpy" {
    history = "A", component = "nodal_stress.zz", value = numpy[args.elements], relative = 1e-4,
  }
end
