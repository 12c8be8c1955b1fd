-- Case P2: patch test. A field that is linear on the boundary is linear inside, whatever the shape of the elements.
-- Source: exact; the idea is that of MacNeal and Harder 1985, whose own seven cells are P1.
-- Accept: 1e-6 of stress and displacement.
-- Runs: elements=hex8 | elements=wedge6 | elements=tet4 | elements=hex8 formulation=bbar | elements=wedge6 formulation=bbar |
--   elements=tet4 formulation=bbar
local args = deck.args {
  elements = { default = "hex8", doc = "27 hex8, or each as two wedge6 or six tet4" },
  formulation = { default = "full", doc = "full or bbar" },
}

model "patch" {}
import_mesh { file = "../../tests/data/verify_patch_" .. args.elements .. ".msh" }
material "unit" { region = "body", young = 1*MPa, poisson = 0.25, density = 1*kg/m^3, formulation = args.formulation }

-- Every strain is 1e-3: u = 1e-3 (x + (y+z)/2, y + (x+z)/2, z + (x+y)/2).
local field = {
  x = function(x, y, z) return 1e-3 * (x + (y + z) / 2) end,
  y = function(x, y, z) return 1e-3 * (y + (x + z) / 2) end,
  z = function(x, y, z) return 1e-3 * (z + (x + y) / 2) end,
}
displacement "boundary" { surface = "outside", x = field.x, y = field.y, z = field.z }

stage "pull" { solve = static { tolerance = 1e-10 } }

-- The eight inner nodes, as tests/data/verify_patch_meshes.py prints them.
local inner = {
  { 0.260559999587, 0.269115221877, 0.344132717980 }, { 0.643092938547, 0.407100492101, 0.262262617922 },
  { 0.253646413084, 0.590916838011, 0.274437099848 }, { 0.683945647962, 0.734061018925, 0.411490532465 },
  { 0.338780868908, 0.413044870210, 0.685530536571 }, { 0.745113826009, 0.257560683478, 0.719439529158 },
  { 0.377506724126, 0.706380912958, 0.701751536508 }, { 0.727117884726, 0.644720758523, 0.587668094877 },
}
for number, place in ipairs(inner) do
  local name = "inner " .. number
  history(name) { at = place, record = { "displacement" } }
  for _, axis in ipairs { "x", "y", "z" } do
    expect(name .. " " .. axis) {
      history = name, component = "displacement." .. axis, value = field[axis](table.unpack(place)), relative = 1e-6,
    }
  end
end

-- 2 mu 1e-3 + lambda 3e-3 = 2000 Pa, mu 1e-3 = 400 Pa: the middle, and near each corner.
local places = { { 0.5, 0.5, 0.5 } }
for corner = 0, 7 do
  places[#places + 1] = { 0.1 + 0.8 * (corner & 1), 0.1 + 0.8 * (corner >> 1 & 1), 0.1 + 0.8 * (corner >> 2) }
end
for number, place in ipairs(places) do
  local name = "stress " .. number
  history(name) { at = place, record = { "stress" } }
  for _, component in ipairs { "xx", "yy", "zz", "xy", "yz", "zx" } do
    expect(name .. " " .. component) {
      history = name, component = "stress." .. component, relative = 1e-6,
      value = (component == "xx" or component == "yy" or component == "zz") and 2000 or 400,
    }
  end
end
