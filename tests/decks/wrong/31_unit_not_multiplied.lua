model "column" {}
local young = 30GPa
