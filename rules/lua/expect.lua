-- What a test file x_test.lua beside x.lua sees in addition: made-up planes, cases, expectations.
--
--   local desk = flat { x = 0, y = 0, z = 0.74, length = 1.6, width = 0.8 }
--   local screen = upright { x = 0, y = 0.2, z = 1.0, length = 0.5, width = 0.3, facing = -90 }
--   case("a screen is above its desk", function() expect.holds(screen, desk) end)
--
-- Takes make(x, y, z, nx, ny, nz, ax, ay, az, length, width) -> plane, ask(…) -> degree or value, and the globals
-- to add to. Returns the list of cases in the order written.
local make, ask, add = ...
local sin, cos, rad, format = math.sin, math.cos, math.rad, string.format

local cases = {}

local function number(t, key, otherwise)
  local value = t[key]
  if value == nil then value = otherwise end
  if value == nil then error(format("a plane needs '%s'", key), 3) end
  return value
end

local known = { x = true, y = true, z = true, length = true, width = true, facing = true, lean = true, turn = true,
  rmse = true }

local function check(t)
  for key in pairs(t) do
    if not known[key] then
      error(format("a plane has no field '%s'; it has x, y, z, length, width, facing, lean, turn, rmse", key), 3)
    end
  end
end

-- A level rectangle: length along x unless turned by `turn` degrees; tilted by `lean` degrees towards `facing`.
local function flat(t)
  check(t)
  local lean, facing, turn = rad(number(t, "lean", 0)), rad(number(t, "facing", 0)), rad(number(t, "turn", 0))
  return make(number(t, "x"), number(t, "y"), number(t, "z"),
    sin(lean) * cos(facing), sin(lean) * sin(facing), cos(lean), cos(turn), sin(turn), 0,
    number(t, "length"), number(t, "width"), number(t, "rmse", 0))
end

-- An upright rectangle: length level, width upwards; its normal points to `facing` degrees (0 = x, 90 = y) and, when it
-- leans back by `lean` degrees, upwards.
local function upright(t)
  check(t)
  local lean, facing = rad(number(t, "lean", 0)), rad(number(t, "facing", 0))
  return make(number(t, "x"), number(t, "y"), number(t, "z"),
    cos(lean) * cos(facing), cos(lean) * sin(facing), sin(lean), -sin(facing), cos(facing), 0,
    number(t, "length"), number(t, "width"), number(t, "rmse", 0))
end

local expect = {}

-- The degree (of a feature: the value) lies from low to high.
function expect.between(low, high, ...)
  local d = ask(...)
  if not (d >= low and d <= high) then error(format("got %.4g, expected %.4g to %.4g", d, low, high), 2) end
end

function expect.holds(a, b)
  local d = ask(a, b)
  if d < 0.9 then error(format("got %.4g, expected that it holds (0.9 or more)", d), 2) end
end

function expect.fails(a, b)
  local d = ask(a, b)
  if d > 0.1 then error(format("got %.4g, expected that it does not hold (0.1 or less)", d), 2) end
end

function expect.value(wanted, plane, tolerance)
  local d = ask(plane)
  local off = d - wanted
  if not (off <= (tolerance or 1e-6) and -off <= (tolerance or 1e-6)) then
    error(format("got %.6g, expected %.6g", d, wanted), 2)
  end
end

local function case(name, body)
  if type(name) ~= "string" or type(body) ~= "function" then error("write case(\"a sentence\", function() … end)", 2) end
  cases[#cases + 1] = { name = name, body = body }
end

add("flat", flat)
add("upright", upright)
add("expect", expect)
add("case", case)
return cases
