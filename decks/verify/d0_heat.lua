-- Case D0 heat: temperature of the dam in summer and winter, steady or after 100 days from 15 degC.
-- Source: CalculiX 2.20 (steady) and a lumped explicit numpy program (100 days); CalculiX's own 100 days have consistent
--         capacity.
-- Accept: steady 0.005 K; 100 days 0.1 K against the lumped program, 0.3 K against CalculiX.
-- Runs: season=summer | season=winter | season=summer fine=true | season=winter fine=true | season=summer fine=true transient=true | season=winter fine=true transient=true
local args = deck.args {
  season    = { default = "summer", doc = "summer or winter" },
  fine      = { default = false, doc = "half the element size" },
  transient = { default = false, doc = "100 days instead of the steady state" },
}
local d0 = require "d0"
model "d0_heat" { reference_temperature = 15*degC }
d0.body(args.fine and "r2_ny1" or "r1_ny1")
stage(args.season) {
  apply = d0.climate(d0.season[args.season]),
  solve = args.transient and thermal { duration = 100*days } or thermal { steady = true },
}

local places = {
  { "crest, middle", 4, 60 }, { "crest, downstream", 8, 60 }, { "downstream face", 28, 25 }, { "core", 14, 25 },
  { "base", 24, 0 }, { "toe", 48, 0 }, { "neck", 4, 50 }, { "far ground", 108, 0 }, { "foundation", 24, -30 },
}
local steady = {
  summer = { { 28.0791, 28.19296, 28.15599, 24.52747, 26.05893, 28.19908, 23.68098, 28.2134, 28.64831 },
             { 28.12579, 28.19608, 28.15518, 24.54143, 26.08259, 28.19881, 23.69836, 28.21338, 28.6777 } },
  winter = { { -1.538854, -1.596436, -1.570579, 0.4422764, 1.646247, -1.518099, 0.6852004, -1.559834, 5.710119 },
             { -1.562468, -1.598018, -1.56921, 0.4544432, 1.652261, -1.50623, 0.6771585, -1.559797, 5.722897 } },
}
local hundred_days = {  -- the mesh with half the element size: lumped, CalculiX
  summer = { { 28.03777, 28.18932, 27.78865, 15.23358, 15.00365, 27.56808, 20.58894, 27.83566, 15.00010 },
             { 28.02794, 28.18912, 27.78148, 15.13355, 15.00156, 27.49844, 20.57978, 27.7826, 14.99946 } },
  winter = { { -1.43558, -1.58826, -1.08270, 14.68033, 14.99525, -0.80532, 5.69699, -1.14181, 14.99997 },
             { -1.420733, -1.587912, -1.073685, 14.83014, 14.99768, -0.7177335, 5.63619, -1.075092, 15.00015 } },
}
for i, place in ipairs(places) do
  local name = place[1]
  history(name) { at = { place[2], 0, place[3] }, record = { "temperature" } }
  if args.transient then
    local lumped, consistent = hundred_days[args.season][1][i], hundred_days[args.season][2][i]
    expect(name .. ", lumped") { history = name, component = "temperature", value = lumped, tolerance = 0.1 }
    expect(name .. ", CalculiX") { history = name, component = "temperature", value = consistent, tolerance = 0.3 }
  else
    local value = steady[args.season][args.fine and 2 or 1][i]
    expect(name) { history = name, component = "temperature", value = value, tolerance = 0.005 }
  end
end
