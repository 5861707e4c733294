-- The prelude under plain lua, without any C++: lua5.4 prelude_test.lua <rules/lua/prelude.lua>
local lines = {}
local environment = assert(loadfile(arg[1]))({
  geometry = {},
  nearest = function(word, words, most)
    for _, known in ipairs(words) do
      if known:sub(1, 3) == word:sub(1, 3) and (not most or #known == #word) then return known end
    end
  end,
  line_of = function(field) return lines[field] end,
  base = function(name) return name == "near" and { api = 1, name = "near", summary = "s", reach = 1, degree = function() return 1 end } end,
  overrides = function() return {} end,
})

local function same(found, expected)
  if found ~= expected then error(string.format("got %s, expected %s", found, expected), 2) end
end
local function failure(f, ...)
  local good, message = pcall(f, ...)
  same(good, false)
  return message
end

-- Methods of texts are the rules' own from here on, so the whole library is called by name.
local function has(text, part)
  if not string.find(text, part, 1, true) then error(string.format("'%s' lacks '%s'", text, part), 2) end
end

-- falloff is 1, a straight line, 0; either way round.
same(environment.falloff(0, 1, 2), 1)
same(environment.falloff(1.25, 1, 2), 0.75)
same(environment.falloff(3, 1, 2), 0)
same(environment.falloff(2, 3, 1), 0.5)
same(environment.falloff(1, 1, 1), 1)
same(environment.falloff(1.1, 1, 1), 0)

-- pairs goes by rising keys; sort is stable.
local order = {}
for key in environment.pairs { b = 1, a = 1, [2] = 1, [1] = 1, [true] = 1 } do order[#order + 1] = tostring(key) end
same(table.concat(order, " "), "true 1 2 a b")
for n = 0, 40 do
  local list = {}
  for i = 1, n do list[i] = { key = (i * 7) % 4, place = i } end
  environment.table.sort(list, function(a, b) return a.key < b.key end)
  for i = 2, n do
    assert(list[i - 1].key < list[i].key or (list[i - 1].key == list[i].key and list[i - 1].place < list[i].place))
  end
end

-- A relation is checked, and keeps its tolerances to itself.
local made = environment.relation {
  api = 1, name = "r", summary = "s", reach = 0.5,
  degree = function(_, _, r) return r.reach end,
}
same(made.ask(), 0.5)
same(made.within, math.huge)
lines.degre = "r.lua:4: "
same(failure(environment.relation, { api = 1, name = "r", summary = "s", degre = print }),
  "r.lua:4: relation 'r': unknown field 'degre'; did you mean 'degree'?")
same(failure(environment.relation, { name = "r", summary = "s", degree = print }), "relation 'r': field 'api' is missing")
same(environment.relation({ name = "mine", extends = "near", reach = 3 }).tolerances.reach, 3)
has(failure(function()
  environment.relation({ api = 1, name = "r", summary = "s", degree = function(_, _, r) r.reach = 2 end }).ask()
end), "relation 'r' cannot be changed")

-- Nothing undeclared, nothing dangerous.
for _, name in ipairs { "load", "dofile", "require", "setmetatable", "getmetatable", "rawset", "collectgarbage", "print",
  "coroutine", "os", "io", "debug", "xpcall", "next", "warn" } do
  has(failure(function() return environment[name] end), "'" .. name .. "' is not declared")
end
for _, name in ipairs { "rep", "find", "match", "gmatch", "gsub", "dump", "pack", "unpack", "packsize" } do
  has(failure(function() return environment.string[name] end), "string has no '" .. name .. "'")
end
same(getmetatable(""), false)
print("prelude: all good")
