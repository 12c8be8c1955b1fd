-- Case hydration: a lift that lets no heat out, heated by its cement as a table of age says; placed after 3 days.
-- Source: by hand. The rise is the integral of the table over rho c: 98.4375 K at 7 days of age, 103.78125 K at the end.
-- Accept: 1e-4 of the rise.
-- Runs: elements=hex8 | elements=wedge6 | elements=tet4
local args = deck.args { elements = { default = "hex8", doc = "hex8, wedge6 or tet4" } }

model "hydration" { reference_temperature = 12*degC }
box "lift" { from = { 0, 0, 0 }, to = { 3*m, 2*m, 1.5*m }, size = 0.5*m, elements = args.elements }
material "concrete" {
  region = "lift", young = 30*GPa, poisson = 0.2, density = 2400*kg/m^3,
  conductivity = 2.5*W/(m*K), heat_capacity = 960*J/(kg*K),
}
local age = deck.read_table("reference/hydration.csv", { time = days })   -- columns without names: time, value
local function integral(last)
  local sum = 0*J/m^3
  for i = 2, #age.time do
    if age.time[i] <= last then sum = sum + (age.time[i] - age.time[i-1]) * (age.value[i] + age.value[i-1]) * (0.5*W/m^3) end
  end
  return sum
end

stage "before"  { solve = thermal { duration = 3*days } }
stage "a week"  { apply = { heat_source { region = "lift", value = in_stage(age) } }, solve = thermal { duration = 7*days } }
stage "the end" { solve = thermal { duration = 10*days } }

history "core"   { at = { 1.3*m, 0.9*m, 0.7*m }, record = { "temperature" } }
history "corner" { at = { 0, 0, 0 }, record = { "temperature" } }
for _, place in ipairs { "core", "corner" } do
  for stage, last in pairs { ["before"] = 0*days, ["a week"] = 7*days, ["the end"] = 14*days } do
    local rise = integral(last) / (2400*960*J/(m^3*K)) / (1*K)
    expect(place .. " " .. stage) {
      history = place, component = "temperature", stage = stage, value = (12 + rise)*degC, tolerance = 1e-4 * rise + 1e-9,
    }
  end
end
