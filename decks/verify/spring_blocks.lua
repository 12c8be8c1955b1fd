-- Case discrete springs: the paper's discrete spring model, nearly rigid blocks that interact by springs only, whose stiffness
--   follows from E and nu: a body of bricks pulled along its rows and sheared, or a body of irregular tetrahedra pulled.
-- Source: bricks: closed form, n - 1 layers of springs and n of blocks in a row; E along the rows, no lateral strain, shear modulus
--   E / (2 (1 + nu)) far from the faces, which keep blocks from turning. Tetrahedra: E and nu where all blocks strain alike (Cusatis et al. 2011); measured
--   here: 32.3 GPa and 0.000 for 0, 30.6 and 0.117 for 0.1, 27.2 and 0.200 for 0.15, 19.4 and 0.315 for 0.2.
-- Accept: bricks 0.1 %, shear in the middle 25 % with 8 blocks across and 12 % with 16; tetrahedra 10 % of E and 0.03 in nu up to 0.1.
-- Runs: blocks=bricks | blocks=bricks size=0.0625 | blocks=bricks size=0.25 rigidity=50 | blocks=irregular poisson=0 |
--   blocks=irregular poisson=0.1
local args = deck.args {
  blocks   = { default = "bricks", doc = "bricks (hex8) or irregular (tet4)" },
  size     = { default = 0.125, doc = "edge of the blocks, m" },
  poisson  = { default = 0.2, doc = "at most 0.15 for irregular blocks" },
  rigidity = { default = 10, doc = "of blocks, over the body" },
}
local young, poisson, bricks, move = 30e9, args.poisson, args.blocks == "bricks", 1e-4
local n, h = math.floor(1 / args.size + 0.5), args.size
local regions = { "pulled" }

model "spring_blocks" {}
if bricks then
  box "pulled" { from = { 0, 0, 0 }, to = { 1, 1, 1 }, cells = { n, n, n } }
  box "sheared" { from = { 2, 0, 0 }, to = { 3, 1, 1 }, cells = { n, n, n } }
  regions[2] = "sheared"
  surface "around" { of = "sheared" }
  displacement { surface = "around", x = function(x, y, z) return move * z end, y = 0*m, z = 0*m }
  history "shear" { at = { 2.5 + h / 2, 0.5 + h / 2, 0.5 + h / 2 }, record = { "stress" } }
else
  solid "pulled" { file = "solid_cube.stl", size = args.size }
end
material "blocks" {
  region = regions, law = "discrete_spring", density = 2400*kg/m^3, young = young*Pa, poisson = poisson,
  packing = args.blocks, rigidity = args.rigidity,
}
crackable "springs" { region = regions, law = "elastic" }
fix { surface = "pulled.bottom", z = 0 }
fix { surface = "pulled.left", x = 0 }
fix { surface = "pulled.front", y = 0 }
displacement { surface = "pulled.top", z = move*m }
stage "move" { solve = static { tolerance = 1e-7 } }
history "pull" { surface = "pulled.top", record = { "reaction" } }
local places = {}
for _, y in ipairs { 0.2, 0.35, 0.5, 0.65, 0.8 } do
  for _, z in ipairs { 0.2, 0.35, 0.5, 0.65, 0.8 } do
    places[#places + 1] = string.format("side %g %g", y, z)
    history(places[#places]) { at = { 1, y, z }, record = { "displacement" } }
  end
end

if bricks then
  local block = args.rigidity * young
  local pulled = move / ((n - 1) / n * (1 / young - 1 / block) + 1 / block)
  expect "young" { history = "pull", component = "reaction.z", value = pulled*N, relative = 1e-3 }
  expect "no lateral strain" { history = "side 0.5 0.5", component = "displacement.x", value = 0, tolerance = 1e-9*m }
  if n >= 8 then
    local shear = young / (2 * (1 + poisson)) * move
    expect "shear" { history = "shear", component = "stress.zx", value = shear*Pa, relative = 2 * h }
  end
else
  expect "young" { that = function(result)
    local found = result.history("pull").at("reaction.z") / move
    return math.abs(found / young - 1) < 0.1, string.format("%.4g GPa, given %.4g GPa", found / 1e9, young / 1e9)
  end }
  expect "poisson" { that = function(result)
    local mean = 0
    for _, place in ipairs(places) do mean = mean - result.history(place).at("displacement.x") / move / #places end
    return math.abs(mean - poisson) < 0.03, string.format("%.3f, given %.3f", mean, poisson)
  end }
end
