-- Case P13: critical time step of a free unit cube, E 30 GPa, nu 0.2, rho 2400: one hex8, two wedge6 or six tet4.
-- Source: largest eigenvalue of lumped mass and stiffness in an independent numpy program:
--         2 / omega = 2.19089e-4 s (hex8), 1.77726e-4 s (wedge6), 1.73470e-4 s (tet4).
-- Accept: the stable step that is found, and the step taken, at most that and at least half of it.
-- Runs: elements=hex8 | elements=wedge6 | elements=tet4
-- Beyond: --set factor=1.5 stops with runaway energy, its place and step.
local args = deck.args {
  elements = { default = "hex8", doc = "hex8, wedge6 or tet4" },
  factor   = { default = 0.9, doc = "step over the stable one" },
}

model "critical_step" {}
box "cube" { from = { 0, 0, 0 }, to = { 1*m, 1*m, 1*m }, cells = { 1, 1, 1 }, elements = args.elements }
material "concrete" { region = "cube", young = 30*GPa, poisson = 0.2, density = 2400*kg/m^3 }
surface "top" { of = "cube", side = "top" }
traction { surface = "top", x = 10*kPa, y = 20*kPa, z = 50*kPa }
stage "fly" { solve = dynamic { duration = 0.5*s, time_factor = args.factor } }

local critical = ({ hex8 = 2.19089e-4, wedge6 = 1.77726e-4, tet4 = 1.73470e-4 })[args.elements]
expect "step" { that = function(result)
  local fly = result.stage("fly")
  return fly.stable_step <= critical and fly.time_step >= critical / 2,
         string.format("stable %.5e s, taken %.5e s, critical %.5e s", fly.stable_step, fly.time_step, critical)
end }
expect "energy" { that = function(result)
  local drift = result.stage("fly").energy_drift
  return drift < 1e-10, string.format("drift %.1e of the peak, wanted 1e-10", drift)
end }
