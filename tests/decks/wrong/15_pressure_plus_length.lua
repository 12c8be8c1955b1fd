model "column" {}
local strength = 3*MPa + 2*m
