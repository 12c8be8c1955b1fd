-- Case P16: a bar of 10 m, held at one end, swings in its mode n.
-- Source: closed form, f = (2 n - 1) c / 4 L with c = sqrt(E / rho): 88.388, 265.17, 441.94 Hz.
-- Accept: 0.5 %.
-- Runs: mode=1 | mode=2 | mode=3 | elements=wedge6 mode=1 | elements=wedge6 mode=3 | elements=tet4 mode=1 | elements=tet4 mode=3
local args = deck.args {
  elements = { default = "hex8", doc = "hex8, wedge6 or tet4" },
  mode     = { default = 1, doc = "1, 2 or 3" },
}

local length, young, density = 10, 30e9, 2400
local exact = (2 * args.mode - 1) * math.sqrt(young / density) / (4 * length)

model "bar_modes" {}
box "bar" { from = { 0, 0, 0 }, to = { length, 0.1, 0.1 }, cells = { 50, 1, 1 }, elements = args.elements }
material "concrete" { region = "bar", young = young, poisson = 0, density = density }
surface "held"   { of = "bar", side = "left" }
surface "front"  { of = "bar", side = "front" }
surface "bottom" { of = "bar", side = "bottom" }
surface "sides"  { of = "bar", side = { "front", "back" } }
fix { surface = "held", x = 0 }
fix { surface = "front", y = 0 }
fix { surface = "bottom", z = 0 }
-- Every node lies on the sides: the bar is drawn into the shape of its mode, then let go.
displacement "shape" { surface = "sides", x = function(x, y, z)
  return 1e-3 * math.sin((2 * args.mode - 1) * math.pi * x / (2 * length))
end }
stage "draw"  { solve = static {} }
stage "swing" { remove = "shape", solve = dynamic { duration = 10.25 / exact, record_every = 0.02 / exact } }

history "tip" { at = { length, 0, 0 }, record = { "displacement" } }
expect "frequency" { that = function(result)
  local tip = result.history("tip")
  local seconds, u = tip.values("seconds", "swing"), tip.values("displacement.x", "swing")
  local zeros = {}
  for i = 2, #u do
    if (u[i] > 0) ~= (u[i-1] > 0) then
      zeros[#zeros + 1] = seconds[i-1] + (seconds[i] - seconds[i-1]) * u[i-1] / (u[i-1] - u[i])
    end
  end
  local found = 0.5 * (#zeros - 1) / (zeros[#zeros] - zeros[1])
  return #zeros >= 19 and math.abs(found / exact - 1) < 0.005,
         string.format("%.3f Hz over %d half swings, closed form %.3f Hz", found, #zeros - 1, exact)
end }
expect "energy" { that = function(result)
  local drift = result.stage("swing").energy_drift
  return drift < 1e-10, string.format("drift %.1e of the peak, wanted 1e-10", drift)
end }
