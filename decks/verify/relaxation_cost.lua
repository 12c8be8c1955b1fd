-- Case P18: steps of dynamic relaxation, started from rest, for dam D0 to an unbalanced force of 1e-6.
-- Source: independent numpy program, adaptive damping 850 (312 elements) and 1700 (2496), local damping 2150 and 5200.
-- Accept: at most twice as many.
-- Runs: damping=adaptive | damping=local | damping=adaptive fine=true | damping=local fine=true
local args = deck.args {
  damping = { default = "adaptive", doc = "adaptive or local" },
  fine    = { default = false, doc = "2496 instead of 312 elements" },
}

local d0 = require "d0"
model "d0" {}
d0.body(args.fine and "r2_ny4" or "r1_ny2")
d0.supports()
d0.loads()
stage "gravity" { solve = static { tolerance = 1e-6, start = "rest", damping = args.damping } }

local reference = ({ adaptive = { 850, 1700 }, ["local"] = { 2150, 5200 } })[args.damping][args.fine and 2 or 1]
expect "steps" { that = function(result)
  local steps = result.stage("gravity").steps
  return steps <= 2 * reference, string.format("%d steps, numpy %d", steps, reference)
end }
