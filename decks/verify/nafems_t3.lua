-- Case P25: NAFEMS T3. A rod of 0.1 m, one end at 0 degC, the other at 100 sin(pi t / 40): temperature at 0.08 m, 32 s.
-- Source: closed form (series), 36.603 degC; NAFEMS R0026 prints 36.60.
-- Accept: 0.2 K with 20 elements (lumped capacity on 10 gives 35.95 as steps shrink, an independent program too).
--   The temperature is given as a function, and as a table read from a file.
-- Runs: elements=hex8 | elements=wedge6 | elements=tet4 | given=table
local args = deck.args {
  elements = { default = "hex8", doc = "hex8, wedge6 or tet4" },
  given = { default = "function", doc = "how the temperature is given: function or table" },
}

model "nafems_t3" { reference_temperature = 0*degC }
box "rod" { from = { 0, 0, 0 }, to = { 0.1*m, 0.01*m, 0.01*m }, cells = { 20, 1, 1 }, elements = args.elements }
material "steel" {
  region = "rod", young = 200*GPa, poisson = 0.3, density = 7200*kg/m^3,
  conductivity = 35*W/(m*K), heat_capacity = 440.5*J/(kg*K),
}
surface "cold" { of = "rod", side = "left" }
surface "hot"  { of = "rod", side = "right" }
fixed_temperature { surface = "cold", value = 0*degC }
fixed_temperature { surface = "hot", value = args.given == "table" and deck.read_table "reference/nafems_t3_surface.csv"
                    or in_time(function(t) return 100 * math.sin(math.pi * t / 40) end) }

stage "heating" { solve = thermal { duration = 32*s } }

history "inside"  { at = { 0.08*m, 0, 0 }, record = { "temperature" } }
history "surface" { at = { 0.1*m, 0, 0 }, record = { "temperature" } }
expect "inside" { history = "inside", component = "temperature", value = 36.6031*degC, tolerance = 0.2 }
expect "surface" {
  history = "surface", component = "temperature", value = 100 * math.sin(0.8 * math.pi) * degC, tolerance = 0.02,
}
