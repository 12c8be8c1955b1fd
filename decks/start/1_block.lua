-- A block of concrete standing on the ground: the smallest deck.
-- ashlar run 1_block.lua
model "block" {}
box "block" { from = { 0, 0, 0 }, to = { 2*m, 2*m, 10*m }, cells = { 2, 2, 10 } }
material "concrete" { region = "block", density = 2400*kg/m^3, young = 30*GPa, poisson = 0 }

-- Every box has the sides left, right, front, back, bottom and top; a surface gives one a name.
surface "foot" { of = "block", side = "bottom" }
fix "ground" { surface = "foot", x = 0, y = 0, z = 0 }
gravity { z = -9.81 }                        -- bare numbers are SI

stage "standing" { solve = static {} }

history "top"     { at = { 1*m, 1*m, 10*m }, record = { "displacement" } }
history "support" { surface = "foot", record = { "reaction" } }
-- By hand: settlement = density * g * height^2 / (2 * young); the ground carries the weight.
expect "settles"    { history = "top", component = "displacement.z", value = -2400 * 9.81 * 10^2 / (2 * 30e9) * m, relative = 1e-4 }
expect "is carried" { history = "support", component = "reaction.z", value = 2400 * 9.81 * 40 * N, relative = 1e-5 }
