-- Case D0 exploded: dam D0 with every element its own block, tied to its neighbours by springs at the corners of each face.
-- Source: independent numpy program, direct sparse solution of the same springs (area of a corner = integral of N dA).
-- Accept: 2e-4 of each crest displacement.
-- Runs: normal=1e10 shear=1e10 | normal=1e11 shear=1e11 | normal=1e12 shear=1e12 | normal=1e11 shear=4e10 | start=rest
local args = deck.args {
  normal = { default = 1e11, unit = Pa/m, doc = "spring stiffness across faces" },
  shear  = { default = 1e11, unit = Pa/m, doc = "spring stiffness along faces" },
  start  = { default = "search", doc = "search or rest (relaxation alone): the answer is the same" },
}
local d0 = require "d0"
model "d0_exploded" {}
d0.body "r1_ny2"
d0.supports()
d0.loads()
d0.explode({ normal_stiffness = args.normal, shear_stiffness = args.shear }, { law = "elastic" })
stage "gravity" { solve = static { tolerance = 1e-8, start = args.start } }

local reference = {
  ["1e+10 1e+10"] = { x = 2.548732*mm, z = -5.470499*mm }, ["1e+11 1e+11"] = { x = 2.322793*mm, z = -4.526152*mm },
  ["1e+12 1e+12"] = { x = 2.299855*mm, z = -4.430543*mm }, ["1e+11 4e+10"] = { x = 2.355786*mm, z = -4.529769*mm },
}
local key = string.format("%.0e %.0e", args.normal / (Pa/m), args.shear / (Pa/m))
history "crest" { at = { 0, 0, 60*m }, record = { "displacement" } }
for axis, value in pairs(reference[key]) do
  expect("crest u_" .. axis) { history = "crest", component = "displacement." .. axis, value = value, relative = 2e-4 }
end
