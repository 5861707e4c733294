-- What a rule file sees. Run once in each fresh state, before the file, while Lua's own libraries are still whole; all
-- that is not handed on here stays out of reach. Takes the host's table of functions:
--   geometry        functions over two planes
--   nearest         (word, list of words) -> the word meant, or nil
--   line_of         (field) -> "file:line: " at which the rule file sets a field, or nil
--   base            (name) -> the table given to relation{} by the built-in file of that name, or nil
--   trusted         whether the file comes with the program, so that nothing need be kept from it
-- Returns environment (the globals of the file) and library (what the host itself calls).
local host = ...

local type, next, error, select, tostring, rawget = type, next, error, select, tostring, rawget
local setmetatable, getmetatable = setmetatable, getmetatable
local format, find, sub = string.format, string.find, string.sub
local huge, mathtype = math.huge, math.type

-- Small helpers -------------------------------------------------------------------------------------------------------

-- Stable, by merging: the order never depends on the clock, as table.sort's does, and it can be interrupted.
local function sort(list, before)
  before = before or function(a, b) return a < b end
  local n, width = #list, 1
  local from, to = list, {}
  while width < n do
    for low = 1, n, 2 * width do
      local i, middle = low, low + width
      local j, high = middle, low + 2 * width
      if middle > n + 1 then middle = n + 1 end
      if high > n + 1 then high = n + 1 end
      for k = low, high - 1 do
        if i < middle and (j >= high or not before(from[j], from[i])) then
          to[k], i = from[i], i + 1
        else
          to[k], j = from[j], j + 1
        end
      end
    end
    from, to, width = to, from, 2 * width
  end
  if from ~= list then
    for i = 1, n do list[i] = from[i] end
  end
end

local rank = { boolean = 1, number = 2, string = 3 }

local function key_before(a, b)
  local kind_a, kind_b = type(a), type(b)
  if kind_a ~= kind_b then return rank[kind_a] < rank[kind_b] end
  if kind_a == "boolean" then return a and not b end
  return a < b
end

local function sorted_keys(t)
  local keys = {}
  for key in next, t do
    if not rank[type(key)] then error("pairs: a key is a " .. type(key) .. "; use texts or numbers as keys", 3) end
    keys[#keys + 1] = key
  end
  sort(keys, key_before)
  return keys
end

local function meant(word, known)
  local found = type(word) == "string" and host.nearest(word, known)
  return found and format("; did you mean '%s'?", found) or ""
end

local patterns = "; rules have no pattern functions, which can run for ever"
local left_out = {
  string = { find = patterns, match = patterns, gmatch = patterns, gsub = patterns, rep = "; its result could be of any size" },
  math = { random = "; the same planes give the same answer", randomseed = "; the same planes give the same answer" },
}

-- A table that answers unknown names with an error instead of nil.
local function strict(t, what)
  return setmetatable(t, { __metatable = false, __index = function(_, key)
    local why = left_out[what] and left_out[what][key]
    error(format("%s has no '%s'%s", what, tostring(key), why or meant(key, sorted_keys(t))), 2)
  end })
end

local function read_only(values, what)
  strict(values, what)
  return setmetatable({}, { __metatable = false, __index = values, __newindex = function()
    error(what .. " cannot be changed", 2)
  end })
end

local function picked(library, name, ...)
  local t = {}
  for i = 1, select("#", ...) do
    local key = select(i, ...)
    t[key] = library[key]
  end
  return strict(t, name)
end

-- Globals -------------------------------------------------------------------------------------------------------------

local environment = {
  assert = assert, error = error, ipairs = ipairs, pcall = pcall, rawget = rawget, rawlen = rawlen, select = select,
  tonumber = tonumber, type = type, _VERSION = _VERSION,
  math = picked(math, "math", "abs", "acos", "asin", "atan", "ceil", "cos", "deg", "exp", "floor", "fmod", "huge",
    "log", "max", "maxinteger", "min", "mininteger", "modf", "pi", "rad", "sin", "sqrt", "tan", "tointeger", "type",
    "ult"),
  string = picked(string, "string", "byte", "char", "format", "len", "lower", "reverse", "sub", "upper"),
  table = picked(table, "table", "concat", "insert", "pack", "remove", "sort", "unpack"),
  utf8 = picked(utf8, "utf8", "char", "charpattern", "codepoint", "codes", "len", "offset"),
  geometry = strict(host.geometry, "geometry"),
}
environment._G = environment

-- In the order of the keys, which is the same in every run: booleans, numbers, texts.
function environment.pairs(t)
  if type(t) ~= "table" then error("pairs: a table is needed, not a " .. type(t), 2) end
  local keys, i = sorted_keys(t), 0
  return function()
    i = i + 1
    local key = keys[i]
    if key ~= nil then return key, t[key] end
  end
end

-- Without addresses, which differ from run to run.
function environment.tostring(value)
  local kind = type(value)
  if kind == "table" or kind == "function" then return kind end
  return tostring(value)
end

function environment.string.format(pattern, ...)
  if type(pattern) ~= "string" then error("string.format: the first argument must be a text", 2) end
  if find(pattern, "%p", 1, true) then error("string.format: %p is not available in rules", 2) end
  local n, values = select("#", ...), { ... }
  for i = 1, n do
    if type(values[i]) == "table" or type(values[i]) == "function" then values[i] = type(values[i]) end
  end
  return format(pattern, table.unpack(values, 1, n))
end

environment.table.sort = function(list, before)
  if type(list) ~= "table" then error("table.sort: a table is needed, not a " .. type(list), 2) end
  sort(list, before)
end

-- 1 where value is at or below `full`, 0 at or beyond `none`, and a straight line in between; with full > none the
-- other way round. The usual shape of a judgement that fades.
function environment.falloff(value, full, none)
  if full == none then return value <= full and 1 or 0 end
  local share = (none - value) / (none - full)
  if share >= 1 then return 1 end
  if share > 0 then return share end
  return 0
end

-- Validation of what a file declares ----------------------------------------------------------------------------------

local function fail(kind, name, field, message)
  local where = host.line_of(field) or host.line_of(kind) or ""
  error(format("%s%s%s: %s", where, kind, type(name) == "string" and " '" .. name .. "'" or "", message), 0)
end

local function describe(value)
  if type(value) == "string" then return "'" .. sub(value, 1, 40) .. "'" end
  if type(value) == "table" or type(value) == "function" then return "a " .. type(value) end
  return tostring(value)
end

local checks = {
  api = function(v) return v == 1, "is the version of the rule language, which must be 1" end,
  name = function(v)
    return type(v) == "string" and find(v, "^[%a_][%w_]*$") ~= nil, "must be a text of letters, digits and '_'"
  end,
  text = function(v) return type(v) == "string" and v ~= "", "must be a text that says what it means" end,
  distance = function(v) return mathtype(v) ~= nil and v >= 0, "must be a distance in metres, 0 or more" end,
  flag = function(v) return type(v) == "boolean", "must be true or false" end,
  call = function(v) return type(v) == "function", "must be a function" end,
  number = function(v) return mathtype(v) ~= nil and v > -huge and v < huge, "must be a number" end,
  scale = function(v) return v == "linear" or v == "log" or v == "circular", "must be 'linear', 'log' or 'circular'" end,
}

local relation_fields = {
  api = checks.api, name = checks.name, summary = checks.text, within = checks.distance,
  within_plan = checks.distance, symmetric = checks.flag, applies = checks.call, degree = checks.call,
  extends = checks.name, converse = checks.name,
}
local relation_needs = { "api", "name", "summary", "degree" }

local feature_fields = {
  name = checks.name, unit = checks.text, summary = checks.text, scale = checks.scale, low = checks.number,
  high = checks.number, value = checks.call, api = checks.api,
}
local feature_needs = { "name", "unit", "low", "high", "value" }

local function check_fields(kind, t, fields, needs)
  for _, key in next, sorted_keys(t) do
    local check = fields[key]
    if check then
      local good, should = check(t[key])
      if not good then fail(kind, t.name, key, format("field '%s' %s, not %s", key, should, describe(t[key]))) end
    end
  end
  for _, key in next, needs do
    if t[key] == nil then fail(kind, t.name, kind, format("field '%s' is missing", key)) end
  end
end

local function unknown_field(kind, t, key, known, why)
  fail(kind, t.name, key, format("unknown field '%s'%s%s", tostring(key), why or "", meant(key, known)))
end

-- Tolerances are the fields of a relation that are numbers or booleans and not part of the language.
local function tolerances_of(t, base)
  local values = {}
  local known = sorted_keys(relation_fields)
  for _, key in next, sorted_keys(t) do
    if not relation_fields[key] then
      local kind = type(t[key])
      if base and base[key] == nil then
        local all = sorted_keys(base)
        for _, word in next, known do all[#all + 1] = word end
        unknown_field("relation", t, key, all, format(": '%s' has no such tolerance", base.name))
      end
      if kind ~= "number" and kind ~= "boolean" then unknown_field("relation", t, key, known) end
      if kind == "number" then
        local good, should = checks.number(t[key])
        if not good then fail("relation", t.name, key, format("tolerance '%s' %s, not %s", key, should, describe(t[key]))) end
        local near = host.nearest(key, { "api", "within", "within_plan" }, 1)
        if near then unknown_field("relation", t, key, { near }) end
      end
      values[key] = t[key]
    end
  end
  return values
end

local function with_base(t, field)
  local base = host.base(t[field])
  if not base then
    local does = field == "extends" and "extends" or "is the converse of"
    fail("relation", t.name, field, format("%s '%s', which is no built-in relation", does, tostring(t[field])))
  end
  local whole = {}
  for _, key in next, sorted_keys(base) do whole[key] = base[key] end
  for _, key in next, sorted_keys(t) do whole[key] = t[key] end
  if t.name == nil then fail("relation", nil, "relation", "field 'name' is missing") end
  return whole, base
end

-- The other way round: from a to b it is what the other relation is from b to a.
local function with_converse(t)
  if t.extends ~= nil then
    fail("relation", t.name, "extends", "has a converse already: name one of the two, 'extends' or 'converse'")
  end
  for _, field in next, { "degree", "applies", "symmetric" } do
    if t[field] ~= nil then
      fail("relation", t.name, field,
        format("field '%s' comes from '%s', the other way round; leave it out", field, tostring(t.converse)))
    end
  end
  local whole, base = with_base(t, "converse")
  if base.symmetric then
    fail("relation", t.name, "converse", format("'%s' is symmetric, so it is its own converse", t.converse))
  end
  if base.converse then
    fail("relation", t.name, "converse", format("'%s' is a converse itself; name '%s'", t.converse, base.converse))
  end
  local applies, degree = base.applies, base.degree
  whole.applies = applies and function(a, b, r) return applies(b, a, r) end
  whole.degree = function(a, b, r) return degree(b, a, r) end
  return whole, base
end

-- Whether a converse has nothing of its own: then its facts are those of the other relation.
local function is_plain(t)
  for _, key in next, sorted_keys(t) do
    if key ~= "api" and key ~= "name" and key ~= "summary" and key ~= "converse" then return false end
  end
  return true
end

local function checked_degree(d)
  if d == true then return 1 end
  if d == false then return 0 end
  if mathtype(d) == nil then
    error(format("degree returned %s; it must return a number from 0 to 1, true or false", describe(d)), 0)
  end
  if not (d >= 0 and d <= 1 + 1e-9) then
    error(format("degree returned %s; it must lie in 0 to 1", describe(d)), 0)
  end
  return d > 1 and 1 or d
end

local function asker(r, self)
  local applies, degree = r.applies, r.degree
  return function(a, b)
    if applies then
      local may = applies(a, b, self)
      if may == false then return 0 end
      if may ~= true then error(format("applies returned %s; it must return true or false", describe(may)), 0) end
    end
    return checked_degree(degree(a, b, self))
  end
end

-- `return relation { … }`: the table that the host takes over.
function environment.relation(t)
  if type(t) ~= "table" then error("relation: write relation { name = …, … } with braces", 2) end
  local base
  local whole = t
  if t.converse ~= nil then
    whole, base = with_converse(t)
  elseif t.extends ~= nil then
    whole, base = with_base(t, "extends")
  end
  local tolerances = tolerances_of(t, base)
  check_fields("relation", whole, relation_fields, relation_needs)
  if base then tolerances = tolerances_of(whole) end
  if t.converse then  -- set there, it holds here
    for key, value in next, host.overrides(t.converse) do
      if tolerances[key] ~= nil and t[key] == nil then tolerances[key] = value end
    end
  end
  for key, value in next, host.overrides(whole.name) do
    if tolerances[key] == nil then
      error(format("setting '%s.%s': the relation has no such tolerance%s", whole.name, key,
        meant(key, sorted_keys(tolerances))), 0)
    end
    tolerances[key] = value
  end
  local guarded = host.trusted and strict or read_only
  local self = guarded(tolerances, "relation '" .. whole.name .. "'")
  return {
    kind = "relation", declared = whole, name = whole.name, summary = whole.summary, within = whole.within or huge,
    within_plan = whole.within_plan or huge, symmetric = whole.symmetric or false, ask = asker(whole, self),
    applies = whole.applies, degree = whole.degree, self = self, tolerances = tolerances,
    converse = t.converse, plain = t.converse and is_plain(t) or false,
  }
end

-- `return feature { … }`
function environment.feature(t)
  if type(t) ~= "table" then error("feature: write feature { name = …, … } with braces", 2) end
  local known = sorted_keys(feature_fields)
  for _, key in next, sorted_keys(t) do
    if not feature_fields[key] then unknown_field("feature", t, key, known) end
  end
  check_fields("feature", t, feature_fields, feature_needs)
  if t.low >= t.high then fail("feature", t.name, "high", "field 'high' must be greater than 'low'") end
  if t.scale == "log" and t.low <= 0 then fail("feature", t.name, "low", "field 'low' must be positive on a log scale") end
  return {
    kind = "feature", name = t.name, unit = t.unit, summary = t.summary or "", scale = t.scale or "linear",
    low = t.low, high = t.high,
    ask = function(plane)
      local x = t.value(plane)
      if x ~= nil and mathtype(x) == nil then
        error(format("value returned %s; it must return a number, or nil where it is not known", describe(x)), 0)
      end
      return x
    end,
  }
end

local constraint_fields = {
  api = checks.api, name = checks.name, summary = checks.text, within = checks.distance, applies = checks.call,
  degree = checks.call,
  classes = function(v)
    local good = type(v) == "table" and #v >= 2 and #v <= 4
    for i = 1, good and #v or 0 do good = good and type(v[i]) == "string" end
    return good, "must list the classes of two to four planes, that of the first first"
  end,
  quantifier = function(v) return v == "no" or v == "every" or v == "some", "must be 'no', 'every' or 'some'" end,
  weight = function(v) return v == "hard" or (mathtype(v) ~= nil and v > 0 and v < huge), "must be nats above 0, or 'hard'" end,
}
local constraint_needs = { "api", "name", "summary", "classes", "quantifier", "weight", "within", "degree" }

-- `return constraint { … }`: what a row cannot say, since it speaks of more than two planes at once.
function environment.constraint(t)
  if type(t) ~= "table" then error("constraint: write constraint { name = …, … } with braces", 2) end
  local known = sorted_keys(constraint_fields)
  for _, key in next, sorted_keys(t) do
    if not constraint_fields[key] then unknown_field("constraint", t, key, known) end
  end
  check_fields("constraint", t, constraint_fields, constraint_needs)
  local applies, degree = t.applies, t.degree
  local classes = ""
  for i = 1, #t.classes do classes = classes .. t.classes[i] .. "\n" end
  return {
    kind = "constraint", name = t.name, summary = t.summary, quantifier = t.quantifier, within = t.within, classes = classes,
    weight = t.weight == "hard" and huge or t.weight,
    direct = applies or degree, direct_is_filter = applies ~= nil,  -- most tuples end here
    ask = function(...)
      if applies then
        local may = applies(...)
        if may == false then return -1 end
        if may ~= true then error(format("applies returned %s; it must return true or false", describe(may)), 0) end
      end
      return checked_degree(degree(...))
    end,
  }
end

-- The host closes the file in -----------------------------------------------------------------------------------------

local hints = {
  print = "; rules cannot print, use error() to see a value", next = "; use pairs",
  setmetatable = "; rules have no metatables", getmetatable = "; rules have no metatables",
  require = "; a rule file stands alone", load = "; a rule file stands alone", dofile = "; a rule file stands alone",
  os = "; rules reach nothing outside", io = "; rules reach nothing outside", debug = "; rules reach nothing outside",
}

setmetatable(environment, {
  __metatable = false,
  __index = function(_, key)
    local hint = hints[key] or meant(key, sorted_keys(environment))
    error(format("'%s' is not declared%s", tostring(key), hint), 2)
  end,
  __newindex = function(_, key)
    error(format("'%s' would be a global; write 'local %s'", tostring(key), tostring(key)), 2)
  end,
})

-- Methods of texts, ("x"):upper(), must not lead back to the whole library.
local texts = getmetatable("")
texts.__index, texts.__metatable = environment.string, false

return environment
