-- Case jointed: rock with close joints between rigid sides: flat joints sheared under compression slip and, as they cannot rise
--   by tan(psi) of their slip, press harder; joints that dip slip on their own plane when the block is squeezed.
-- Source: closed form: on the plane slip = (|shear| + normal tan(phi) - c) / (G + M tan(psi) tan(phi)), M oedometric;
--   elastic beside it.
-- Accept: 0.1 %.
-- Runs: elements=hex8 | elements=wedge6 | elements=tet4
local args = deck.args { elements = { default = "hex8", doc = "hex8, wedge6 or tet4" } }

model "jointed_rock" {}
local young, poisson, cohesion, friction, dilation = 10e9, 0.2, 0.2e6, 0.3490658503988659, 0.08726646259971647
local shear, oedometric = young / 2.4, young * 0.8 / (1.2 * 0.6)
local function rock(name, x, dip, dilates)
  box(name) { from = { x, 0, 0 }, to = { x + 1, 1, 1 }, cells = { 1, 1, 1 }, elements = args.elements }
  material(name) {
    region = name, law = "jointed", density = 2500*kg/m^3, young = young*Pa, poisson = poisson, dip = dip,
    dip_direction = 90*deg, cohesion = cohesion*Pa, friction = friction, dilation = dilates and dilation or nil,
  }
  fix { surface = name .. ".bottom", x = 0, y = 0, z = 0 }
  history(name) { at = { x + 0.5, 0.5, 0.5 }, record = { "stress", "plastic_strain" } }
end
rock("flat", 0, 0*deg, true)
rock("steep", 2, 50*deg, false)
local function all_sides(name)
  local all = {}
  for _, side in ipairs { "left", "right", "front", "back", "top" } do all[#all + 1] = name .. "." .. side end
  return all
end
stage "move" {
  apply = {
    displacement {
      surface = all_sides("flat"), x = function(x, y, z) return 1e-3 * z end, y = 0*m,
      z = function(x, y, z) return -0.1e-3 * z end,
    },
    displacement { surface = all_sides("steep"), x = 0*m, y = 0*m, z = function(x, y, z) return -0.5e-3 * z end },
  },
  solve = static { tolerance = 1e-9, increments = 10 },
}

local pressed, tangent = oedometric * 0.1e-3, math.tan(friction)
local slip = (shear * 1e-3 - pressed * tangent - cohesion) / (shear + oedometric * math.tan(dilation) * tangent)
expect "sheared" { history = "flat", component = "stress.zx", value = (shear * (1e-3 - slip))*Pa, relative = 1e-3 }
expect "pressed harder" {
  history = "flat", component = "stress.zz", value = -(pressed + oedometric * math.tan(dilation) * slip)*Pa,
  relative = 1e-3,
}

-- Squeezed by 5e-4 with rigid sides: normal and shear on the plane that dips 50 deg, then slip along it.
local e, sine, cosine = 0.5e-3, math.sin(0.8726646259971648), math.cos(0.8726646259971648)
local vertical, lateral = -oedometric * e, -oedometric * e * poisson / (1 - poisson)
local normal = vertical * cosine^2 + lateral * sine^2
local along = (lateral - vertical) * sine * cosine
local slid_steep = (along + normal * tangent - cohesion) / shear
expect "squeezed" {
  history = "steep", component = "stress.zz",
  value = (vertical + 2 * shear * slid_steep * sine * cosine)*Pa, relative = 1e-3,
}
