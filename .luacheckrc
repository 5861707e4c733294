-- What rule files may see; `luacheck rules` is clean.
std = "lua54"
max_line_length = 130
files["rules/relations"] = { std = "none", globals = {}, read_globals = { "relation", "geometry", "falloff", "math", "string",
  "table", "utf8", "pairs", "ipairs", "type", "tostring", "tonumber", "select", "error", "assert", "pcall" } }
files["rules/features"] = { std = "none", read_globals = { "feature", "math", "string", "table", "pairs", "ipairs", "type" } }
files["rules/**/*_test.lua"] = { std = "none", read_globals = { "flat", "upright", "case", "expect", "ipairs", "pairs", "math" } }
