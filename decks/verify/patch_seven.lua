-- Case P1: patch test of MacNeal and Harder: a skew cell inside the unit cube and the six around it, under a linear field.
-- Source: exact; the mesh is that of MacNeal and Harder 1985.
-- Accept: 1e-6 of stress and displacement.
-- Runs: elements=wedge6 | elements=tet4 | elements=wedge6 formulation=bbar | elements=tet4 formulation=bbar
-- As hexahedra, one of the seven is turned over at a corner, (0.320, 0.186, 0.643): its edges there span -0.01265, so that
-- no deck may have it. All its Gauss points are sound: tests/solve/patch.cpp solves the seven hexahedra below the check.
local args = deck.args {
  elements    = { default = "wedge6", doc = "each cell as two wedge6 or six tet4" },
  formulation = { default = "full", doc = "full or bbar" },
}

model "patch" {}
-- Corners of the cube from its bottom up, then of the inner cell.
local corners = {
  { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 },
  { .249, .342, .192 }, { .826, .288, .288 }, { .850, .649, .263 }, { .273, .750, .230 },
  { .320, .186, .643 }, { .677, .305, .683 }, { .788, .693, .644 }, { .165, .745, .702 },
}
local cells = {
  { 1, 2, 3, 4, 9, 10, 11, 12 }, { 13, 14, 15, 16, 5, 6, 7, 8 }, { 9, 10, 11, 12, 13, 14, 15, 16 },
  { 2, 6, 14, 10, 1, 5, 13, 9 }, { 3, 7, 15, 11, 2, 6, 14, 10 }, { 4, 8, 16, 12, 3, 7, 15, 11 }, { 1, 5, 13, 9, 4, 8, 16, 12 },
}
local names = {}
for number, cell in ipairs(cells) do
  -- The unit box with its corners moved to those of the cell.
  local function place(axis)
    return function(u, v, w)
      local low = (1 - v) * ((1 - u) * corners[cell[1]][axis] + u * corners[cell[2]][axis])
        + v * (u * corners[cell[3]][axis] + (1 - u) * corners[cell[4]][axis])
      local high = (1 - v) * ((1 - u) * corners[cell[5]][axis] + u * corners[cell[6]][axis])
        + v * (u * corners[cell[7]][axis] + (1 - u) * corners[cell[8]][axis])
      return (1 - w) * low + w * high
    end
  end
  names[number] = "cell" .. number
  box(names[number]) {
    from = { 0, 0, 0 }, to = { 1, 1, 1 }, cells = { 1, 1, 1 }, elements = args.elements,
    x = place(1), y = place(2), z = place(3),
  }
end
material "unit" { region = names, young = 1*MPa, poisson = 0.25, density = 1*kg/m^3, formulation = args.formulation }

-- Every strain is 1e-3: u = 1e-3 (x + (y+z)/2, y + (x+z)/2, z + (x+y)/2).
local field = {
  x = function(x, y, z) return 1e-3 * (x + (y + z) / 2) end,
  y = function(x, y, z) return 1e-3 * (y + (x + z) / 2) end,
  z = function(x, y, z) return 1e-3 * (z + (x + y) / 2) end,
}
surface "outside" { of = names }
displacement "boundary" { surface = "outside", x = field.x, y = field.y, z = field.z }
stage "pull" { solve = static { tolerance = 1e-10 } }

-- 2 mu 1e-3 + lambda 3e-3 = 2000 Pa, mu 1e-3 = 400 Pa.
for number = 9, 16 do
  local name = "inner " .. number - 8
  history(name) { at = corners[number], record = { "displacement", "nodal_stress" } }
  for _, axis in ipairs { "x", "y", "z" } do
    expect(name .. " " .. axis) {
      history = name, component = "displacement." .. axis, value = field[axis](table.unpack(corners[number])), relative = 1e-6,
    }
  end
  for _, component in ipairs { "xx", "yy", "zz", "xy", "yz", "zx" } do
    expect("stress " .. number - 8 .. " " .. component) {
      history = name, component = "nodal_stress." .. component, relative = 1e-6,
      value = (component == "xx" or component == "yy" or component == "zz") and 2000 or 400,
    }
  end
end
