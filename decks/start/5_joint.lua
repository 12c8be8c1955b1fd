-- Two blocks, glued: pulled gently the joint holds, pulled harder it opens for good.
-- ashlar run 5_joint.lua
model "joint" { reference_temperature = 10*degC }
box "lower" { from = { 0, 0, 0 },   to = { 1*m, 1*m, 1*m }, cells = { 2, 2, 2 } }
box "upper" { from = { 0, 0, 1*m }, to = { 1*m, 1*m, 2*m }, cells = { 2, 2, 2 } }
material "concrete" {
  region = { "lower", "upper" }, density = 2400*kg/m^3, young = 30*GPa, poisson = 0,
  conductivity = 2.7*W/(m*K), expansion = 1e-5/K,
}
joint "glue" { between = { "lower", "upper" }, law = "brittle", tensile_strength = 2*MPa, cohesion = 3*MPa, friction = 40*deg }

-- Both ends are held, and the blocks cool: they want to shrink, and the joint has to give way.
surface "ends" { of = { "lower", "upper" }, side = { "bottom", "top" } }
surface "all"  { of = { "lower", "upper" } }
fix "ends" { surface = "ends", x = 0, y = 0, z = 0 }
stage "mild" { apply = { fixed_temperature { surface = "all", value = 10*degC } }, solve = thermal { steady = true } }
stage "cold" { apply = { fixed_temperature { surface = "all", value = -10*degC } }, solve = thermal { steady = true } }
stage "cooling" { solve = fracture { from = "mild", to = "cold", increments = 10 } }

output "fields" { record = { "displacement", "opening", "broken" } }
-- By hand: without the joint's own give, stress = young * expansion * cooling reaches 2 MPa at 6.7 K, a third of the way.
expect "opens after a third" { that = function(result)
  local cooling = result.stage("cooling")
  return cooling.cracks > 0 and math.abs(cooling.first_crack - 1/3) < 0.02, "first crack at load factor " .. cooling.first_crack
end }
