-- Case balance: a block on a joint of springs, under its weight and then water pressure in the joint.
-- Source: closed form: equal and opposite on both faces, the pressure takes traction from the springs and strains
--   nothing else: the block rises by pressure / normal_stiffness, and what the base carries stays its weight.
-- Accept: 1e-6 of the rise (double precision; the stages converge to 1e-9).
-- Runs: elements=hex8 | elements=wedge6 | elements=tet4
local args = deck.args { elements = { default = "hex8", doc = "hex8, wedge6 or tet4" } }
local stiffness, height = 1*GPa/m, 5*m
local head = 3*m
local water = 1000*kg/m^3 * 9.81*m/s^2 * head

model "joint_uplift" {}
box "rock"  { from = { 0, 0, -2*m }, to = { 4*m, 1*m, 0 }, cells = { 4, 1, 2 }, elements = args.elements }
box "block" { from = { 0, 0, 0 }, to = { 4*m, 1*m, height }, cells = { 4, 1, 5 }, elements = args.elements }
material "stone" { region = { "rock", "block" }, density = 2500*kg/m^3, young = 30*GPa, poisson = 0.2 }
joint "base" { between = { "rock", "block" }, law = "elastic", normal_stiffness = stiffness, shear_stiffness = stiffness }
surface "contact" { joint = "base" }
surface "underside" { joint = "base", of = "block" }
fix { surface = "rock.bottom", x = 0, y = 0, z = 0 }
gravity { z = -9.81 }
stage "weight" { solve = static { tolerance = 1e-9 }, reset_displacement = true }
stage "uplift" {
  apply = { uplift { surface = "contact", upstream_level = head, downstream_level = head } },
  solve = static { tolerance = 1e-9 },
}

history "top"     { at = { 0, 0, height }, record = { "displacement" } }
history "foot"    { surface = "rock.bottom", record = { "reaction" } }
history "pressed" { surface = "underside", record = { "load" } }
expect "rise" {
  history = "top", component = "displacement.z", stage = "uplift", value = water / stiffness, relative = 1e-6,
}
expect "base" { history = "foot", component = "reaction.z", stage = "uplift", value = 2500*9.81*28*N, relative = 1e-6 }
expect "load" { history = "pressed", component = "load.z", stage = "uplift", value = water * 4*m^2, relative = 1e-9 }
