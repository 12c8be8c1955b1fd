-- Case P26: NAFEMS T4, a plate of 0.6 x 1.0 m, bottom at 100 degC, left insulated, right and top in air of 0 degC.
-- Source: on the same meshes CalculiX 2.20 (hex8), an independent numpy program (wedge6, tet4); NAFEMS gives 18.25 degC at (0.6, 0.2) for ever finer ones.
-- Accept: 1e-3 K on the same mesh.
-- Runs: cells=6 | cells=12 | cells=24 | cells=48 | elements=wedge6 cells=6 | elements=wedge6 cells=12 | elements=wedge6 cells=24 | elements=wedge6 cells=48 | elements=tet4 cells=6 | elements=tet4 cells=12 | elements=tet4 cells=24 | elements=tet4 cells=48
local args = deck.args {
  elements = { default = "hex8", doc = "hex8, wedge6 or tet4" },
  cells    = { default = 6, doc = "cells over the width: 6, 12, 24 or 48" },
}

model "nafems_t4" {}
box "plate" { from = { 0, 0, 0 }, to = { 0.6*m, 0.05*m, 1*m }, cells = { args.cells, 1, args.cells * 10 // 6 }, elements = args.elements }
material "metal" { region = "plate", young = 200*GPa, poisson = 0.3, density = 7850*kg/m^3, conductivity = 52*W/(m*K) }
surface "bottom" { of = "plate", side = "bottom" }
surface "air"    { of = "plate", side = { "right", "top" } }
fixed_temperature { surface = "bottom", value = 100*degC }
convection { surface = "air", ambient = 0*degC, film = 750*W/(m^2*K) }
stage "steady" { solve = thermal { steady = true } }

history "target" { at = { 0.6*m, 0, 0.2*m }, record = { "temperature" } }
expect(args.elements == "hex8" and "as CalculiX" or "as numpy") {
  history = "target", component = "temperature", tolerance = 1e-3,
  value = ({
    hex8   = { [6] = 17.954, [12] = 18.093, [24] = 18.214, [48] = 18.244 },
    wedge6 = { [6] = 18.0584, [12] = 18.0039, [24] = 18.1514, [48] = 18.2099 },
    tet4   = { [6] = 17.3846, [12] = 18.0865, [24] = 18.2435, [48] = 18.2653 },
  })[args.elements][args.cells]*degC,
}
