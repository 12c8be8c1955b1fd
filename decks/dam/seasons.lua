-- Gravity dam of 100 m: own weight and reservoir, summer, winter, and the cracks that the cooling between them opens.
-- Temperatures: "Accelerating the explicit CDEM by GPU", Table 2 (air, water, ground).
local args = deck.args {
  water    = { default = 92, unit = m, doc = "reservoir level above the base" },
  strength = { default = 2,  unit = MPa, doc = "tensile strength of the concrete" },
  fine     = { default = 1, doc = "elements along the edge of one of the plain mesh" },
}
local height, base, crest, slice = 100*m, 78*m, 14*m, 5*m

model "seasons" { reference_temperature = 10*degC }

extrude "dam" {
  section = { {0,0}, {base,0}, {crest,82*m}, {crest,height}, {0,height} }, length = slice,
  size = 5*m / args.fine, layers = args.fine,
  divisions = { [1] = 12 * args.fine, [2] = 36 * args.fine },   -- along the base and up the downstream face: no block much longer than high
}
extrude "rock" {
  section = { {-100*m,-100*m}, {base+100*m,-100*m}, {base+100*m,0}, {-100*m,0} }, length = slice,
  size = 10*m / args.fine, layers = args.fine,
}

surface "upstream"        { of = "dam",  facing = { -1, 0, 0 } }
surface "downstream"      { of = "dam",  facing = { 1, 0, 0.5 }, within = 60*deg }
surface "crest"           { of = "dam",  side = "top" }
surface "ground_upstream"   { of = "rock", side = "top", box = { {-101*m,-1*m,-1*m}, {0,slice+1*m,1*m} } }
surface "ground_downstream" { of = "rock", side = "top", box = { {base,-1*m,-1*m}, {base+101*m,slice+1*m,1*m} } }
surface "bottom"          { of = "rock", side = "bottom" }
surface "far_field"       { of = "rock", side = { "left", "right" } }
surface "slice"           { of = { "dam", "rock" }, side = { "front", "back" } }

material "concrete" {
  region = "dam", density = 2400*kg/m^3, young = 25*GPa, poisson = 0.2,
  conductivity = 2.7*W/(m*K), heat_capacity = 960*J/(kg*K), expansion = 1e-5/K,
}
material "granite" {
  region = "rock", density = 2650*kg/m^3, young = 30*GPa, poisson = 0.25,
  conductivity = 3.0*W/(m*K), heat_capacity = 850*J/(kg*K), expansion = 0.8e-5/K,
}
crackable "body"  { region = "dam", law = "brittle", tensile_strength = args.strength, cohesion = 3*MPa, friction = 45*deg }
joint "dam_base"  { between = { "dam", "rock" }, law = "brittle", tensile_strength = 1*MPa, cohesion = 2*MPa, friction = 45*deg }

fix "base"    { surface = "bottom", x = 0, y = 0, z = 0 }
fix "rollers" { surface = "far_field", normal = true }
fix "plane_strain" { surface = "slice", normal = true }
gravity { z = -9.81 }
water_pressure "reservoir" { surface = "upstream", level = args.water }

local function climate(air, water, ground)
  local film = 15*W/(m^2*K)
  return {
    convection { surface = { "downstream", "crest", "ground_downstream" }, ambient = air, film = film },
    convection { surface = "upstream", above = args.water, ambient = air, film = film },
    fixed_temperature { surface = "upstream", below = args.water, value = water },
    fixed_temperature { surface = "ground_upstream", value = water },
    fixed_temperature { surface = "bottom", value = ground },
  }
end

stage "gravity"  { solve = static { tolerance = 1e-6 }, reset_displacement = true }
stage "summer"   { apply = climate(28.2*degC, 19.5*degC, 32.4*degC), solve = thermal { steady = true } }
stage "winter"   { apply = climate(-1.6*degC, 2.8*degC, 10.3*degC), solve = thermal { steady = true } }
stage "fracture" { solve = fracture { from = "summer", to = "winter", increments = 10, tolerance = 1e-5 } }

history "crest" { at = { 0, 0, height }, record = { "displacement", "temperature" } }
history "base"  { surface = "bottom", record = { "reaction" } }
output "fields" { record = { "displacement", "stress", "principal_stress", "temperature", "opening", "slip", "broken" } }

picture "gravity"        { of = "displacement", stage = "gravity", deform = 500 }
picture "summer"         { of = "temperature", stage = "summer" }
picture "winter"         { of = "temperature", stage = "winter" }
picture "cracks"         { of = "broken", stage = "fracture", deform = 200 }

expect "the reservoir pushes the crest downstream" {
  history = "crest", component = "displacement.x", stage = "gravity", between = { 1*mm, 60*mm },
}
expect "the dam still stands" { that = function(result) return result.stage("fracture").converged end }
