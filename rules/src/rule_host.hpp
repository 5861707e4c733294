// What a rule file's state knows of the world: planes as read-only values, geometry as functions.
#pragma once

#include <lua.hpp>

#include <array>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "lua_state.hpp"
#include "pair_geometry.hpp"
#include "scenelore/rules/scene.hpp"

namespace scenelore::rules {

/// Values of tolerances by field name, from settings.
using Overrides = std::map<std::string, double>;

/// Names of features of the catalogue.
using FeatureNames = std::set<std::string, std::less<>>;
/// One a line.
[[nodiscard]] std::string lines_of(const FeatureNames& names);

/// Whose files a state runs. Those of strangers are counted and kept from what they see; those that come with the program need not be.
enum class Trust { stranger, program };

/// The C++ side of one state; its address stands behind every host function of that state, so it does not move.
struct RuleHost {
  /// Opens the sandbox. Throws Error (a bug in the prelude, or no memory).
  explicit RuleHost(const Budget& budget, const std::map<std::string, Overrides>& overrides = {}, Trust trust = Trust::stranger);
  RuleHost(const RuleHost&) = delete;
  RuleHost& operator=(const RuleHost&) = delete;

  LuaState lua;
  const bool trusted;
  std::string text;                              ///< of the file that is being loaded, to find lines in
  const std::map<std::string, Overrides> overrides;  ///< by relation
  const Scene* scene = nullptr;
  PairGeometry* geometry = nullptr;
  FeatureNames features_read;                    ///< since set_scene; "?" = some name that the catalogue lacks
  std::vector<int> planes;                       ///< registry: the planes of the scene, LUA_NOREF = not pushed yet
  std::vector<const void*> addresses;            ///< of these values, by which Lua tells them apart
  std::array<int, 2> asked_about{-1, -1};        ///< planes of the relation's question, which most calls of geometry are about
  /// Registry: what all planes and vectors have in common, made with the first of them.
  int no_writing = LUA_NOREF, describe = LUA_NOREF, missing_fields_of_planes = LUA_NOREF, missing_fields_of_vectors = LUA_NOREF;
  int environment = LUA_NOREF;                   ///< registry: globals of the file
};

/// Gives the function on top of the stack the file's globals.
void enter_environment(RuleHost& host);

/// The planes asked about from now on. Both must outlive the next call into the state; nullptr for none. Lua's values of the planes stay
/// as long as the scene is the same.
void set_scene(RuleHost& host, const Scene* scene, PairGeometry* geometry);

/// Makes plane number `index` of the scene a Lua value, unless it is one.
void make_known(RuleHost& host, int index);

/// Pushes that value; makes it if need be.
void push_plane(RuleHost& host, int index);

/// Index of the plane at stack position `argument` of a geometry function. Throws Error naming that when it is something else.
[[nodiscard]] int plane_argument(lua_State* state, const RuleHost& host, int argument);

/// The same; −1 for something else.
[[nodiscard]] int plane_argument_or_none(lua_State* state, int argument);

/// The host behind the C closure that is running.
[[nodiscard]] RuleHost& host_of(lua_State* state);

/// Pushes a C function that finds `host` by host_of.
void push_function(RuleHost& host, lua_CFunction function);

/// Pushes the table of geometry functions.
void push_geometry(RuleHost& host);

/// Names of the fields of a plane in this scene.
[[nodiscard]] std::vector<std::string> plane_fields(const Scene& scene);

}  // namespace scenelore::rules
