-- Case P6: cantilever of 10 x 1 x 1 m, every movement held at its root, a shear of 1e5 N spread as a parabola over its end.
-- Source: CalculiX 2.20 and an independent numpy program on the same meshes; Timoshenko's beam deflects by 13.428 mm.
-- Accept: 1e-4 of the deflection on the same mesh (ratios to Timoshenko are given to four digits).
-- Runs: cells=10 | cells=20 | cells=40 | cells=80 | cells=10 elements=wedge6 | cells=20 elements=wedge6 | cells=40 elements=wedge6 | cells=10 elements=tet4 | cells=20 elements=tet4 | cells=40 elements=tet4
local args = deck.args {
  cells    = { default = 10, doc = "elements along the beam; a tenth of them over its height and width" },
  elements = { default = "hex8", doc = "hex8, wedge6 or tet4" },
}
local across = math.max(1, args.cells // 10)
model "cantilever" {}
box "beam" {
  from = { 0, -0.5, -0.5 }, to = { 10, 0.5, 0.5 }, cells = { args.cells, across, across }, elements = args.elements,
}
material "concrete" { region = "beam", young = 30*GPa, poisson = 0.2, density = 2400*kg/m^3 }
surface "root" { of = "beam", side = "left" }
surface "end"  { of = "beam", side = "right" }
fix { surface = "root", x = 0, y = 0, z = 0 }
-- The reference spreads the shear over quads; on the one quad of the coarsest end that is a quarter for each corner.
if across == 1 then
  for _, y in ipairs { -0.5, 0.5 } do
    for _, z in ipairs { -0.5, 0.5 } do point_load { at = { 10, y, z }, z = -1e5 / 4 * N } end
  end
else
  traction { surface = "end", z = function(x, y, z) return -1e5 * 1.5 * (1 - 4 * z^2) end }
end
stage "bend" { solve = static { tolerance = 1e-9 } }
-- and looks at the middle of the end, or at that corner
history "tip" { at = across == 1 and { 10, -0.5, -0.5 } or { 10, 0, 0 }, record = { "displacement" } }
history "root" { surface = "root", record = { "reaction" } }
expect "shear" { history = "root", component = "reaction.z", value = 1e5*N, relative = 1e-6 }

local ratio = ({
  hex8   = { [10] = 0.6743, [20] = 0.8883, [40] = 0.9669, [80] = 0.9892 },
  wedge6 = { [10] = 0.7047, [20] = 0.8919, [40] = 0.9669 },
  tet4   = { [10] = 0.2442, [20] = 0.5417, [40] = 0.8158 },
})[args.elements][args.cells]
expect "deflection" { history = "tip", component = "displacement.z", value = -13.428*mm * ratio, relative = 2e-4 }
