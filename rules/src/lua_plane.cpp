// Planes and geometry as Lua sees them.
#include <algorithm>

#include "language_table.hpp"
#include "rule_host.hpp"
#include "scenelore/rules/error.hpp"
#include "suggestion.hpp"

namespace scenelore::rules {

namespace {

/// Its address is the key under which a plane's values keep its index; no rule can make such a key.
constexpr char kIndexKey = 0;

/// The block of a userdata. Only the host makes userdata, so every one is a Handle.
struct Handle {
  int plane;  ///< −1 = a vector
};

constexpr PlaneField kFields[] = {
    {"x", [](const perception::Plane& p) { return p.centroid.x(); },
     "metres, centroid"},
    {"y", [](const perception::Plane& p) { return p.centroid.y(); },
     "metres, centroid"},
    {"z", [](const perception::Plane& p) { return p.centroid.z(); },
     "metres, centroid above the floor"},
    {"height", [](const perception::Plane& p) { return p.height; },
     "metres, centroid above the floor"},
    {"area_m2", [](const perception::Plane& p) { return p.area_m2; },
     "square metres inside the outline"},
    {"length", [](const perception::Plane& p) { return p.length; },
     "metres, longer side of the smallest rectangle around it"},
    {"width", [](const perception::Plane& p) { return p.width; },
     "metres, shorter side"},
    {"rectangularity", [](const perception::Plane& p) { return p.rectangularity; },
     "area over that of the rectangle, 0 to 1"},
    {"tilt_deg", [](const perception::Plane& p) { return p.tilt_deg; },
     "degrees between normal and vertical: 0 level, 90 upright"},
    {"z_min", [](const perception::Plane& p) { return p.z_min; },
     "metres, lower edge"},
    {"z_max", [](const perception::Plane& p) { return p.z_max; },
     "metres, upper edge"},
    {"rmse", [](const perception::Plane& p) { return p.rmse; },
     "metres, of the fit"},
    {"facing_up", [](const perception::Plane& p) { return p.facing_up; },
     "upward part of the normal on the side it was seen from, -1 to 1"},
    {"point_density", [](const perception::Plane& p) { return p.point_density; },
     "points a square metre"},
    {"spread_length", [](const perception::Plane& p) { return p.spread_length; },
     "metres, longer side of the rectangle that spreads as the points do"},
    {"spread_width", [](const perception::Plane& p) { return p.spread_width; },
     "metres, its shorter side"},
    {"seen_share", [](const perception::Plane& p) { return p.seen_share; },
     "share of the outline that holds points, 0 to 1"},
    {"behind", [](const perception::Plane& p) { return p.behind; },
     "share of the cubes around it that lie on its emptier side: about 0 where the room ends, -1 = not known"},
    {"edge_free", [](const perception::Plane& p) { return p.edge_free; },
     "share of its outline beyond which the sensor looked into the room behind; -1 = not known"},
    {"edge_free_top", [](const perception::Plane& p) { return p.edge_free_top; },
     "the same of its upper edge; -1 = not known, or level"},
    {"edge_joined", [](const perception::Plane& p) { return p.edge_joined; },
     "share of its outline along which another surface goes on in its plane; -1 = not known"},
    {"edge_unseen", [](const perception::Plane& p) { return p.edge_unseen; },
     "share of its outline beyond which nothing was measured; -1 = not known"},
    {"point_count", [](const perception::Plane& p) { return static_cast<double>(p.point_count); },
     "points"},
};

[[noreturn]] int no_writing(lua_State*) { throw Error("planes cannot be changed; a rule only looks at them"); }

int unknown_vector_field(lua_State*) { throw Error("a normal has x, y and z only"); }

int describe_plane(lua_State* state) {
  const auto* handle = static_cast<const Handle*>(lua_touserdata(state, 1));
  const RuleHost& host = host_of(state);
  if (handle == nullptr || handle->plane < 0) {
    lua_pushliteral(state, "a vector");
  } else {
    lua_pushfstring(state, "plane %I", static_cast<lua_Integer>(host.scene->ids[static_cast<std::size_t>(handle->plane)]));
  }
  return 1;
}

/// Pushes what the registry keeps under `reference`; `make` pushes it for the first time.
template <typename Make>
void push_kept(RuleHost& host, int& reference, Make make) {
  lua_State* state = host.lua.get();
  if (reference == LUA_NOREF) {
    make();
    reference = luaL_ref(state, LUA_REGISTRYINDEX);
  }
  lua_rawgeti(state, LUA_REGISTRYINDEX, reference);
}

/// Takes the table of values from the stack and pushes a userdata that shows them and lets none be changed; to a file that is trusted, the
/// table itself, whose fields are sooner read. `missing_fields` keeps the metatable of such values, which asks `missing` for names that
/// they lack.
void push_handle(RuleHost& host, int plane, int& missing_fields, lua_CFunction missing) {
  lua_State* state = host.lua.get();
  push_kept(host, missing_fields, [&] {
    lua_createtable(state, 0, 1);
    push_function(host, missing);
    lua_setfield(state, -2, "__index");
  });
  lua_setmetatable(state, -2);
  if (host.trusted) return;
  *static_cast<Handle*>(lua_newuserdatauv(state, sizeof(Handle), 0)) = {plane};
  lua_createtable(state, 0, 4);
  lua_pushvalue(state, -3);
  lua_setfield(state, -2, "__index");
  push_kept(host, host.no_writing, [&] { push_function(host, guarded<no_writing>); });
  lua_setfield(state, -2, "__newindex");
  push_kept(host, host.describe, [&] { push_function(host, guarded<describe_plane>); });
  lua_setfield(state, -2, "__tostring");
  lua_pushboolean(state, 0);
  lua_setfield(state, -2, "__metatable");
  lua_setmetatable(state, -2);
  lua_remove(state, -2);
}

void set_number(lua_State* state, const char* name, double value) {
  lua_pushnumber(state, value);
  lua_setfield(state, -2, name);
}

void push_normal(RuleHost& host, const Eigen::Vector3d& normal) {
  lua_State* state = host.lua.get();
  lua_createtable(state, 0, 3);
  set_number(state, "x", normal.x());
  set_number(state, "y", normal.y());
  set_number(state, "z", normal.z());
  push_handle(host, -1, host.missing_fields_of_vectors, guarded<unknown_vector_field>);
}

/// Most rules ask for two or three of the fields, so each is made when it is first asked for. Arguments are the values and the key that
/// they lack.
int missing_plane_field(lua_State* state) {
  RuleHost& host = host_of(state);
  std::size_t length = 0;
  const char* text = lua_type(state, 2) == LUA_TSTRING ? lua_tolstring(state, 2, &length) : "?";
  const std::string_view key(text, length);
  lua_rawgetp(state, 1, &kIndexKey);
  const auto index = static_cast<std::size_t>(lua_tointeger(state, -1));
  const kb::FeatureTable& features = host.scene->features;
  const auto field = std::find_if(std::begin(kFields), std::end(kFields), [&](const PlaneField& f) { return key == f.name; });
  const auto column = static_cast<std::size_t>(std::find(features.names.begin(), features.names.end(), key) - features.names.begin());
  const LuaState::HostMemory memory(host.lua);
  const std::string_view looked_at = column < features.names.size() ? key : "?";  // any other name: all that matters is that it is none
  const bool built_in = field != std::end(kFields) || key == "normal" || key == "id";
  if (!built_in && !host.features_read.contains(looked_at)) host.features_read.emplace(looked_at);
  if (field != std::end(kFields)) {
    lua_pushnumber(state, field->value(host.scene->planes[index]));
  } else if (key == "normal") {
    push_normal(host, host.scene->planes[index].normal);
  } else if (key == "id") {
    lua_pushinteger(state, host.scene->ids[index]);
  } else if (index < features.values.size() && column < std::min(features.names.size(), features.values[index].size())) {
    lua_pushnumber(state, features.values[index][column]);  // while features are being computed, the one at work has a name, but no value
  } else {
    const std::string word(key);
    throw Error("a plane has no '" + word.substr(0, 64) + "'" + did_you_mean(word, plane_fields(*host.scene)));
  }
  const bool others_look = host.trusted && !built_in;  // and it must show what each of them looks at
  if (!others_look) {
    lua_pushvalue(state, 2);
    lua_pushvalue(state, -2);
    lua_rawset(state, 1);
  }
  return 1;
}

void make_plane(RuleHost& host, std::size_t index) {
  lua_State* state = host.lua.get();
  lua_createtable(state, 0, 4);
  lua_pushinteger(state, static_cast<lua_Integer>(index));
  lua_rawsetp(state, -2, &kIndexKey);
  push_handle(host, static_cast<int>(index), host.missing_fields_of_planes, guarded<missing_plane_field>);
}

using PairFunction = double (*)(PairGeometry&, int a, int b, lua_State*);

template <PairFunction function>
int pair_function(lua_State* state) {
  RuleHost& host = host_of(state);
  const int a = plane_argument(state, host, 1), b = plane_argument(state, host, 2);
  lua_pushnumber(state, function(*host.geometry, a, b, state));
  return 1;
}

double reach_argument(lua_State* state) {
  if (lua_isnoneornil(state, 3)) return 0;
  int is_number = 0;
  const double reach = lua_tonumberx(state, 3, &is_number);
  if (is_number == 0 || !(reach >= 0)) throw Error("geometry.footprint_overlap: argument 3 must be a reach in metres");
  return reach;
}

/// Two numbers in any order, at stack position `first` and after it; none, for no limits.
Limits limits_arguments(lua_State* state, int first, const char* function) {
  if (lua_isnoneornil(state, first) && lua_isnoneornil(state, first + 1)) return {};
  int is_number = 0, is_another = 0;
  const double one = lua_tonumberx(state, first, &is_number), other = lua_tonumberx(state, first + 1, &is_another);
  if (is_number != 0 && is_another != 0 && one == one && other == other) return {std::min(one, other), std::max(one, other)};
  throw Error(std::string(function) + ": arguments " + std::to_string(first) + " and " + std::to_string(first + 1) +
              " must be the two limits between which the answer matters");
}

constexpr GeometryFunction kGeometry[] = {
    {"angle", guarded<pair_function<[](PairGeometry& g, int a, int b, lua_State*) { return g.angle(a, b); }>>, "",
     "degrees between the planes, 0 to 90, whichever way they face"},
    {"gap", guarded<pair_function<[](PairGeometry& g, int a, int b, lua_State* state) {
       return g.gap(a, b, limits_arguments(state, 3, "geometry.gap"));
     }>>, "low: number?, high: number?",
     "metres, smallest distance of the outlines and what they enclose; 0 when they cross; between low and high where they are given"},
    {"footprint_overlap", guarded<pair_function<[](PairGeometry& g, int a, int b, lua_State* state) {
       return g.footprint_overlap(a, b, reach_argument(state), limits_arguments(state, 4, "geometry.footprint_overlap"));
     }>>, "reach: number?, low: number?, high: number?",
     "share of the footprint of a over that of b, or within reach metres (default 0) of it; between low and high where they are given"},
    {"vertical_gap",
     guarded<pair_function<[](PairGeometry& g, int a, int b, lua_State*) { return g.vertical_gap(a, b); }>>, "",
     "metres from the top of b up to the lowest point of a; negative when they overlap in height"},
    {"plane_distance",
     guarded<pair_function<[](PairGeometry& g, int a, int b, lua_State*) { return g.plane_distance(a, b); }>>, "",
     "metres from the centroid of a to the endless plane of b"},
    {"side", guarded<pair_function<[](PairGeometry& g, int a, int b, lua_State*) { return g.side(a, b); }>>, "",
     "metres, the same with a sign: positive on the side the normal of b points to"},
    {"centroid_distance",
     guarded<pair_function<[](PairGeometry& g, int a, int b, lua_State*) { return g.centroid_distance(a, b); }>>, "",
     "metres between the centroids"},
};

}  // namespace

std::span<const PlaneField> plane_field_table() { return kFields; }
std::span<const GeometryFunction> geometry_table() { return kGeometry; }

std::vector<std::string> plane_fields(const Scene& scene) {
  std::vector<std::string> names{"id", "normal"};
  for (const PlaneField& field : kFields) names.emplace_back(field.name);
  names.insert(names.end(), scene.features.names.begin(), scene.features.names.end());
  return names;
}

int plane_argument_or_none(lua_State* state, int argument) {
  if (lua_type(state, argument) == LUA_TUSERDATA) return static_cast<const Handle*>(lua_touserdata(state, argument))->plane;
  if (lua_type(state, argument) != LUA_TTABLE) return -1;
  const int index = lua_rawgetp(state, argument, &kIndexKey) == LUA_TNUMBER ? static_cast<int>(lua_tointeger(state, -1)) : -1;
  lua_pop(state, 1);
  return index;
}

int plane_argument(lua_State* state, const RuleHost& host, int argument) {
  const void* address = lua_topointer(state, argument);
  for (const int asked : host.asked_about) {
    if (asked >= 0 && address == host.addresses[static_cast<std::size_t>(asked)]) return asked;
  }
  const int plane = plane_argument_or_none(state, argument);
  if (plane >= 0 && plane < host.geometry->size()) return plane;
  const std::string function = lua_tostring(state, lua_upvalueindex(2));
  if (plane >= 0) throw Error(function + ": the plane is not of this scene");
  throw Error(function + ": argument " + std::to_string(argument) + " must be a plane, not " +
              (lua_isnoneornil(state, argument) ? "nothing" : std::string("a ") + luaL_typename(state, argument)));
}

void push_geometry(RuleHost& host) {
  lua_State* state = host.lua.get();
  lua_createtable(state, 0, static_cast<int>(std::size(kGeometry)));
  for (const GeometryFunction& entry : kGeometry) {
    lua_pushlightuserdata(state, &host);
    lua_pushfstring(state, "geometry.%s", entry.name);
    lua_pushcclosure(state, entry.function, 2);
    lua_setfield(state, -2, entry.name);
  }
}

void set_scene(RuleHost& host, const Scene* scene, PairGeometry* geometry) {
  const LuaState::HostMemory memory(host.lua);
  lua_State* state = host.lua.get();
  if (scene != nullptr) host.features_read.clear();
  if (scene == host.scene && geometry == host.geometry) return;
  host.scene = scene;
  host.geometry = geometry;
  for (const int reference : host.planes) luaL_unref(state, LUA_REGISTRYINDEX, reference);
  host.planes.assign(scene == nullptr ? 0 : scene->planes.size(), LUA_NOREF);
  host.addresses.assign(host.planes.size(), nullptr);
  host.asked_about = {-1, -1};
}

void make_known(RuleHost& host, int index) {
  const auto at = static_cast<std::size_t>(index);
  if (at >= host.planes.size()) {  // the scene of a test file grows while it is looked at
    host.planes.resize(at + 1, LUA_NOREF);
    host.addresses.resize(at + 1);
  }
  int& reference = host.planes[at];
  if (reference != LUA_NOREF) return;
  const LuaState::HostMemory memory(host.lua);
  make_plane(host, at);
  host.addresses[at] = lua_topointer(host.lua.get(), -1);
  reference = luaL_ref(host.lua.get(), LUA_REGISTRYINDEX);
}

void push_plane(RuleHost& host, int index) {
  make_known(host, index);
  lua_rawgeti(host.lua.get(), LUA_REGISTRYINDEX, host.planes[static_cast<std::size_t>(index)]);
}

}  // namespace scenelore::rules
