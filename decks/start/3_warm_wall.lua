-- Heat through a wall of 3 m: summer air on one side, water on the other.
-- ashlar run 3_warm_wall.lua
model "wall" { reference_temperature = 15*degC }
box "wall" { from = { 0, 0, 0 }, to = { 3*m, 1*m, 1*m }, cells = { 12, 1, 1 } }
material "concrete" {
  region = "wall", density = 2400*kg/m^3, young = 30*GPa, poisson = 0.2,
  conductivity = 2.7*W/(m*K), heat_capacity = 960*J/(kg*K),
}

surface "dry" { of = "wall", side = "left" }
surface "wet" { of = "wall", side = "right" }
-- Conditions given inside `apply` act from that stage on; a surface without any is insulated.
stage "ten days" {
  apply = {
    convection        { surface = "dry", ambient = 28.2*degC, film = 15*W/(m^2*K) },
    fixed_temperature { surface = "wet", value = 19.5*degC },
  },
  solve = thermal { duration = 10*days },
}
stage "in the end" { solve = thermal { steady = true } }   -- the same conditions, for ever

history "dry face" { at = { 0, 0.5*m, 0.5*m }, record = { "temperature" } }
history "core"     { at = { 1.5*m, 0.5*m, 0.5*m }, record = { "temperature" } }
-- By hand, steady: the heat q = (28.2 - 19.5) / (1/15 + 3/2.7) flows through film and wall alike.
local q = (28.2 - 19.5) / (1/15 + 3/2.7)
expect "dry face" { history = "dry face", component = "temperature", stage = "in the end", value = (28.2 - q/15)*degC, tolerance = 0.001*K }
expect "core is slower" { history = "core", component = "temperature", stage = "ten days", between = { 15*degC, 22*degC } }
