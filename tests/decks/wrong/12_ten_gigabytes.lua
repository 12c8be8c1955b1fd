model "column" {}
local parts = {}
for i = 1, 10 do
  parts[i] = string.rep("x", 1000*1000*1000)
end
