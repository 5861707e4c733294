#include "rule_host.hpp"

#include <cctype>
#include <cstring>
#include <span>

#include "lua_files.hpp"
#include "scenelore/rules/error.hpp"
#include "suggestion.hpp"

namespace scenelore::rules {

namespace {

/// Puts the word meant into `answer`; its length, 0 = none. Apart from the Lua function, so that no string is alive
/// when Lua runs out of memory.
std::size_t find_nearest(lua_State* state, char* answer, std::size_t size) {
  std::size_t length = 0;
  const char* word = lua_type(state, 1) == LUA_TSTRING ? lua_tolstring(state, 1, &length) : nullptr;
  if (word == nullptr) return 0;
  std::vector<std::string> known;
  for (lua_Integer i = 1, n = static_cast<lua_Integer>(lua_rawlen(state, 2)); i <= n; ++i) {
    lua_rawgeti(state, 2, i);
    if (lua_type(state, -1) == LUA_TSTRING) known.emplace_back(lua_tostring(state, -1));
    lua_pop(state, 1);
  }
  const std::string found = nearest({word, length}, known);
  const bool near_enough = lua_isnoneornil(state, 3) || edit_distance({word, length}, found) <= lua_tointeger(state, 3);
  return near_enough ? found.copy(answer, size) : 0;
}

/// nearest(word, words [, most]): the word meant, or nil.
int nearest_word(lua_State* state) {
  char answer[80];
  const std::size_t size = find_nearest(state, answer, sizeof answer);
  if (size == 0) return 0;
  lua_pushlstring(state, answer, size);
  return 1;
}

bool is_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// Line on which `field =`, or `field {`, stands first in the file; 0 = nowhere.
int line_of_field(std::string_view text, std::string_view field) {
  int line = 1;
  for (std::size_t at = 0, counted = 0; (at = text.find(field, at)) != text.npos; at += field.size()) {
    for (; counted < at; ++counted) line += text[counted] == '\n';
    const std::size_t after = text.find_first_not_of(" \t", at + field.size());
    const bool whole = (at == 0 || !is_name(text[at - 1])) && after != text.npos;
    if (whole && (text[after] == '{' || (text[after] == '=' && text.substr(after, 2) != "=="))) return line;
  }
  return 0;
}

/// line_of(field): "file.lua:3: ", or nil.
int line_of(lua_State* state) {
  std::size_t length = 0;
  const char* field = lua_tolstring(state, 1, &length);
  RuleHost& host = host_of(state);
  const int line = field == nullptr || length == 0 ? 0 : line_of_field(host.text, {field, length});
  if (line == 0) return 0;
  lua_pushfstring(state, "%s:%d: ", host.lua.chunk().c_str(), line);
  return 1;
}

/// base(name): what the built-in file of that name gives to relation{}.
int base_relation(lua_State* state) {
  const char* name = luaL_checkstring(state, 1);
  RuleHost& host = host_of(state);
  for (const EmbeddedFile& file : lua_files()) {
    const std::string_view prefix = "rules/relations/";
    if (file.name.substr(0, prefix.size()) != prefix) continue;
    const std::string_view stem = file.name.substr(prefix.size());
    if (stem.size() != std::strlen(name) + 4 || stem.substr(0, stem.size() - 4) != name) continue;
    lua_pushfstring(state, "@%s.lua", name);
    if (luaL_loadbufferx(state, file.text.data(), file.text.size(), lua_tostring(state, -1), "t") != LUA_OK) {
      return lua_error(state);
    }
    enter_environment(host);
    lua_call(state, 0, 1);
    lua_getfield(state, -1, "declared");
    return 1;
  }
  return 0;
}

/// overrides(relation): table of the tolerances set for it.
int overrides_of(lua_State* state) {
  const RuleHost& host = host_of(state);
  const char* name = luaL_checkstring(state, 1);
  lua_newtable(state);
  for (const auto& [relation, values] : host.overrides) {
    if (relation != name) continue;
    for (const auto& [field, value] : values) {
      lua_pushnumber(state, value);
      lua_setfield(state, -2, field.c_str());
    }
  }
  return 1;
}

int open_libraries(lua_State* state) {
  luaL_requiref(state, LUA_GNAME, luaopen_base, 1);
  luaL_requiref(state, LUA_STRLIBNAME, luaopen_string, 1);
  luaL_requiref(state, LUA_TABLIBNAME, luaopen_table, 1);
  luaL_requiref(state, LUA_MATHLIBNAME, luaopen_math, 1);
  luaL_requiref(state, LUA_UTF8LIBNAME, luaopen_utf8, 1);
  return 0;
}

/// The libraries themselves keep nothing that could be used against the host, should a file ever get at them.
int strip_libraries(lua_State* state) {
  struct Removed {
    const char* library;
    std::span<const char* const> names;
  };
  static constexpr const char* base[] = {"dofile", "loadfile", "load", "collectgarbage", "print", "warn", "xpcall",
                                         "setmetatable", "getmetatable", "rawset", "rawequal", "next"};
  static constexpr const char* string[] = {"rep", "find", "match", "gmatch", "gsub", "dump", "pack", "unpack",
                                           "packsize"};
  static constexpr const char* table[] = {"move"};
  static constexpr const char* math[] = {"random", "randomseed"};
  static constexpr Removed all[] = {{"_G", base}, {"string", string}, {"table", table}, {"math", math}};
  lua_getfield(state, LUA_REGISTRYINDEX, LUA_LOADED_TABLE);
  for (const Removed& removed : all) {
    lua_getfield(state, -1, removed.library);
    for (const char* name : removed.names) {
      lua_pushnil(state);
      lua_setfield(state, -2, name);
    }
    lua_pop(state, 1);
  }
  return 0;
}

}  // namespace

std::string lines_of(const FeatureNames& names) {
  std::string out;
  for (const std::string& name : names) out += name + "\n";
  return out;
}

RuleHost& host_of(lua_State* state) { return *static_cast<RuleHost*>(lua_touserdata(state, lua_upvalueindex(1))); }

void push_function(RuleHost& host, lua_CFunction function) {
  lua_pushlightuserdata(host.lua.get(), &host);
  lua_pushcclosure(host.lua.get(), function, 1);
}

void enter_environment(RuleHost& host) {
  lua_rawgeti(host.lua.get(), LUA_REGISTRYINDEX, host.environment);
  lua_setupvalue(host.lua.get(), -2, 1);
}

/// Opens the libraries, runs the prelude, makes the environment.
RuleHost::RuleHost(const Budget& budget, const std::map<std::string, Overrides>& given, Trust trust)
    : lua(budget, trust == Trust::stranger), trusted(trust == Trust::program), overrides(given) {
  const LuaState::HostMemory memory(lua);
  lua_State* state = lua.get();
  lua_pushcfunction(state, open_libraries);
  lua.call(0, 0);
  lua.load_prelude();
  lua_createtable(state, 0, 6);
  push_geometry(*this);
  lua_setfield(state, -2, "geometry");
  lua_pushboolean(state, trusted);
  lua_setfield(state, -2, "trusted");
  const auto add = [&](const char* name, lua_CFunction function) {
    push_function(*this, function);
    lua_setfield(state, -2, name);
  };
  add("nearest", guarded<nearest_word>);
  add("line_of", guarded<line_of>);
  add("base", guarded<base_relation>);
  add("overrides", guarded<overrides_of>);
  lua.call(1, 1);
  environment = luaL_ref(state, LUA_REGISTRYINDEX);
  lua_pushcfunction(state, strip_libraries);
  lua.call(0, 0);
}

}  // namespace scenelore::rules
