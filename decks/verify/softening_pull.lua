-- Case P35 with the softening law: two cubes of 0.1 m pulled apart, eased, pressed together and pulled again until nothing
--   holds them: tensile strength 2 MPa, fracture energy 100 J/m^2, springs of 1e12 Pa/m.
-- Source: closed form of linear softening: peak f_t A = 20 kN, separation at w_c = 2 G_f / f_t = 0.1 mm, work G_f A = 1 J.
-- Accept: 1e-4 of the force; 1 % of the work.
-- Runs: elements=hex8 | elements=wedge6 | elements=tet4 | upper=3 | elements=tet4 upper=2
local args = deck.args {
  elements = { default = "hex8", doc = "hex8, wedge6 or tet4" },
  upper = { default = 1, doc = "cells along x of the upper cube, 1 as in the lower one" },
}
local side, strength, energy, stiffness = 0.1, 2e6, 100, 1e12
local area, first, last = side^2, strength / stiffness, 2 * energy / strength

model "softening_pull" {}
box "lower" { from = { 0, 0, -side }, to = { side, side, 0 }, cells = { 1, 1, 1 }, elements = args.elements }
box "upper" {
  from = { 0, 0, 0 }, to = { side, side, side }, cells = { args.upper, 1, 1 }, elements = args.elements,
}
material "concrete" { region = { "lower", "upper" }, young = 30*GPa, poisson = 0.2, density = 2400*kg/m^3 }
joint "plane" {
  between = { "lower", "upper" }, law = "softening", tensile_strength = strength*Pa, cohesion = 3*MPa,
  fracture_energy = energy*J/m^2, normal_stiffness = stiffness*Pa/m,
}
-- Every node of a cube is held: the cubes move without straining, the joint alone opens.
surface "below" { of = "lower", side = { "front", "back" } }
surface "above" { of = "upper", side = { "front", "back" } }
fix { surface = "below", x = 0, y = 0, z = 0 }

-- Openings in units of `first`, and the increments that lead there.
local path = { { "pull", 40, 40 }, { "ease", 20, 20 }, { "press", -1, 21 }, { "again", 40, 41 }, { "apart", 110, 70 } }
for _, leg in ipairs(path) do
  stage(leg[1]) {
    apply = { displacement { surface = "above", x = 0, y = 0, z = leg[2] * first } },
    solve = static { tolerance = 1e-9, increments = leg[3] },
  }
end
history "above" { surface = "above", record = { "reaction" } }
history "contacts" { record = { "dissipation", "cracked_area" } }

local pulled = strength * area * (last - 40 * first) / (last - first)
for stage, force in pairs { pull = pulled, ease = pulled / 2, press = -strength * area, again = pulled, apart = 0 } do
  expect("force " .. stage) {
    history = "above", component = "reaction.z", stage = stage, value = force*N, tolerance = 1e-4 * strength * area * N,
  }
end
expect "energy of opening" { history = "contacts", component = "dissipation.opening", value = energy * area*J, relative = 1e-6 }
expect "nothing sheared" { history = "contacts", component = "dissipation.shear", value = 0*J, tolerance = 1e-9*J }
expect "all of it cracked" { history = "contacts", component = "cracked_area", value = area*m^2, relative = 1e-9 }
expect "work and peak" { that = function(result)
  local work, force, opening, peak = 0, 0, 0, 0
  for _, leg in ipairs(path) do
    local forces = result.history("above").values("reaction.z", leg[1])
    local from, before = opening, #forces - leg[3]  -- the first stage has a row of its start
    for i = 1, leg[3] do
      local f, now = forces[before + i], from + (leg[2] * first - from) * i / leg[3]
      work, force, opening, peak = work + 0.5 * (force + f) * (now - opening), f, now, math.max(peak, f)
    end
  end
  return math.abs(work / (energy * area) - 1) < 0.01 and math.abs(peak / (strength * area) - 1) < 0.01,
    string.format("work %.5g J, wanted %.5g; peak %.5g N, wanted %.5g", work, energy * area, peak, strength * area)
end }
