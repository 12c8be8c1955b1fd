-- Case D0 elastic: own weight and water. Displacement on the upstream line and on the middle line, from the bottom of the
--                  rock to the crest; stress in the first row of the dam; supports and water balanced by hand.
-- Source: CalculiX 2.20, plain bricks (C3D8) with consistent loads; weights and thrust by hand.
-- Accept: 1e-4 of the largest displacement or stress; 1e-5 for the balance.
-- Runs: | start=rest | fine=true
local args = deck.args {
  fine        = { default = false, doc = "2496 instead of 312 elements" },
  start       = { default = "search", doc = "search or rest (relaxation alone): the answer is the same" },
  damping     = { default = "adaptive", doc = "adaptive, local or viscous: the answer is the same" },
  step_factor = { default = 1, doc = "share of the pseudo time step" },
}
local d0 = require "d0"
model "d0" {}
d0.body(args.fine and "r2_ny4" or "r1_ny2")
d0.supports()
d0.loads()
stage "gravity" {
  solve = static { tolerance = 1e-8, start = args.start, damping = args.damping, step_factor = args.step_factor },
}
output "fields" { record = { "displacement", "stress" } }

local refinement = args.fine and 2 or 1
d0.each_row("d0_lines.csv", refinement, function(r)
  if r.z == -60 then return end  -- held
  local name = string.format("x = %.3g, z = %.4g", r.x, r.z)
  history(name) { at = { r.x, 0, r.z }, record = { "displacement" } }
  for axis, value in pairs { x = r.ux, z = r.uz } do
    expect(name .. ": u_" .. axis) {
      history = name, component = "displacement." .. axis, value = value, tolerance = 1e-4 * 4.42e-3,
    }
  end
end)
d0.each_row("d0_base_row.csv", refinement, function(r)
  local name = string.format("row over the base, x = %.4g", r.x)
  history(name) { at = { r.x, r.y, r.z }, record = { "stress" } }
  for _, component in ipairs { "xx", "yy", "zz", "zx" } do
    expect(name .. ": s_" .. component) {
      history = name, component = "stress." .. component, value = r[component], tolerance = 1e-4 * 0.8103e6,
    }
  end
end)

-- Balance, per 12 m of thickness: 168 x 60 m of rock, 48 x 50 / 2 + 8 x (50 / 2 + 10) m of dam; the face is upright, so
-- water weighs nothing on it; its thrust rho g h^2 / 2 acts at a third of the depth.
local g, thrust = 9.81, 1000 * 9.81 * 55^2 / 2 * 12
history "support" { surface = "bottom", record = { "reaction" } }
history "water"   { surface = "up_wet", record = { "load", "load_moment" } }
expect "weight on the support" {
  history = "support", component = "reaction.z", relative = 1e-5,
  value = (168 * 60 * 2650 + (28 * 50 + 8 * 10) * 2400) * 12 * g,
}
expect "water thrust" { history = "water", component = "load.x", value = thrust, relative = 1e-5 }
expect "water lifts nothing" { history = "water", component = "load.z", value = 0*N, tolerance = 1e-5 * thrust }
expect "thrust acts at z = 18.333" {
  history = "water", component = "load_moment.y", value = thrust * 55 / 3, relative = 1e-5,
}
