-- Case arch: a semicircular arch of voussoirs under its own weight stands or falls with its thickness.
-- Source: theory of the thrust line: it stands if thickness over mean radius is at least 0.1075 (Milankovitch 1907).
-- Accept: at 0.12 the crown comes to rest less than 1 % of the radius down, at 0.095 it falls; energy drifts by less
--         than 1e-3 of its peak.
-- Runs: thickness=0.12 | thickness=0.095
local args = deck.args { thickness = { default = 0.12, doc = "over the mean radius" } }
local radius, voussoirs, width, g = 1, 28, 0.2, 9.81
local thickness = args.thickness * radius
local ramp, duration = 0.2, 1.5  -- s

-- x of the straight box: angle from the left springing; z: radius.
local function bent_x(x, y, z) return -z * math.cos(x) end
local function bent_z(x, y, z) return z * math.sin(x) end
local inner, outer = radius - thickness / 2, radius + thickness / 2
model "arch" {}
box "arch" {
  from = { 0, 0, inner }, to = { math.pi, width, outer }, cells = { voussoirs, 1, 1 }, x = bent_x, z = bent_z,
}
box "left"  { from = { -outer - 0.05, 0, -0.2 }, to = { -inner + 0.05, width, 0 }, cells = { 1, 1, 1 } }
box "right" { from = { inner - 0.05, 0, -0.2 }, to = { outer + 0.05, width, 0 }, cells = { 1, 1, 1 } }
material "stone" { region = { "arch", "left", "right" }, density = 2400*kg/m^3, young = 1*GPa, poisson = 0 }
crackable "joints" {
  region = "arch", law = "frictional", friction = 40*deg, normal_stiffness = 2e9*Pa/m, shear_stiffness = 1e9*Pa/m,
}
for _, side in ipairs { "left", "right" } do
  joint(side) {
    between = { "arch", side }, law = "frictional", friction = 40*deg, normal_stiffness = 2e9*Pa/m,
    shear_stiffness = 1e9*Pa/m,
  }
  surface("held " .. side) { of = side }
  fix { surface = "held " .. side, x = 0, y = 0, z = 0 }
end
gravity { z = in_time(function(t) return -g * math.min(t / ramp, 1) end) }
stage "weight" {
  solve = dynamic {
    duration = duration, large_displacement = true, mass_damping = 1/s, contact_damping = 2e-5*s, record_every = 0.01*s,
  },
}
history "crown" { at = { 0.01, width / 2, radius }, record = { "displacement", "velocity" } }
history "all" { record = { "energy" } }

expect "stands or falls" { that = function(result)
  local down = -result.history("crown").at("displacement.z", "weight") / radius
  local stands = args.thickness > 0.1075
  return stands and down < 0.01 or not stands and down > 0.3, string.format("crown %.3g of the radius down", down)
end }
expect "energy drift" { that = function(result)
  local drift = result.stage("weight").energy_drift
  return drift < 1e-3, string.format("%.2g of the peak", drift)
end }
