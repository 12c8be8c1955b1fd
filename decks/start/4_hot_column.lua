-- Thermal strain: a column that is warmed grows if it may, and presses if it may not.
-- ashlar run 4_hot_column.lua
local young, expansion, warming = 30*GPa, 1e-5/K, 20*K

model "column" { reference_temperature = 10*degC }
box "column" { from = { 0, 0, 0 }, to = { 1*m, 1*m, 5*m }, cells = { 2, 2, 10 } }
material "concrete" { region = "column", density = 2400*kg/m^3, young = young, poisson = 0, expansion = expansion }

surface "foot" { of = "column", side = "bottom" }
surface "head" { of = "column", side = "top" }
fix "foot" { surface = "foot", x = 0, y = 0, z = 0 }
temperature_field { value = 10*degC + warming }     -- given, not solved for; a function of x, y, z would do too

stage "free" { solve = static {} }
stage "held" { apply = { displacement { surface = "head", z = 0 } }, solve = static {} }

history "head"   { at = { 0.5*m, 0.5*m, 5*m }, record = { "displacement" } }
history "middle" { at = { 0.5*m, 0.5*m, 2.5*m }, record = { "stress" } }
expect "grows"   { history = "head", component = "displacement.z", stage = "free", value = expansion * warming * 5*m, relative = 1e-3 }
expect "presses" { history = "middle", component = "stress.zz", stage = "held", value = -young * expansion * warming, relative = 1e-3 }
