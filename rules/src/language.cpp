#include "scenelore/rules/language.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "language_table.hpp"
#include "lua_files.hpp"
#include "names.hpp"
#include "scenelore/rules/error.hpp"
#include "suggestion.hpp"

namespace scenelore::rules {

namespace {

struct Global {
  const char* name;
  const char* kind;    ///< parameters of a function, or "=" and the fields of a table
  const char* result;  ///< type and text
  const char* text;
};

// Names only where they differ from Lua's own; a test holds this against the environment that prelude.lua makes.
constexpr Global kGlobals[] = {
    {"relation", "declaration: RelationDeclaration", "table", "Declares a relation: return relation { … }"},
    {"feature", "declaration: FeatureDeclaration", "table", "Declares a feature: return feature { … }"},
    {"constraint", "declaration: ConstraintDeclaration", "table", "Declares a constraint over several planes: return constraint { … }"},
    {"falloff", "value: number, full: number, none: number", "number 0 to 1",
     "1 up to `full`, 0 from `none` on, a straight line in between; with full > none the other way round"},
};
constexpr Global kTestGlobals[] = {
    {"flat", "fields: MadePlane", "Plane", "A level rectangle: length along x unless turned; tilted by `lean` degrees towards `facing`"},
    {"upright", "fields: MadePlane", "Plane", "An upright rectangle whose normal points to `facing` degrees (0 = x, 90 = y)"},
    {"case", "sentence: string, body: fun()", "nil", "One test"},
};
constexpr const char* kExpectations[] = {"between", "holds", "fails", "value"};

struct Library {
  const char* name;
  std::vector<const char*> fields;
};
const std::vector<Library>& libraries() {
  static const std::vector<Library> all{
      {"math", {"abs", "acos", "asin", "atan", "ceil", "cos", "deg", "exp", "floor", "fmod", "huge", "log", "max", "maxinteger",
                "min", "mininteger", "modf", "pi", "rad", "sin", "sqrt", "tan", "tointeger", "type", "ult"}},
      {"string", {"byte", "char", "format", "len", "lower", "reverse", "sub", "upper"}},
      {"table", {"concat", "insert", "pack", "remove", "sort", "unpack"}},
      {"utf8", {"char", "charpattern", "codepoint", "codes", "len", "offset"}}};
  return all;
}
constexpr const char* kLua[] = {"_G", "_VERSION", "assert", "error", "ipairs", "pairs", "pcall", "rawget", "rawlen", "select",
                                "tonumber", "tostring", "type"};

std::string quoted(const std::string& word) { return '"' + word + '"'; }

template <typename Words>
std::string list(const Words& words) {
  std::string out;
  for (const auto& word : words) out += (out.empty() ? "" : ", ") + quoted(word);
  return out;
}

/// Lists that fit into a line of 130 characters.
std::string wrapped(const std::string& text, const std::string& indent) {
  std::string out = indent, line;
  std::size_t column = indent.size();
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(", ", at), text.size());
    const std::string word = text.substr(at, end - at) + (end < text.size() ? "," : "");
    if (column + word.size() + 1 > 120) {
      out += "\n" + indent;
      column = indent.size();
    }
    out += (column > indent.size() ? " " : "") + word;
    column += word.size() + 1;
    at = end + 2;
  }
  return out;
}

std::string function_meta(const std::string& name, const Global& f) {
  std::string out = "---" + std::string(f.text) + "\n", names;
  const std::string parameters = f.kind;
  for (std::size_t at = 0; at < parameters.size();) {
    const std::size_t end = std::min(parameters.find(", ", at), parameters.size());
    const std::string parameter = parameters.substr(at, end - at);
    const std::size_t colon = parameter.find(": ");
    out += "---@param " + parameter.substr(0, colon) + " " + parameter.substr(colon + 2) + "\n";
    names += (names.empty() ? "" : ", ") + parameter.substr(0, colon);
    at = end + 2;
  }
  return out + "---@return " + f.result + "\nfunction " + name + "(" + names + ") end\n\n";
}

std::string number_text(double value) { return std::isfinite(value) ? number(value, 3) : "no limit"; }

}  // namespace

std::string language_meta() {
  std::string out =
      "---@meta\n"
      "-- What rule files see; made by `scenelore rules doc --format meta`.\n\n"
      "---A plane of the scan in the upright frame: z up, floor at 0. Read only.\n"
      "---@class Plane\n"
      "---@field id integer number of the plane in the knowledge base\n"
      "---@field normal { x: number, y: number, z: number } of length 1, towards the sensor where known\n";
  for (const PlaneField& field : plane_field_table()) out += "---@field " + std::string(field.name) + " number " + field.text + "\n";
  out +=
      "---@field [string] number every other feature of the catalogue\n\n"
      "---@class RelationDeclaration\n"
      "---@field api integer 1, the version of this language\n"
      "---@field name string letters, digits and _\n"
      "---@field summary string one line that says what it means\n"
      "---@field degree fun(a: Plane, b: Plane, r: table<string, number>): number|boolean from 0 to 1\n"
      "---@field applies? fun(a: Plane, b: Plane, r: table<string, number>): boolean cheap; false = degree 0\n"
      "---@field within? number metres between the boxes of a and b: pairs further apart are not asked\n"
      "---@field within_plan? number the same seen from above\n"
      "---@field symmetric? boolean a to b is always as b to a\n"
      "---@field extends? string built-in relation that all other fields come from\n"
      "---@field converse? string built-in relation that holds from b to a when this one holds from a to b: instead of degree\n"
      "---@field [string] number|boolean tolerances, r.name in degree\n\n"
      "---@class FeatureDeclaration\n"
      "---@field name string\n---@field unit string\n---@field low number\n---@field high number\n"
      "---@field value fun(p: Plane): number|nil nil = not known\n"
      "---@field scale? \"linear\"|\"log\"|\"circular\"\n---@field summary? string\n---@field api? integer\n\n"
      "---@class ConstraintDeclaration\n"
      "---@field api integer\n---@field name string\n---@field summary string said in reasons\n"
      "---@field classes string[] of two to four planes\n"
      "---@field quantifier \"no\"|\"every\"|\"some\"\n"
      "---@field weight number|\"hard\" nats for each tuple of planes, with some for each first plane\n"
      "---@field within number metres between the box of the first plane and those of the others\n"
      "---@field applies? fun(...: Plane): boolean cheap; false = the tuple is left out\n"
      "---@field degree fun(...: Plane): number|boolean from 0 to 1\n\n"
      "---@class MadePlane\n"
      "---@field x number\n---@field y number\n---@field z number\n---@field length number\n---@field width number\n"
      "---@field turn? number degrees\n---@field lean? number degrees\n---@field facing? number degrees\n"
      "---@field rmse? number metres\n\n";
  for (const Global& f : kGlobals) out += function_meta(f.name, f);
  out += "---Exact functions over two planes, each answer computed once.\ngeometry = {}\n\n";
  for (const GeometryFunction& f : geometry_table()) {
    const std::string further = f.further;
    const std::string kind = "a: Plane, b: Plane" + (further.empty() ? "" : ", " + further);
    out += function_meta("geometry." + std::string(f.name), {f.name, kind.c_str(), "number", f.text});
  }
  out += "-- In test files (*_test.lua) only.\n\n";
  for (const Global& f : kTestGlobals) out += function_meta(f.name, f);
  out += "expect = {}\n\n";
  out += function_meta("expect.between", {"", "low: number, high: number, a: Plane, b: Plane", "nil", "The degree lies from low to high"});
  out += function_meta("expect.holds", {"", "a: Plane, b: Plane", "nil", "The degree is 0.9 or more"});
  out += function_meta("expect.fails", {"", "a: Plane, b: Plane", "nil", "The degree is 0.1 or less"});
  out += function_meta("expect.value", {"", "wanted: number, plane: Plane, tolerance: number?", "nil", "The feature has this value"});
  out.pop_back();
  return out;
}

std::string language_luarc() {
  return "{\n"
         "  \"$schema\": \"https://raw.githubusercontent.com/LuaLS/vscode-lua/master/setting/schema.json\",\n"
         "  \"runtime.version\": \"Lua 5.4\",\n"
         "  \"runtime.builtin\": {\"coroutine\": \"disable\", \"debug\": \"disable\", \"io\": \"disable\", \"os\": \"disable\", "
         "\"package\": \"disable\"},\n"
         "  \"workspace.library\": [\".scenelore\"],\n"
         "  \"diagnostics.globals\": [\"geometry\", \"expect\"]\n"
         "}\n";
}

std::string language_luacheckrc() {
  std::string out =
      "-- What rule files may see; made by `scenelore rules doc --format luacheckrc`.\n"
      "std = \"none\"\n"
      "max_line_length = 130\n"
      "exclude_files = { \"**/.scenelore\" }\n"
      "read_globals = {\n";
  std::vector<std::string> names;
  for (const Global& f : kGlobals) names.emplace_back(f.name);
  for (const char* name : kLua) names.emplace_back(name);
  out += wrapped(list(names), "  ") + ",\n";
  std::vector<std::string> functions;
  for (const GeometryFunction& f : geometry_table()) functions.emplace_back(f.name);
  const auto add_table = [&](const std::string& name, const auto& fields) {
    out += "  " + name + " = { fields = {\n" + wrapped(list(fields), "    ") + "\n  } },\n";
  };
  add_table("geometry", functions);
  for (const Library& library : libraries()) add_table(library.name, library.fields);
  out += "}\n";
  std::vector<std::string> tests;
  for (const Global& f : kTestGlobals) tests.emplace_back(f.name);
  out += "files[\"**/*_test.lua\"] = { read_globals = { " + list(tests) + ",\n  expect = { fields = { " + list(std::span(kExpectations)) +
         " } } } }\n"
         "files[\"**/rules/lua\"] = { std = \"lua54\" }\n";
  return out;
}

NewRule new_relation(const std::string& name) {
  return {"-- a … b: say here in a sentence what holds, and sketch it.\n"
          "return relation {\n"
          "  api = 1,\n"
          "  name = \"" + name + "\",\n"
          "  summary = \"a lies within reach of b\",\n"
          "  within = 1,   -- metres between the boxes: pairs further apart are never asked\n"
          "  full = 0.1,   -- metres: up to here fully\n"
          "  none = 0.5,   -- from here on not at all\n"
          "  applies = function(a, b) return a.id ~= b.id end,  -- cheap; may be left out\n"
          "  degree = function(a, b, r) return falloff(geometry.gap(a, b), r.full, r.none) end,\n"
          "}\n",
          "local desk = flat { x = 0, y = 0, z = 0.74, length = 1.6, width = 0.8 }\n\n"
          "case(\"what lies on the desk is within reach\", function()\n"
          "  expect.holds(flat { x = 0, y = 0, z = 0.76, length = 0.45, width = 0.15 }, desk)\n"
          "end)\n\n"
          "case(\"what stands a metre away is not\", function()\n"
          "  expect.fails(flat { x = 2, y = 0, z = 0.74, length = 0.4, width = 0.4 }, desk)\n"
          "end)\n"};
}

NewRule new_variant(const std::string& name, const std::string& extends) {
  const RuleSet rules = RuleSet::load();
  for (const RelationInfo& relation : rules.relations()) {
    if (relation.name != extends) continue;
    std::string tolerances;
    for (const auto& [field, value] : relation.tolerances) tolerances += "  -- " + field + " = " + number_text(value) + ",\n";
    return {"-- As " + extends + ", but …\nreturn relation {\n  name = \"" + name + "\",\n  extends = \"" + extends +
                "\",\n  -- tolerances of " + extends + "; take the dashes away from those that differ:\n" + tolerances + "}\n",
            "local desk = flat { x = 0, y = 0, z = 0.74, length = 1.6, width = 0.8 }\n"
            "local floor = flat { x = 0, y = 0, z = 0, length = 5, width = 4 }\n\n"
            "case(\"it answers with a degree\", function()\n  expect.between(0, 1, desk, floor)\nend)\n"};
  }
  throw Error("there is no built-in relation '" + extends + "'" + did_you_mean(extends, rules.relation_names()));
}

NewRule new_feature(const std::string& name) {
  return {"-- A number for each plane; class_feature rows say what is typical of a class.\n"
          "return feature {\n"
          "  name = \"" + name + "\",\n"
          "  unit = \"1\",\n"
          "  low = 0,\n"
          "  high = 1,\n"
          "  value = function(p) return p.length > 0 and p.width / p.length or nil end,  -- nil: not known\n"
          "}\n",
          "case(\"a square has 1\", function()\n"
          "  expect.value(1, flat { x = 0, y = 0, z = 0, length = 2, width = 2 }, 1e-9)\n"
          "end)\n"};
}

std::string head_comment(const std::string& text) {
  std::string out;
  for (std::size_t at = 0; text.compare(at, 2, "--") == 0;) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    std::string line = text.substr(at + 2, end - at - 2);
    out += (line.starts_with(' ') ? line.substr(1) : line) + "\n";
    at = end + 1;
    if (at > text.size()) break;
  }
  return out;
}

std::string describe(const RelationInfo& relation, const std::string& text) {
  std::string out = relation.name + ": " + relation.summary + (relation.symmetric ? " (symmetric)" : "") + "\n" + relation.file + "\n\n" +
                    head_comment(text) + "\nreach: " + number_text(relation.within) + " in space, " + number_text(relation.within_plan) +
                    " seen from above (metres between the boxes)\n";
  for (const auto& [field, value] : relation.tolerances) out += "tolerance " + field + " = " + number_text(value) + "\n";
  return out;
}

}  // namespace scenelore::rules
