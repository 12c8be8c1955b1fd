-- What every deck starts with. Runs before the deck with the whole Lua library in sight, and closes what a deck must
-- not reach: files, processes, bytecode, and everything whose order or value changes from run to run.

local rawnext, rawtype, sort = next, type, table.sort
local unprotected_setmetatable = setmetatable

-- Keys in a fixed order: numbers, then strings, then booleans. Lua's own order depends on memory addresses.
local rank = { number = 1, string = 2, boolean = 3 }
function pairs(t)
  if rawtype(t) ~= "table" then error("pairs needs a table, not a " .. rawtype(t), 2) end
  local keys = {}
  for key in rawnext, t do
    if not rank[rawtype(key)] then error("pairs: keys must be numbers, strings or booleans", 2) end
    keys[#keys + 1] = key
  end
  sort(keys, function(a, b)
    local ra, rb = rank[rawtype(a)], rank[rawtype(b)]
    if ra ~= rb then return ra < rb end
    if ra == 3 then return a and not b end
    return a < b
  end)
  local i = 0
  return function()
    i = i + 1
    if keys[i] ~= nil then return keys[i], t[keys[i]] end
  end
end

-- Finalizers would run outside the instruction limit.
function setmetatable(t, meta)
  if meta and meta.__gc then error("__gc is not part of the deck language", 2) end
  return unprotected_setmetatable(t, meta)
end

-- These also work on quantities.
local plain = { abs = math.abs, sqrt = math.sqrt }
function math.abs(x) if rawtype(x) == "number" then return plain.abs(x) end return x < 0 and -x or x end
function math.sqrt(x) if rawtype(x) == "number" then return plain.sqrt(x) end return x ^ 0.5 end
function math.max(first, ...)
  for _, x in ipairs { ... } do if first < x then first = x end end
  return first
end
function math.min(first, ...)
  for _, x in ipairs { ... } do if x < first then first = x end end
  return first
end

local seed = math.randomseed
seed(1)
function math.randomseed(x)
  if x == nil then error("math.randomseed needs a number: a deck gives the same model every time", 2) end
  seed(x)
end

-- Value at x of the polyline through (xs[i], ys[i]), xs ascending; constant beyond its ends.
function interpolate(xs, ys, x)
  if #xs ~= #ys or #xs == 0 then error("interpolate needs two lists of the same length", 2) end
  if x <= xs[1] then return ys[1] end
  for i = 2, #xs do
    if not (xs[i - 1] < xs[i]) then error("interpolate needs ascending places", 2) end
    if x <= xs[i] then return ys[i - 1] + (ys[i] - ys[i - 1]) * ((x - xs[i - 1]) / (xs[i] - xs[i - 1])) end
  end
  return ys[#ys]
end

string.dump = nil
for _, name in ipairs { "load", "loadfile", "dofile", "collectgarbage", "pcall", "xpcall", "next", "rawset", "rawget",
                        "rawequal", "rawlen", "getmetatable", "warn", "_G" } do
  _ENV[name] = nil
end
