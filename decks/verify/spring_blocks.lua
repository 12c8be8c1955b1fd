-- Case discrete springs: the paper's discrete spring model: blocks so stiff that only the springs between them give way. A
--   region of bricks of h behaves as an elastic body of young = k_n h, shear modulus k_s h and no lateral strain.
-- Source: closed form: springs and blocks in series, length / E = layers h / (k_n h) + length / E_block; shear k_s area.
-- Accept: 0.1 %.
-- Runs: size=0.5 | size=0.25
local args = deck.args { size = { default = 0.5, doc = "edge of the blocks, m" } }
local young, poisson, stiffer = 30e9, 0.2, 50
local shear = young / (2 * (1 + poisson))
local n = math.floor(1 / args.size + 0.5)

model "spring_blocks" {}
local h = args.size
box "pulled" { from = { 0, 0, 0 }, to = { 1, 1, 1 }, cells = { n, n, n } }
box "sheared" { from = { 2, 0, 0 }, to = { 2 + h, h, 2 * h }, cells = { 1, 1, 2 } }
local around = { "left", "right", "front", "back", "bottom", "top" }
surface "held" { of = "sheared", side = around, box = { { 1.9, -1, -1 }, { 4, 4, 0.9 * h } } }
surface "moved" { of = "sheared", side = around, box = { { 1.9, -1, 1.1 * h }, { 4, 4, 4 } } }
material "blocks" {
  region = { "pulled", "sheared" }, density = 2400*kg/m^3, young = stiffer * young*Pa, poisson = 0,
}
crackable "springs" {
  region = { "pulled", "sheared" }, law = "elastic",
  normal_stiffness = young / h*Pa/m, shear_stiffness = shear / h*Pa/m,
}
fix { surface = { "pulled.bottom", "held" }, x = 0, y = 0, z = 0 }
history "pull" { surface = "pulled.top", record = { "reaction" } }
history "side" { at = { 1, 1, 0.5 }, record = { "displacement" } }
history "shear" { surface = "moved", record = { "reaction" } }
stage "move" {
  apply = {
    displacement { surface = "pulled.top", z = 0.1*mm },
    displacement { surface = "moved", x = 0.1*mm, y = 0*m, z = 0*m },
  },
  solve = static { tolerance = 1e-9 },
}
local layers = (n - 1) / n  -- of springs to a layer of blocks
local pulled = 1e-4 / (layers / young + 1 / (stiffer * young))
expect "young" { history = "pull", component = "reaction.z", value = pulled*N, relative = 1e-3 }
expect "no lateral strain" { history = "side", component = "displacement.x", value = 0, tolerance = 1e-9*m }
expect "shear" { history = "shear", component = "reaction.x", value = shear * 1e-4 / h * h^2*N, relative = 1e-3 }
