-- What rule files may see; made by `scenelore rules doc --format luacheckrc`.
std = "none"
max_line_length = 130
exclude_files = { "**/.scenelore" }
read_globals = {
  "relation", "feature", "constraint", "falloff", "_G", "_VERSION", "assert", "error", "ipairs", "pairs", "pcall",
  "rawget", "rawlen", "select", "tonumber", "tostring", "type",
  geometry = { fields = {
    "angle", "gap", "footprint_overlap", "vertical_gap", "plane_distance", "side", "centroid_distance"
  } },
  math = { fields = {
    "abs", "acos", "asin", "atan", "ceil", "cos", "deg", "exp", "floor", "fmod", "huge", "log", "max", "maxinteger",
    "min", "mininteger", "modf", "pi", "rad", "sin", "sqrt", "tan", "tointeger", "type", "ult"
  } },
  string = { fields = {
    "byte", "char", "format", "len", "lower", "reverse", "sub", "upper"
  } },
  table = { fields = {
    "concat", "insert", "pack", "remove", "sort", "unpack"
  } },
  utf8 = { fields = {
    "char", "charpattern", "codepoint", "codes", "len", "offset"
  } },
}
files["**/*_test.lua"] = { read_globals = { "flat", "upright", "case",
  expect = { fields = { "between", "holds", "fails", "value" } } } }
files["**/rules/lua"] = { std = "lua54" }
