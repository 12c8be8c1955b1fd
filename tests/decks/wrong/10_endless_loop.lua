local size = 1*m
while size > 0 do
  size = size + 1*mm
end
