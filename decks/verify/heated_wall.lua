-- Case heat source: a wall of 2 m that makes 300 W/m^3, its faces held at 10 degC; then its right half stops.
-- Source: closed form, T = 10 + q x (L - x) / (2 k) with q all over; with q on the left half only,
--         T(L/2) = T(L/4) = 10 + q L^2 / (16 k)  (conduction in one dimension, integrated twice).
-- Accept: 1e-6 K on every shape, for the mean over the cross-section: the source of a slice does work on that mean alone, so it is
--         exact wherever the elements' nodes lie in planes x = const. Single nodes of wedge6 and tet4 differ from it, because
--         their split gives the nodes of one plane unequal shares of the source.
-- Runs: elements=hex8 | elements=wedge6 | elements=tet4
local args = deck.args { elements = { default = "hex8", doc = "hex8, wedge6 or tet4" } }
local q, k, L = 300, 2.5, 2

model "heated_wall" { reference_temperature = 10*degC }
box "left"  { from = { 0, 0, 0 }, to = { 1*m, 0.25*m, 0.25*m }, cells = { 4, 1, 1 }, elements = args.elements }
box "right" { from = { 1*m, 0, 0 }, to = { 2*m, 0.25*m, 0.25*m }, cells = { 4, 1, 1 }, elements = args.elements }
material "concrete" {
  region = { "left", "right" }, young = 30*GPa, poisson = 0.2, density = 2400*kg/m^3, conductivity = k*W/(m*K),
}
surface "faces" { side = { "left", "right" } }
fixed_temperature { surface = "faces", value = 10*degC }

stage "all"  { apply = { heat_source { value = q*W/m^3 } }, solve = thermal { steady = true, tolerance = 1e-13 } }
stage "half" {
  apply = { heat_source { region = "right", value = 0*W/m^3 } },
  solve = thermal { steady = true, tolerance = 1e-13 },
}

-- Mean over a square section from its corners and its centre: exact for two triangles and for a bilinear quad.
local places = { middle = 1, quarter = 0.5 }
local points = { { 0, 0 }, { 0.25, 0 }, { 0, 0.25 }, { 0.25, 0.25 }, { 0.125, 0.125 } }
for place, x in pairs(places) do
  for i, p in ipairs(points) do
    history(place .. i) { at = { x*m, p[1]*m, p[2]*m }, record = { "temperature" } }
  end
end
local function section_mean(result, place, stage)
  local sum = 0
  for i = 1, 4 do sum = sum + result.history(place .. i).at("temperature", stage) end
  return (sum + 2 * result.history(place .. 5).at("temperature", stage)) / 6
end

for _, case in ipairs {
  { "all", "middle", q*L^2/(8*k) }, { "all", "quarter", 3*q*L^2/(32*k) },
  { "half", "middle", q*L^2/(16*k) }, { "half", "quarter", q*L^2/(16*k) },
} do
  local stage, place, rise = table.unpack(case)
  expect(place .. " with " .. stage) {
    that = function(result) return math.abs(section_mean(result, place, stage) - (10 + rise)) <= 1e-6 end,
  }
end
