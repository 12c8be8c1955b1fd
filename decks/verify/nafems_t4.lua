-- Case P26: NAFEMS T4, a plate of 0.6 x 1.0 m, bottom at 100 degC, left insulated, right and top in air of 0 degC.
-- Source: CalculiX 2.20 on the same meshes; NAFEMS gives 18.25 degC at (0.6, 0.2) for ever finer ones.
-- Accept: 1e-3 K on the same mesh.
-- Runs: cells=6 | cells=12 | cells=24 | cells=48
local args = deck.args { cells = { default = 6, doc = "elements over the width: 6, 12, 24 or 48" } }

model "nafems_t4" {}
box "plate" { from = { 0, 0, 0 }, to = { 0.6*m, 0.05*m, 1*m }, cells = { args.cells, 1, args.cells * 10 // 6 } }
material "metal" { region = "plate", young = 200*GPa, poisson = 0.3, density = 7850*kg/m^3, conductivity = 52*W/(m*K) }
surface "bottom" { of = "plate", side = "bottom" }
surface "air"    { of = "plate", side = { "right", "top" } }
fixed_temperature { surface = "bottom", value = 100*degC }
convection { surface = "air", ambient = 0*degC, film = 750*W/(m^2*K) }
stage "steady" { solve = thermal { steady = true } }

history "target" { at = { 0.6*m, 0, 0.2*m }, record = { "temperature" } }
expect "as CalculiX" {
  history = "target", component = "temperature", tolerance = 1e-3,
  value = ({ [6] = 17.954, [12] = 18.093, [24] = 18.214, [48] = 18.244 })[args.cells]*degC,
}
