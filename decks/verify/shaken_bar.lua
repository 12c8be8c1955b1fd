-- Case shaken bar: a bar of 10 m, held at one end and at rest, under a load that swings at 60 Hz: a traction at its tip,
-- its weight along itself, or its foot moved; displacement of the tip.
-- Source: closed form, sum over the bar's modes.
-- Accept: 1 % of the largest displacement; energy to 1e-9 of its peak.
-- Runs: load=traction | load=table | load=place | load=weight | load=foot | load=foot place=true
local args = deck.args {
  load  = { default = "traction", doc = "traction, table, place, weight or foot" },
  place = { default = false, doc = "the foot's movement as a function of place and time" },
}

local length, young, density, omega = 10, 30e9, 2400, 2 * math.pi * 60
local wave = math.sqrt(young / density)
local stress, weight, way = 1e6, 100, 1e-3

model "shaken_bar" {}
box "bar" { from = { 0, 0, 0 }, to = { length, 0.2, 0.2 }, cells = { 50, 1, 1 } }
material "concrete" { region = "bar", young = young, poisson = 0, density = density }
surface "foot"   { of = "bar", side = "left" }
surface "tip"    { of = "bar", side = "right" }
surface "front"  { of = "bar", side = "front" }
surface "bottom" { of = "bar", side = "bottom" }
fix { surface = "front", y = 0 }
fix { surface = "bottom", z = 0 }
local function swing(t) return math.sin(omega * t) end
if args.load == "foot" then
  local function move(t) return way * (1 - math.cos(omega * t)) end
  displacement { surface = "foot", x = args.place and function(x, y, z, t) return move(t) end or in_time(move) }
else
  fix { surface = "foot", x = 0 }
end
if args.load == "traction" then
  traction { surface = "tip", x = in_time(function(t) return stress * swing(t) end) }
elseif args.load == "table" then
  local rows = {}
  for i = 0, 500 do rows[i + 1] = { i * 1e-4, stress * swing(i * 1e-4) } end
  traction { surface = "tip", x = rows }
elseif args.load == "place" then
  traction { surface = "tip", x = function(x, y, z, t) return stress * swing(t) end }
elseif args.load == "weight" then
  gravity { x = in_time(function(t) return weight * swing(t) end) }
end
stage "swing" { solve = dynamic { duration = 0.05*s, record_every = 5e-4*s } }

local function exact(t)
  local sum = args.load == "foot" and way * (1 - math.cos(omega * t)) or 0
  for n = 1, 400 do
    local k = 2 * n - 1
    local w, share = k * math.pi * wave / (2 * length), (n % 2 == 1 and 4 or -4) / (k * math.pi)
    local forced = math.sin(omega * t) - omega / w * math.sin(w * t)
    if args.load == "weight" then
      sum = sum + share * weight * forced / (w^2 - omega^2)
    elseif args.load == "foot" then
      sum = sum - share * way * omega^2 * (math.cos(omega * t) - math.cos(w * t)) / (w^2 - omega^2)
    else
      sum = sum + 2 * stress / (density * length) * forced / (w^2 - omega^2)
    end
  end
  return sum
end
history "tip" { at = { length, 0, 0 }, record = { "displacement" } }
expect "tip" { that = function(result)
  local tip = result.history("tip")
  local seconds, u = tip.values("seconds", "swing"), tip.values("displacement.x", "swing")
  local worst, largest = 0, 0
  for i = 1, #u do
    local wanted = exact(seconds[i])
    worst, largest = math.max(worst, math.abs(u[i] - wanted)), math.max(largest, math.abs(wanted))
  end
  return worst < 0.01 * largest, string.format("%.2f %% of %.3g m, wanted 1 %%", 100 * worst / largest, largest)
end }
expect "energy" { that = function(result)
  local drift = result.stage("swing").energy_drift
  return drift < 1e-9, string.format("drift %.1e of the peak, wanted 1e-9", drift)
end }
