-- Case strength reduction: a cube under axial pressure of Mohr-Coulomb material, and two cubes on a rough joint that are
--   pressed and pushed along it.
-- Source: closed form. Cube: pressure = 2 (c / F) cos(phi') / (1 - sin(phi')), tan(phi') = tan(phi) / F; joint:
--   F = pressure tan(phi) / push.
-- Accept: the bracket of 0.005 holds the factor, within 0.5 %.
-- Runs: of=cube | of=cube elements=tet4 | of=joint
local args = deck.args {
  of       = { default = "cube", doc = "cube or joint" },
  elements = { default = "hex8", doc = "hex8, wedge6 or tet4" },
}
model "strength_factor" {}
local wanted
if args.of == "cube" then
  local cohesion, friction, pressed = 1e6, math.rad(30), 2e6
  box "cube" { from = { 0, 0, 0 }, to = { 1, 1, 1 }, cells = { 1, 1, 1 }, elements = args.elements }
  material "rock" {
    region = "cube", law = "mohr_coulomb", density = 2500*kg/m^3, young = 10*GPa, poisson = 0.2,
    cohesion = cohesion*Pa, friction = friction,
  }
  fix { surface = "cube.left", x = 0 }
  fix { surface = "cube.front", y = 0 }
  fix { surface = "cube.bottom", z = 0 }
  pressure { surface = "cube.top", value = pressed*Pa }
  local low, high = 1, 4
  for _ = 1, 60 do
    wanted = (low + high) / 2
    local angle = math.atan(math.tan(friction) / wanted)
    local strength = 2 * cohesion / wanted * math.cos(angle) / (1 - math.sin(angle))
    if strength > pressed then low = wanted else high = wanted end
  end
else
  local friction, pressed, pushed = math.rad(35), 1e6, 0.4e6
  box "under" { from = { 0, 0, 0 }, to = { 1, 1, 1 }, cells = { 2, 2, 2 } }
  box "over" { from = { 0, 0, 1 }, to = { 1, 1, 1.2 }, cells = { 2, 2, 1 } }
  material "rock" { region = { "under", "over" }, density = 2500*kg/m^3, young = 10*GPa, poisson = 0.2 }
  joint "joint" { between = { "under", "over" }, law = "frictional", friction = friction }
  fix { surface = "under.bottom", x = 0, y = 0, z = 0 }
  traction { surface = "over.top", x = pushed*Pa, z = -pressed*Pa }
  wanted = pressed * math.tan(friction) / pushed
end
stage "safety" { solve = strength_reduction { between = { 1, 3 }, width = 0.005, max_steps = 4000 } }
expect "safety factor" { that = function(result)
  local s = result.stage("safety")
  local middle = (s.safety_factor + s.falling_factor) / 2
  return s.converged and math.abs(middle / wanted - 1) < 0.005,
    string.format("stands at %.5g, falls at %.5g, closed form %.5g", s.safety_factor, s.falling_factor, wanted)
end }
