-- Gravity dam of 100 m through a year: own weight, the temperature that its site gives it in the mean, then air, water
-- and the level of the reservoir with the seasons, marched together with the stress. Its joint on the rock may crack.
local args = deck.args {
  years = { default = 1, doc = "how long" },
  size  = { default = 6, unit = m, doc = "element size in the dam" },
  strength = { default = 0.5, unit = MPa, doc = "tensile strength of the joint, half of its cohesion" },
  every = { default = 365 / 24, unit = days, doc = "between two equilibria" },
}
local height, base, crest, slice = 100*m, 78*m, 14*m, 6*m

model "year" { reference_temperature = 10*degC }

extrude "dam" {
  section = { {0,0}, {base,0}, {crest,82*m}, {crest,height}, {0,height} }, length = slice, layers = 1, size = args.size,
}
extrude "rock" {
  section = { {-100*m,-100*m}, {base+100*m,-100*m}, {base+100*m,0}, {-100*m,0} }, length = slice, layers = 1,
  size = 2 * args.size,
}

surface "upstream"        { of = "dam",  facing = { -1, 0, 0 } }
surface "air"             { of = "dam",  facing = { 1, 0, 0.5 }, within = 60*deg }
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
joint "dam_base" {
  between = { "dam", "rock" }, law = "brittle", tensile_strength = args.strength, cohesion = 2 * args.strength,
  friction = 45*deg,
}

fix "base"    { surface = "bottom", x = 0, y = 0, z = 0 }
fix "rollers" { surface = "far_field", normal = true }
fix "plane_strain" { surface = "slice", normal = true }
gravity { z = -9.81 }

-- Time counts from the first moment of the year that is marched, the spring: +1 in summer, -1 in winter.
local function season(t) return math.sin(2 * math.pi * t / (365 * 86400)) end
local function yearly(mean, swing) return in_time(function(t) return mean + swing * season(t) end) end
water_pressure "reservoir" { surface = "upstream", level = yearly(85, -7) }

local film = 15*W/(m^2*K)
local function climate(air, water)
  return {
    convection { surface = { "air", "crest", "ground_downstream" }, ambient = air, film = film },
    convection { surface = "upstream", above = 85*m, ambient = air, film = film },
    fixed_temperature { surface = "upstream", below = 85*m, value = water },
    fixed_temperature { surface = "ground_upstream", value = water },
    fixed_temperature { surface = "bottom", value = 12*degC },
  }
end

stage "gravity" { solve = static {}, reset_displacement = true }
stage "mean"    { apply = climate(12*degC, 9*degC), solve = thermal { steady = true } }
stage "years"   { apply = climate(yearly(12, 14), yearly(9, 7)),
                  solve = coupled { duration = args.years * 365*days, every = args.every } }

history "crest" { at = { 0, 0, height }, record = { "displacement", "temperature" } }
history "face"  { at = { 50*m, 0, 35*m }, record = { "temperature", "stress" } }
history "water" { surface = "upstream", record = { "load" } }
output "fields" { record = { "displacement", "stress", "principal_stress", "temperature", "opening", "broken" }, at = "increment", every = 6 }

picture "temperature" { of = "temperature", stage = "years" }
picture "movement"    { of = "displacement", stage = "years", deform = 500 }

expect "the dam stands through the year" { that = function(result) return result.stage("years").converged end }
expect "the crest follows the seasons" { that = function(result)
  local x = result.history("crest").values("displacement.x", "years")
  local low, high = math.huge, -math.huge
  for _, value in ipairs(x) do low, high = math.min(low, value), math.max(high, value) end
  return high - low > 3e-3 and high - low < 60e-3, string.format("moves by %.1f mm", 1e3 * (high - low))
end }
