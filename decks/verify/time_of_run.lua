-- Case time of the run: static stages see a pressure and a water level as the time reached says.
-- Source: by hand. Column of 10 m: shortening p L / E; level h beside a wall: force rho g h^2 / 2.
-- Accept: 1e-6.
-- Runs: damping=adaptive | damping=local
local args = deck.args { damping = { default = "adaptive", doc = "of the static stages" } }

model "time_of_the_run" { reference_temperature = 10*degC }
box "column" { from = { 0, 0, 0 }, to = { 1*m, 1*m, 10*m }, cells = { 1, 1, 10 } }
material "concrete" {
  region = "column", young = 20*GPa, poisson = 0, density = 2400*kg/m^3,
  conductivity = 2.5*W/(m*K), heat_capacity = 960*J/(kg*K),
}
surface "bottom" { of = "column", side = "bottom" }
surface "top"    { of = "column", side = "top" }
surface "left"   { of = "column", side = "left" }
fix { surface = "bottom", x = 0, y = 0, z = 0 }
pressure { surface = "top", value = { { 0*days, 0*MPa }, { 30*days, 3*MPa }, { 60*days, 1*MPa } } }
water_pressure { surface = "left", level = in_time({ 0*days, 45*days }, { 0*m, 9*m }) }

local days_reached = { start = 0, ["month 1"] = 30, ["month 2"] = 45, ["month 9"] = 270 }
local pressures = { start = 0, ["month 1"] = 3e6, ["month 2"] = 2e6, ["month 9"] = 1e6 }
stage "start"   { solve = static { damping = args.damping, tolerance = 1e-8 } }
stage "heat 1"  { solve = thermal { duration = 30*days } }
stage "month 1" { solve = static { damping = args.damping, tolerance = 1e-8 } }
stage "heat 2"  { solve = thermal { duration = 15*days } }
stage "month 2" { solve = static { damping = args.damping, tolerance = 1e-8 } }
stage "heat 3"  { solve = thermal { duration = 225*days } }
stage "month 9" { solve = static { damping = args.damping, tolerance = 1e-8 } }

history "top"  { at = { 0.5*m, 0.5*m, 10*m }, record = { "displacement" } }
history "left" { surface = "left", record = { "load" } }
for stage, reached in pairs(days_reached) do
  local level = 9 * math.min(reached / 45, 1)
  expect("pressure " .. stage) {
    history = "top", component = "displacement.z", stage = stage, value = -pressures[stage] * 10 / 20e9*m,
    tolerance = 1.5e-9*m,
  }
  expect("water " .. stage) {
    history = "left", component = "load.x", stage = stage, value = 1000 * 9.81 * level^2 / 2*N, tolerance = 1e-6 * 397305*N,
  }
end
