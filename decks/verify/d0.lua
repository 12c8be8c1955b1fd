-- Dam D0, the part that its decks share: a public gravity dam of 60 m on 60 m of rock, 12 m thick, water to 55 m.
-- Meshes: tests/data/dam_D0_r1_*.msh, and r2 with half the element size; ny is the number of layers over the thickness.
local d0 = {}

d0.water_level = 55*m

--- A table with the keys of both.
local function with(some, others)
  local all = {}
  for key, value in pairs(some) do all[key] = value end
  for key, value in pairs(others) do all[key] = value end
  return all
end

--- Mesh and materials.
function d0.body(mesh)
  import_mesh { file = "../../tests/data/dam_D0_" .. mesh .. ".msh" }
  d0.materials()
end

--- The same body meshed here, about as coarse as r1_ny2, from other elements.
function d0.body_of(elements)
  local y = { length = 12*m, layers = 2, elements = elements }
  extrude "concrete" (with(y, { section = { {0,0}, {48,0}, {8,50}, {8,60}, {0,60} }, size = 8*m }))
  extrude "rock" (with(y, { section = { {-60,-60}, {108,-60}, {108,0}, {-60,0} }, size = 10*m }))
  surface "bottom" { of = "rock", side = "bottom" }
  surface "xside"  { of = "rock", side = { "left", "right" } }
  surface "yside"  { side = { "front", "back" } }
  surface "up_wet" { of = "concrete", side = "left" }
  d0.materials()
end

function d0.materials()
  material "concrete" {
    region = "concrete", young = 20*GPa, poisson = 0.2, density = 2400*kg/m^3, expansion = 1e-5/K,
    conductivity = 2.7*W/(m*K), heat_capacity = 960*J/(kg*K),
  }
  material "rock" {
    region = "rock", young = 20*GPa, poisson = 0.2, density = 2650*kg/m^3, expansion = 0.8e-5/K,
    conductivity = 3.0*W/(m*K), heat_capacity = 850*J/(kg*K),
  }
end

--- Bottom fixed, sides on rollers, plane strain.
function d0.supports()
  fix "base"    { surface = "bottom", x = 0, y = 0, z = 0 }
  fix "rollers" { surface = { "xside", "yside" }, normal = true }
end

--- Weight of everything and water on the dam's upstream face; none on the ground.
function d0.loads()
  gravity { z = -9.81 }
  water_pressure "reservoir" { surface = "up_wet", level = d0.water_level }
end

--- Every element its own block. `strength` has the keys of a law for the dam and its base; the rock never cracks.
function d0.explode(stiffness, strength)
  local dam = with(stiffness, strength)
  crackable "rock" (with(stiffness, { region = "rock", law = "elastic" }))
  crackable "body" (with(dam, { region = "concrete" }))
  joint "base"     (with(dam, { between = { "concrete", "rock" } }))
end

--- Air on every dry face, water on the wet face and the reservoir's ground, the rock's bottom at ground temperature.
d0.season = {
  summer = { air = 28.2*degC, water = 19.5*degC, ground = 32.4*degC },
  winter = { air = -1.6*degC, water = 2.8*degC, ground = 10.3*degC },
}
function d0.climate(now)
  return {
    convection { surface = { "up_dry", "down", "crest", "ground_d" }, ambient = now.air, film = 15*W/(m^2*K) },
    fixed_temperature { surface = { "up_wet", "ground_u" }, value = now.water },
    fixed_temperature { surface = "bottom", value = now.ground },
  }
end

--- Rows of a table of reference/ for one refinement: row(function(values by column name) ... end).
function d0.each_row(file, refinement, row)
  local columns = deck.read_table("reference/" .. file)
  for i, r in ipairs(columns.refinement) do
    if r == refinement then
      local values = {}
      for name, column in pairs(columns) do values[name] = column[i] end
      row(values)
    end
  end
end

return d0
