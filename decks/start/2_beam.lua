-- A beam held at one end and pulled down at the other.
-- ashlar run 2_beam.lua --set cells=4
local args = deck.args {
  cells = { default = 2, range = { 1, 8 }, doc = "elements over the height" },
}
local length, height, young, shear = 10*m, 1*m, 30*GPa, 100*kPa

model "beam" {}
box "beam" { from = { 0, 0, 0 }, to = { length, 1*m, height }, cells = { 10 * args.cells, args.cells, args.cells } }
material "concrete" { region = "beam", density = 2400*kg/m^3, young = young, poisson = 0.2 }

surface "root" { of = "beam", side = "left" }
surface "tip"  { of = "beam", side = "right" }
fix "wall" { surface = "root", x = 0, y = 0, z = 0 }
-- A load may be a number or a function of the place, x, y and z in metres; this one is a parabola, as in a bent beam.
traction "pull" { surface = "tip", z = function(x, y, z)
  local share = z*m / height
  return -6 * shear * share * (1 - share)
end }

stage "bent" { solve = static { tolerance = 1e-7 } }

history "tip" { at = { length, 0.5*m, height / 2 }, record = { "displacement" } }
output "fields" { record = { "displacement", "stress" } }
picture "bent" { of = "stress.xx", deform = 100 }
-- Beam theory: F L^3 / (3 E I) = 13.3 mm. Straight elements of this kind are stiffer in bending: refine and watch it approach.
expect "nearly as beam theory" { history = "tip", component = "displacement.z", between = { -13.4*mm, -8*mm } }
