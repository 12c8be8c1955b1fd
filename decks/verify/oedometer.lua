-- Case P29: a cube squeezed along z between rigid sides, c = 0.1 MPa, phi = 10 deg, outer Drucker-Prager cone,
--   E = 100 MPa, nu = 0.3, without and with dilation.
-- Source: closed form (K, G, M = K + 4 G / 3, cone a, k, flow slope b): flow begins at e_y = k / d,
--   d = 2 G / sqrt 3 - 3 K a; after it s_ax = M e - l (2 G / sqrt 3 - 3 K b), s_lat = (K - 2 G / 3) e + l (G / sqrt 3 + 3 K b),
--   l = d (e - e_y) / (G + 9 K a b).
--   Plastic work: work of the piston less what is stored, sigma : C^-1 : sigma / 2.
-- Accept: 0.1 %; plastic work 2 %, counted with the stress at the end of each of 20 increments.
-- Runs: elements=hex8 | elements=wedge6 | elements=tet4
local args = deck.args { elements = { default = "hex8", doc = "hex8, wedge6 or tet4" } }
local young, poisson, flowed = 100e6, 0.3, 0
local e, bulk, shear, root3 = 0.01, 100e6 / (3 * 0.4), 100e6 / 2.6, math.sqrt(3)

model "oedometer" {}
for column, dilation in ipairs { 0, 5, 10 } do
  local name = "dilation " .. dilation
  local x = 2 * column
  box(name) { from = { x, 0, 0 }, to = { x + 1, 1, 1 }, cells = { 2, 2, 2 }, elements = args.elements }
  material(name) {
    region = name, law = "drucker_prager", density = 2000*kg/m^3, young = 100*MPa, poisson = 0.3,
    cohesion = 0.1*MPa, friction = 10*deg, dilation = dilation*deg, match = "outer",
  }
  local rigid = { name .. ".left", name .. ".right", name .. ".front", name .. ".back", name .. ".bottom" }
  fix { surface = rigid, normal = true }
  displacement { surface = name .. ".top", z = -e*m }
  history(name) { at = { x + 0.4, 0.4, 0.4 }, record = { "stress" } }

  local function cone(angle) return 2 * math.sin(angle) / (root3 * (3 - math.sin(angle))) end
  local phi = math.rad(10)
  local a, b = cone(phi), cone(math.rad(dilation))
  local k = 6 * 0.1e6 * math.cos(phi) / (root3 * (3 - math.sin(phi)))
  local d = 2 * shear / root3 - 3 * bulk * a
  local flow = d * (e - k / d) / (shear + 9 * bulk * a * b)
  local axial = (bulk + 4 * shear / 3) * e - flow * (2 * shear / root3 - 3 * bulk * b)
  local side = (bulk - 2 * shear / 3) * e + flow * (shear / root3 + 3 * bulk * b)
  local first = (bulk + 4 * shear / 3) * k / d  -- axial stress as flow begins
  local stored = (axial^2 + 2 * side^2 - 2 * poisson * (2 * axial * side + side^2)) / (2 * young)
  flowed = flowed + first * k / d / 2 + (first + axial) / 2 * (e - k / d) - stored
  expect(name .. " axial") { history = name, component = "stress.zz", value = -axial*Pa, relative = 1e-3 }
  expect(name .. " lateral") { history = name, component = "stress.xx", value = -side*Pa, relative = 1e-3 }
end
history "blocks" { record = { "dissipation" } }
expect "plastic work" { history = "blocks", component = "dissipation.plastic", value = flowed*J, relative = 0.02 }
stage "squeeze" { solve = static { tolerance = 1e-8 } }
