-- Case P8: circular hole in a plate under tension along x, plane strain; one quarter with the exact tractions on its outer edges.
-- Source: G. Kirsch 1898 (Timoshenko and Goodier, Theory of Elasticity): s_xx(0,a) = 3 S, s_zz(a,0) = -S, u_x(a,0) = 3 S a (1 - nu^2) / E.
-- Accept: 1.5 % of the stresses, 0.2 % of the displacement.
-- Runs: elements=hex8 | elements=wedge6 | elements=tet4
-- The quarter has five sides, one of them an arc: meshed free, fine at the short chords of the arc.
local args = deck.args {
  elements = { default = "hex8", doc = "hex8, wedge6 or tet4" },
  pieces   = { default = 256, doc = "elements along the quarter circle" },
}
local a, side, young, poisson, tension = 1, 5, 20e9, 0.2, 1e6

model "kirsch" {}
-- A chord has two hex8, halves of the sides of triangles, or one wedge6 or tet4.
local chords = args.elements == "hex8" and args.pieces // 2 or args.pieces
local section = { { side, 0 }, { side, side }, { 0, side } }
for i = 0, chords do
  local angle = math.pi / 2 * (1 - i / chords)
  section[#section + 1] = { a * math.cos(angle), a * math.sin(angle) }
end
section[4][1], section[#section][2] = 0, 0  -- cos and sin of a right angle are not quite 0
extrude "plate" {
  section = section, length = 0.1, layers = 1, size = 0.25, grow = 1.08, structured = false, elements = args.elements,
}

material "steel" { region = "plate", young = young*Pa, poisson = poisson, density = 2400*kg/m^3 }

--- Stresses xx, zz, xz of the infinite plate at (x, z).
local function stress(x, z)
  local q, angle = a^2 / (x^2 + z^2), math.atan(z, x)
  local c, s = math.cos(2 * angle), math.sin(2 * angle)
  local rr = tension / 2 * (1 - q + (1 - 4 * q + 3 * q^2) * c)
  local tt = tension / 2 * (1 + q - (1 + 3 * q^2) * c)
  local rt = -tension / 2 * (1 + 2 * q - 3 * q^2) * s
  local mean, half = (rr + tt) / 2, (rr - tt) / 2
  return mean + half * c - rt * s, mean - half * c + rt * s, half * s + rt * c
end
surface "left"   { of = "plate", plane = { { 0, 0, 0 }, { 1, 0, 0 } } }
surface "bottom" { of = "plate", plane = { { 0, 0, 0 }, { 0, 0, 1 } } }
surface "right"  { of = "plate", side = "right", plane = { { side, 0, 0 }, { 1, 0, 0 } } }
surface "top"    { of = "plate", side = "top", plane = { { 0, 0, side }, { 0, 0, 1 } } }
surface "slice"  { of = "plate", side = { "front", "back" } }
fix "symmetry" { surface = { "left", "bottom", "slice" }, normal = true }
traction "right" {
  surface = "right",
  x = function(x, y, z) return (select(1, stress(x, z))) end, z = function(x, y, z) return (select(3, stress(x, z))) end,
}
traction "top" {
  surface = "top",
  x = function(x, y, z) return (select(3, stress(x, z))) end, z = function(x, y, z) return (select(2, stress(x, z))) end,
}

stage "pull" { solve = static { tolerance = 1e-8 } }

history "crown"  { at = { 0, 0, a }, record = { "stress" } }
history "spring" { at = { a, 0, 0 }, record = { "stress", "displacement" } }
expect "three times the tension at the crown" { history = "crown", component = "stress.xx", value = 3 * tension, relative = 0.015 }
expect "the tension as pressure at the side" { history = "spring", component = "stress.zz", value = -tension, relative = 0.015 }
expect "movement of the side" {
  history = "spring", component = "displacement.x", value = 3 * tension * a * (1 - poisson^2) / young, relative = 0.002,
}
