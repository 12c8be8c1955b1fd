-- Case P18: steps of dynamic relaxation, started from rest, for dam D0 to an unbalanced force of 1e-6.
-- Source: independent numpy program with the same mass on the same mesh, adaptive and local damping.
-- Accept: at most twice as many.
-- Runs: damping=adaptive | damping=local | damping=adaptive fine=true | damping=local fine=true | damping=adaptive elements=wedge6 | damping=local elements=wedge6 | damping=adaptive elements=tet4 | damping=local elements=tet4
local args = deck.args {
  damping  = { default = "adaptive", doc = "adaptive or local" },
  elements = { default = "hex8", doc = "hex8, wedge6 or tet4" },
  fine     = { default = false, doc = "2496 instead of 312 elements; of hex8" },
}

local d0 = require "d0"
model "d0" {}
if args.elements == "hex8" then
  d0.body(args.fine and "r2_ny4" or "r1_ny2")
else
  d0.body_of(args.elements)
end
d0.supports()
d0.loads()
stage "gravity" { solve = static { tolerance = 1e-6, start = "rest", damping = args.damping } }

local reference = ({
  hex8   = args.fine and { adaptive = 1700, ["local"] = 5200 } or { adaptive = 850, ["local"] = 2150 },
  wedge6 = { adaptive = 900, ["local"] = 2500 },
  tet4   = { adaptive = 950, ["local"] = 3750 },
})[args.elements][args.damping]
expect "steps" { that = function(result)
  local steps = result.stage("gravity").steps
  return steps <= 2 * reference, string.format("%d steps, numpy %d", steps, reference)
end }
