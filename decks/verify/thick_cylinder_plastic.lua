-- Cases P30 and P32: a thick cylinder (radii 1 and 2) widened from inside until all of it flows, plane strain.
-- Source: no friction: p = 2 c ln(b/a) = 1.3863 MPa (Hill 1950); with friction, associated:
--   p = c cot(phi) [(b/a)^((N-1)/N) - 1], N = (1 + sin phi) / (1 - sin phi): 1.01741 MPa at phi = 30 deg.
--   Widening u(a) at 0.8, 1.0 and 1.2 MPa without friction: CalculiX 2.20, C3D8I, 8 x 8 elements.
-- Accept: limit pressure within 2 %, on a plateau; widening 2 % (there 8 x 8 of another element).
-- Runs: friction=0 | friction=30 | friction=0 elements=wedge6 | friction=30 elements=wedge6 | friction=30 law=mohr_coulomb |
--   friction=0 elements=tet4 | friction=30 elements=tet4 | friction=30 law=mohr_coulomb elements=tet4
local args = deck.args {
  friction    = { default = 0, doc = "angle of friction and dilation, degrees" },
  law         = { default = "drucker_prager", doc = "with friction: drucker_prager (plane_strain) or mohr_coulomb" },
  n           = { default = 16, doc = "elements across the wall and along the quarter" },
  elements    = { default = "hex8", doc = "hex8, wedge6 or tet4" },
  formulation = { default = "bbar", doc = "bbar, or full to see it lock" },
}
local a, b, thick, cohesion = 1, 2, 0.25, 1e6
local phi, n = math.rad(args.friction), math.tointeger(args.n)

model "thick_cylinder" {}
local section = {}
for i = 0, n do
  local angle = math.pi / 2 * i / n
  section[#section + 1] = { b * math.cos(angle), b * math.sin(angle) }
end
for i = n, 0, -1 do
  local angle = math.pi / 2 * i / n
  section[#section + 1] = { a * math.cos(angle), a * math.sin(angle) }
end
section[n + 1][1], section[n + 2][1] = 0, 0  -- cos of a right angle is not quite 0
extrude "wall" {
  section = section, length = thick, layers = 1, size = b - a, elements = args.elements,
  corners = { 1, n + 1, n + 2, 2 * n + 2 },
  divisions = { [1] = n, [2] = n, [3] = n, [4] = n },
}
local law = { region = "wall", density = 2000*kg/m^3, young = 1*GPa, poisson = 0.3, formulation = args.formulation }
if args.friction > 0 then
  law.law, law.cohesion, law.friction, law.dilation = args.law, cohesion*Pa, phi, phi
else
  law.law, law.yield_stress = "von_mises", math.sqrt(3) * cohesion*Pa
end
material "ground" (law)

surface "left"   { of = "wall", plane = { { 0, 0, 0 }, { 1, 0, 0 } } }
surface "bottom" { of = "wall", plane = { { 0, 0, 0 }, { 0, 0, 1 } } }
surface "slice"  { of = "wall", side = { "front", "back" } }
surface "bore"   { of = "wall", facing = { -1, 0, -1 }, within = 50*deg, box = { { 0, 0, 0 }, { 1, 1, 1 } } }
fix "symmetry" { surface = { "left", "bottom", "slice" }, normal = true }
local widening = 0.01
displacement "widen" {
  surface = "bore",
  x = function(x, y, z) return widening * x / a end, z = function(x, y, z) return widening * z / a end,
}
stage "widen" { solve = static { increments = 50, tolerance = 1e-6 } }

history "hoop" { surface = "bottom", record = { "reaction" } }
history "other hoop" { surface = "left", record = { "reaction" } }
history "edge" { at = { a, 0, 0 }, record = { "displacement" } }

local limit = 2 * cohesion * math.log(b / a)
if args.friction > 0 then
  local n = (1 + math.sin(phi)) / (1 - math.sin(phi))
  limit = cohesion / math.tan(phi) * ((b / a)^((n - 1) / n) - 1)
end
-- The hoop forces in the planes x = 0 and z = 0 carry the pressure between them, but for half a facet at each end.
local function pressures(result)
  local p, other = result.history("hoop").values("reaction.z", "widen"), result.history("other hoop").values("reaction.x", "widen")
  local height = a * (1 + math.cos(math.pi / 2 / n)) / 2
  for i, force in ipairs(p) do p[i] = -(force + other[i]) / (2 * height * thick) end
  return p
end
expect "limit pressure" { that = function(result)
  local p = pressures(result)
  local last = p[#p]
  return math.abs(last / limit - 1) < 0.02, string.format("%.5g MPa, theory %.5g MPa", last / 1e6, limit / 1e6)
end }
expect "a plateau" { that = function(result)
  local p = pressures(result)
  local rise = p[#p] / p[#p - 10] - 1
  return math.abs(rise) < 0.002, string.format("rises by %.2g %% over the last fifth of the way", 100 * rise)
end }
if args.friction == 0 then
  for _, case in ipairs { { 0.8e6, 0.0015268 }, { 1.0e6, 0.0020819 }, { 1.2e6, 0.0030734 } } do
    expect(string.format("widening at %.1f MPa", case[1] / 1e6)) { that = function(result)
      local p, u = pressures(result), result.history("edge").values("displacement.x", "widen")
      for i = 2, #p do
        if p[i] >= case[1] then
          local found = u[i - 1] + (u[i] - u[i - 1]) * (case[1] - p[i - 1]) / (p[i] - p[i - 1])
          return math.abs(found / case[2] - 1) < 0.02, string.format("%.5g mm, CalculiX %.5g mm", 1e3 * found, 1e3 * case[2])
        end
      end
      return false, "never reached"
    end }
  end
end
