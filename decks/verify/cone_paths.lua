-- Case P28: a cube on five paths to failure (uniaxial and triaxial compression, triaxial extension, uniaxial tension,
--   simple shear) with the Drucker-Prager cone by its three matches with Mohr-Coulomb, and with Mohr-Coulomb itself,
--   c = 1.2 MPa, phi = 35 deg.
-- Source: closed form: axial compression at yield (k + p (1/sqrt 3 + 2 a)) / (1/sqrt 3 - a), extension
--   (p (1/sqrt 3 - 2 a) - k) / (1/sqrt 3 + a), shear k; outer cone in uniaxial compression: 2 c cos / (1 - sin).
--   Mohr-Coulomb: (1 + sin) s1 - (1 - sin) s3 = 2 c cos.
-- Accept: 0.1 % on the plateau.
-- Runs: elements=hex8 | elements=wedge6 | elements=tet4
local args = deck.args { elements = { default = "hex8", doc = "one hex8, two wedge6 or six tet4" } }

model "cone_paths" {}

local cohesion, friction = 1.2*MPa, 35*deg
local sine, tangent, root3 = math.sin(0.6108652381980153), math.tan(0.6108652381980153), math.sqrt(3)
local cosine = sine / tangent
local function cone(match)
  if match == "plane_strain" then
    local root = math.sqrt(9 + 12 * tangent^2)
    return tangent / root, 3 * 1.2 / root
  end
  local under = root3 * (match == "outer" and 3 - sine or 3 + sine)
  return 2 * sine / under, 6 * 1.2 * cosine / under
end

--- What the top of a Mohr-Coulomb cube carries, MPa.
local function on_pyramid(path)
  local base = 2 * 1.2 * cosine
  if not path.pressure then return base / 2 end
  if path.move < 0*mm then return -(base + path.pressure * (1 + sine)) / (1 - sine) end
  return (base - path.pressure * (1 - sine)) / (1 + sine)
end

local paths = {  -- pressure on the sides and movement of the top
  { name = "compression", pressure = 0, move = -5*mm },
  { name = "triaxial", pressure = 5, move = -10*mm },
  { name = "extension", pressure = 20, move = 10*mm },
  { name = "tension", pressure = 0, move = 2*mm },
  { name = "shear" },
}
local confine, drive, row = {}, {}, 0
for _, match in ipairs { "outer", "inner", "plane_strain", "pyramid" } do
  local pyramid = match == "pyramid"
  local a, k = cone(match)
  local regions = {}
  for column, path in ipairs(paths) do
    local name = match .. " " .. path.name
    local x, y = 2 * column, 2 * row
    box(name) { from = { x, y, 0 }, to = { x + 1, y + 1, 1 }, cells = { 1, 1, 1 }, elements = args.elements }
    regions[#regions + 1] = name
    local wanted, component = k, "stress.zx"
    if path.pressure then
      local p, over = path.pressure, 1 / root3
      fix { surface = name .. ".left", x = 0 }
      fix { surface = name .. ".front", y = 0 }
      fix { surface = name .. ".bottom", z = 0 }
      if p > 0 then
        confine[#confine + 1] = pressure { surface = { name .. ".right", name .. ".back", name .. ".top" }, value = p*MPa }
      end
      drive[#drive + 1] = displacement { surface = name .. ".top", z = path.move }
      component = "stress.zz"
      if path.name == "compression" or path.name == "triaxial" then
        wanted = -(k + p * (over + 2 * a)) / (over - a)
      else
        wanted = (k - p * (over - 2 * a)) / (over + a)
      end
    else
      local all = {}
      fix { surface = name .. ".bottom", x = 0, y = 0, z = 0 }
      for _, side in ipairs { "left", "right", "front", "back", "top" } do all[#all + 1] = name .. "." .. side end
      drive[#drive + 1] = displacement { surface = all, x = function(px, py, z) return 1e-3 * z end, y = 0*m, z = 0*m }
    end
    if pyramid then wanted = on_pyramid(path) end
    history(name) { at = { x + 0.5, y + 0.5, 0.5 }, record = { "stress", "plastic_strain" } }
    expect(name) { history = name, component = component, value = wanted*MPa, relative = 1e-3 }
  end
  material(match) {
    region = regions, law = pyramid and "mohr_coulomb" or "drucker_prager", density = 2400*kg/m^3, young = 10*GPa,
    poisson = 0.2, cohesion = cohesion, friction = friction, match = not pyramid and match or nil,
  }
  row = row + 1
end

stage "confine" { apply = confine, solve = static { tolerance = 1e-9 } }
stage "drive" { apply = drive, solve = static { tolerance = 1e-9, increments = 20 } }
