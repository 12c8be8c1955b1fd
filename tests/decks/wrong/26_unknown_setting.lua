-- ashlar check --set watr=155
local args = deck.args { water = { default = 150, unit = m, doc = "reservoir level" } }
model "column" {}
