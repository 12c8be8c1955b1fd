-- Case off the edge: a block slides off a table, tips over its edge, where only edges cross each other, and falls.
-- Source: bodies do not lie in each other; closed form: what touches nothing accelerates by gravity alone.
-- Accept: the table's edge is never deeper in the block's lower face than 1 % of the side; from 0.1 m below the table on
--         the centre's acceleration is that of gravity, 1e-3; energy drifts by less than 1e-3 of its peak.
-- Runs: elements=hex8 | elements=tet4
local args = deck.args { elements = { default = "hex8", doc = "hex8, wedge6 or tet4" } }
local side, density, g, push, stiffness = 0.1, 2500, 9.81, 4, 1e9
model "table" {}
box "table" { from = { -0.4, -0.2, -0.1 }, to = { 0, 0.2, 0 }, cells = { 4, 1, 1 }, elements = args.elements }
box "block" {
  from = { -side - 0.02, -side / 2, 0 }, to = { -0.02, side / 2, side }, cells = { 2, 2, 2 }, elements = args.elements,
}
material "rock" { region = { "table", "block" }, density = density*kg/m^3, young = 1*GPa, poisson = 0.2 }
joint "contact" {
  between = { "table", "block" }, law = "frictional", friction = 10*deg, normal_stiffness = stiffness*Pa/m,
  shear_stiffness = stiffness*Pa/m,
}
surface "held" { of = "table" }
fix { surface = "held", x = 0, y = 0, z = 0 }
gravity { x = push, z = -g }
stage "fall" {
  solve = dynamic { duration = 0.6*s, large_displacement = true, contact_damping = 1e-4*s, record_every = 0.002*s },
}
history "centre" { at = { -side / 2 - 0.02, 0, side / 2 }, record = { "displacement", "velocity" } }
for name, x in pairs { back = -side - 0.02, front = -0.02 } do
  history(name) { at = { x, 0, side }, record = { "displacement" } }
end

expect "lies on the edge" { that = function(result)
  local function of(name, component, from)
    local values = result.history(name).values("displacement." .. component, "fall")
    for i = 1, #values do values[i] = values[i] + from end
    return values
  end
  local xb, zb, xf, zf = of("back", "x", -side - 0.02), of("back", "z", side), of("front", "x", -0.02), of("front", "z", side)
  local deepest, tipped = 0, false
  for i = 1, #xb do
    local along, down = (xf[i] - xb[i]) / side, (zb[i] - zf[i]) / side
    local x, z = xb[i] - side * down, zb[i] - side * along  -- of the lower corner behind
    if x < 0 and x + side * along > 0 then
      deepest = math.max(deepest, along * -(z + down / along * x))
      tipped = tipped or down > 0.1
    end
  end
  return tipped and deepest < side / 100, string.format("%.2g m deep, allowed %.2g", deepest, side / 100)
end }
expect "falls freely" { that = function(result)
  local centre, first = result.history("centre"), nil
  local t, z = centre.values("seconds", "fall"), centre.values("displacement.z", "fall")
  local vx, vz = centre.values("velocity.x", "fall"), centre.values("velocity.z", "fall")
  for i = #t, 1, -1 do if z[i] < -0.1 - side then first = i end end
  if not first or first > #t - 5 then return false, "it did not fall" end
  local seconds = t[#t] - t[first]
  local off = math.max(math.abs((vz[#t] - vz[first]) / seconds + g), math.abs((vx[#t] - vx[first]) / seconds - push)) / g
  return off < 1e-3, string.format("acceleration off by %.2g, allowed 0.001", off)
end }
expect "energy drift" { that = function(result)
  local drift = result.stage("fall").energy_drift
  return drift < 1e-3, string.format("%.2g of the peak", drift)
end }
