#include "rule_file.hpp"

#include <cmath>
#include <limits>
#include <utility>

namespace scenelore::rules {

namespace {

constexpr const char* kHowToReturn = "the file must end with  return relation { … }  or  return feature { … }";

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> out;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = text.find('\n', at);
    out.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return out;
}

kb::Scale scale_of(const std::string& name) {
  return name == "log" ? kb::Scale::log : name == "circular" ? kb::Scale::circular : kb::Scale::linear;
}

kb::Quantifier quantifier_of(const std::string& name) {
  return name == "some" ? kb::Quantifier::some : name == "every" ? kb::Quantifier::every : kb::Quantifier::no;
}

}  // namespace

RuleFile::RuleFile(RuleSource source, const Budget& budget, const std::map<std::string, Overrides>& overrides)
    : RuleFile(std::move(source), std::make_shared<RuleHost>(budget, overrides)) {}

RuleFile::RuleFile(RuleSource source, std::shared_ptr<RuleHost> host) : source_(std::move(source)), host_(std::move(host)) {
  host_->text = source_.text;
  host_->lua.load(source_.text, source_.shown);
  enter_environment(*host_);
  try {
    host_->lua.call(0, 1);
  } catch (const Error& error) {
    throw located(error, "");
  }
  take_over();
}

void RuleFile::take_over() {
  lua_State* state = host_->lua.get();
  if (lua_type(state, -1) != LUA_TTABLE) {
    throw Error(source_.shown + ": returned " + (lua_isnil(state, -1) ? "nothing" : std::string("a ") + luaL_typename(state, -1)) +
                "; " + kHowToReturn);
  }
  const std::string kind = text_field("kind");
  lua_pushliteral(state, "ask");
  lua_rawget(state, -2);
  const bool callable = lua_isfunction(state, -1);
  ask_ = luaL_ref(state, LUA_REGISTRYINDEX);
  if (!callable || (kind != "relation" && kind != "feature" && kind != "constraint")) {
    throw Error(source_.shown + ": returned a plain table; " + kHowToReturn);
  }
  name_ = text_field("name");
  if (kind == "relation") {
    kind_ = Kind::relation;
    relation_ = {.name = name_, .summary = text_field("summary"), .file = source_.shown,
                 .within = number_field("within"), .within_plan = number_field("within_plan"), .converse = text_field("converse")};
    lua_pushliteral(state, "plain");
    lua_rawget(state, -2);
    relation_.plain_converse = lua_toboolean(state, -1) != 0;
    lua_pop(state, 1);
    applies_ = function_field("applies");
    degree_ = function_field("degree");
    lua_pushliteral(state, "self");
    lua_rawget(state, -2);
    self_ = luaL_ref(state, LUA_REGISTRYINDEX);
    lua_pushliteral(state, "symmetric");
    lua_rawget(state, -2);
    relation_.symmetric = lua_toboolean(state, -1) != 0;
    lua_pop(state, 1);
    lua_pushliteral(state, "tolerances");
    lua_rawget(state, -2);
    if (lua_istable(state, -1)) {
      for (lua_pushnil(state); lua_next(state, -2) != 0; lua_pop(state, 1)) {
        const bool flag = lua_isboolean(state, -1);
        if (lua_type(state, -2) != LUA_TSTRING) continue;
        relation_.tolerances[lua_tostring(state, -2)] = flag ? lua_toboolean(state, -1) : lua_tonumber(state, -1);
      }
    }
    lua_pop(state, 1);
  } else if (kind == "constraint") {
    kind_ = Kind::constraint;
    const double weight = number_field("weight");
    constraint_ = {.name = name_, .summary = text_field("summary"), .file = source_.shown, .classes = lines_of(text_field("classes")),
                   .quantifier = quantifier_of(text_field("quantifier")),
                   .weight = std::isfinite(weight) ? std::optional(weight) : std::nullopt, .within = number_field("within"),
                   .tuples = {}};
    lua_pushliteral(state, "direct_is_filter");
    lua_rawget(state, -2);
    direct_is_filter_ = lua_toboolean(state, -1) != 0;
    lua_pop(state, 1);
    lua_pushliteral(state, "direct");
    lua_rawget(state, -2);
    direct_ = luaL_ref(state, LUA_REGISTRYINDEX);
  } else {
    kind_ = Kind::feature;
    feature_ = {.name = name_, .unit = text_field("unit"), .scale = scale_of(text_field("scale")),
                .low = number_field("low"), .high = number_field("high"), .weight = 1,
                .description = text_field("summary")};
  }
  lua_pop(state, 1);
}

std::string RuleFile::text_field(const char* name) const {
  lua_State* state = host_->lua.get();
  lua_pushstring(state, name);
  lua_rawget(state, -2);
  const std::string text = lua_type(state, -1) == LUA_TSTRING ? lua_tostring(state, -1) : "";
  lua_pop(state, 1);
  return text;
}

double RuleFile::number_field(const char* name) const {
  lua_State* state = host_->lua.get();
  lua_pushstring(state, name);
  lua_rawget(state, -2);
  const double value = lua_tonumber(state, -1);
  lua_pop(state, 1);
  return value;
}

/// Reference of a function in the table on top of the stack.
int RuleFile::function_field(const char* name) const {
  lua_State* state = host_->lua.get();
  lua_pushstring(state, name);
  if (lua_rawget(state, -2) == LUA_TFUNCTION) return luaL_ref(state, LUA_REGISTRYINDEX);
  lua_pop(state, 1);
  return LUA_NOREF;
}

/// A message always begins with the file, also when Lua could not tell the line.
Error RuleFile::located(const Error& error, const std::string& about) const {
  const std::string message = error.what();
  const bool has_place = message.compare(0, source_.shown.size() + 1, source_.shown + ":") == 0;
  return Error((has_place ? message : source_.shown + ": " + message) + about, error.traceback());
}

void RuleFile::look_at(const Scene* scene, PairGeometry* geometry) {
  host_->lua.speak_of(source_.shown);
  set_scene(*host_, scene, geometry);
}

namespace {

/// What answer_batch works through; behind its argument, so that nothing needs to be unwound when a rule fails.
struct Batch {
  RuleFile* file;
  std::span<const std::pair<int, int>> pairs;
  double* degrees;
  std::size_t at = 0;
};

/// A number from 0 to 1, true or false, taken from the stack; −1 for anything else.
double plain_degree(lua_State* state) {
  const int type = lua_type(state, -1);
  const double degree = type == LUA_TNUMBER ? lua_tonumber(state, -1) : type == LUA_TBOOLEAN ? lua_toboolean(state, -1) : -1;
  lua_pop(state, 1);
  return degree >= 0 && degree <= 1 ? degree : -1;
}

/// Where answer_batch keeps on the stack what all its questions need: sooner found than in the registry.
enum Place : int { kBatch = 1, kApplies, kDegree, kSelf };

}  // namespace

/// Inside a protected call: an error ends it.
double RuleFile::answer(lua_State* state, int a, int b) {
  host_->lua.start_counting();
  host_->asked_about = {a, b};
  const auto push_planes = [&] {
    for (const int plane : {a, b}) lua_rawgeti(state, LUA_REGISTRYINDEX, host_->planes[static_cast<std::size_t>(plane)]);
  };
  const auto call = [&](Place function) {
    lua_pushvalue(state, function);
    push_planes();
    lua_pushvalue(state, kSelf);
    lua_call(state, 3, 1);
  };
  bool may = true;
  if (applies_ != LUA_NOREF) {
    call(kApplies);
    const bool plain = lua_type(state, -1) == LUA_TBOOLEAN;
    may = plain && lua_toboolean(state, -1) != 0;
    lua_pop(state, 1);
    if (plain && !may) return 0;
  }
  if (may) {
    call(kDegree);
    const double degree = plain_degree(state);
    if (degree >= 0) return degree;
  }
  lua_rawgeti(state, LUA_REGISTRYINDEX, ask_);
  push_planes();
  lua_call(state, 2, 1);
  const double degree = lua_tonumber(state, -1);
  lua_pop(state, 1);
  return degree;
}

int RuleFile::answer_batch(lua_State* state) {
  Batch& batch = *static_cast<Batch*>(lua_touserdata(state, kBatch));
  RuleFile& file = *batch.file;
  for (const int reference : {file.applies_, file.degree_, file.self_}) lua_rawgeti(state, LUA_REGISTRYINDEX, reference);
  for (; batch.at < batch.pairs.size(); ++batch.at) {
    batch.degrees[batch.at] = file.answer(state, batch.pairs[batch.at].first, batch.pairs[batch.at].second);
  }
  return 0;
}

void RuleFile::degrees(std::span<const std::pair<int, int>> pairs, double* degrees) {
  const auto known = [&](int plane) {
    const auto at = static_cast<std::size_t>(plane);
    return at < host_->planes.size() && host_->planes[at] != LUA_NOREF;
  };
  for (const auto& pair : pairs) {  // what memory is used for planes is not the rule's
    for (const int plane : {pair.first, pair.second}) {
      if (!known(plane)) make_known(*host_, plane);
    }
  }
  Batch batch{this, pairs, degrees};
  lua_pushcfunction(host_->lua.get(), answer_batch);
  lua_pushlightuserdata(host_->lua.get(), &batch);
  try {
    host_->lua.call(1, 0);
  } catch (const Error& error) {
    const auto id = [&](int plane) { return std::to_string(host_->scene->ids[static_cast<std::size_t>(plane)]); };
    const auto [a, b] = pairs[batch.at];
    throw located(error, " (relation '" + name_ + "', planes " + id(a) + " and " + id(b) + ")");
  }
}

double RuleFile::degree(int a, int b) {
  const std::pair<int, int> pair{a, b};
  double degree = 0;
  degrees({&pair, 1}, &degree);
  return degree;
}

std::optional<double> RuleFile::degree(const std::vector<int>& planes) {
  lua_State* state = host_->lua.get();
  const auto call = [&](int function) {
    lua_rawgeti(state, LUA_REGISTRYINDEX, function);
    for (const int plane : planes) push_plane(*host_, plane);
    host_->lua.call(static_cast<int>(planes.size()), 1);
  };
  try {
    call(direct_);
    const bool is_no = lua_type(state, -1) == LUA_TBOOLEAN && lua_toboolean(state, -1) == 0;
    const double answer = !direct_is_filter_ && lua_type(state, -1) == LUA_TNUMBER ? lua_tonumber(state, -1) : -1;
    lua_pop(state, 1);
    if (is_no) return direct_is_filter_ ? std::nullopt : std::optional(0.0);
    if (answer >= 0 && answer <= 1) return answer;
    call(ask_);  // the checked way, which says what is wrong with an answer
  } catch (const Error& error) {
    std::string who;
    for (const int plane : planes) who += " " + std::to_string(host_->scene->ids[static_cast<std::size_t>(plane)]);
    throw located(error, " (constraint '" + name_ + "', planes" + who + ")");
  }
  const double degree = lua_tonumber(state, -1);
  lua_pop(state, 1);
  return degree < 0 ? std::nullopt : std::optional(degree);
}

std::string RuleFile::features_read() const { return lines_of(host_->features_read); }

double RuleFile::value(int plane) {
  lua_State* state = host_->lua.get();
  lua_rawgeti(state, LUA_REGISTRYINDEX, ask_);
  push_plane(*host_, plane);
  try {
    host_->lua.call(1, 1);
  } catch (const Error& error) {
    throw located(error, " (feature '" + name_ + "', plane " +
                                    std::to_string(host_->scene->ids[static_cast<std::size_t>(plane)]) + ")");
  }
  const double value = lua_isnil(state, -1) ? std::numeric_limits<double>::quiet_NaN() : lua_tonumber(state, -1);
  lua_pop(state, 1);
  return value;
}

}  // namespace scenelore::rules
