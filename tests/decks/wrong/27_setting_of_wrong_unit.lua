-- ashlar check --set water=155*kPa
local args = deck.args { water = { default = 150, unit = m, doc = "reservoir level" } }
model "column" {}
