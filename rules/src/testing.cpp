#include "scenelore/rules/testing.hpp"

#include <algorithm>

#include "lua_files.hpp"
#include "rule_file.hpp"
#include "rule_sources.hpp"
#include "scenelore/rules/made_plane.hpp"

namespace scenelore::rules {

namespace {

/// The rule under test in its own state, with planes that the test file makes up as it goes.
class TestBench {
 public:
  TestBench(RuleSource rule, const Budget& budget) : file_(std::move(rule), budget), geometry_(scene_.planes) {
    file_.look_at(&scene_, &geometry_);
  }

  [[nodiscard]] const std::string& rule() const { return file_.name(); }
  void run(const RuleSource& test, std::vector<RuleTestCase>& cases);

 private:
  static int make(lua_State* state);
  static int add_global(lua_State* state);
  static int ask(lua_State* state);
  void push_method(lua_CFunction function) {
    lua_State* state = file_.host().lua.get();
    lua_pushlightuserdata(state, this);
    lua_pushcclosure(state, function, 1);
  }
  static TestBench& of(lua_State* state) { return *static_cast<TestBench*>(lua_touserdata(state, lua_upvalueindex(1))); }
  void offer_expectations();

  RuleFile file_;
  Scene scene_;
  PairGeometry geometry_;
  RuleTestCase* current_ = nullptr;  // whose expectations are being asked
};

int TestBench::make(lua_State* state) {
  double v[12];
  for (int i = 0; i < 12; ++i) {
    int is_number = 0;
    v[i] = lua_tonumberx(state, i + 1, &is_number);
    if (is_number == 0) throw Error("a plane's fields must be numbers");
  }
  TestBench& bench = of(state);
  const perception::Plane plane =
      make_plane({.center = {v[0], v[1], v[2]}, .normal = {v[3], v[4], v[5]}, .length = v[9], .width = v[10],
                  .along = {v[6], v[7], v[8]}, .rmse = v[11]});
  bench.scene_.ids.push_back(static_cast<kb::PlaneId>(bench.scene_.ids.size()) + 1);
  bench.scene_.planes.push_back(plane);
  push_plane(bench.file_.host(), bench.geometry_.size() - 1);
  return 1;
}

int TestBench::add_global(lua_State* state) {
  lua_rawgeti(state, LUA_REGISTRYINDEX, of(state).file_.host().environment);
  lua_insert(state, 1);
  lua_rawset(state, 1);
  return 0;
}

/// Asks the rule, and notes what was asked about which planes.
int TestBench::ask(lua_State* state) {
  TestBench& bench = of(state);
  const bool pair = lua_gettop(state) == 2;
  const int a = pair ? plane_argument_or_none(state, 1) : -1, b = pair ? plane_argument_or_none(state, 2) : -1;
  bench.file_.push_ask();
  lua_insert(state, 1);
  lua_call(state, lua_gettop(state) - 1, 1);
  if (a >= 0 && b >= 0 && bench.current_ != nullptr) {
    const auto plane = [&](int i) { return bench.scene_.planes[static_cast<std::size_t>(i)]; };
    bench.current_->asked.push_back({plane(a), plane(b), lua_tonumber(state, -1)});
  }
  return 1;
}

/// Leaves the list of cases on the stack.
void TestBench::offer_expectations() {
  RuleHost& host = file_.host();
  host.lua.load(embedded("rules/lua/expect.lua"), LuaState::kPrelude);
  enter_environment(host);
  push_method(guarded<make>);
  push_method(guarded<ask>);
  push_method(guarded<add_global>);
  host.lua.call(3, 1);
}

void TestBench::run(const RuleSource& test, std::vector<RuleTestCase>& cases) {
  RuleHost& host = file_.host();
  lua_State* state = host.lua.get();
  offer_expectations();
  host.lua.load(test.text, test.shown);
  enter_environment(host);
  host.lua.call(0, 0);
  const int list = lua_gettop(state);
  for (lua_Integer i = 1, n = static_cast<lua_Integer>(lua_rawlen(state, list)); i <= n; ++i) {
    lua_rawgeti(state, list, i);
    lua_getfield(state, -1, "name");
    cases.push_back({.name = lua_tostring(state, -1), .failure = {}, .asked = {}});
    current_ = &cases.back();
    lua_pop(state, 1);
    lua_getfield(state, -1, "body");
    try {
      host.lua.call(0, 0);
    } catch (const Error& error) {
      cases.back().failure = error.what();
    }
    lua_settop(state, list);
  }
  lua_pop(state, 1);
}

std::string rule_of(const std::string& test) { return test.substr(0, test.size() - 9) + ".lua"; }

RuleTestFile run_file(const RuleSource& test, const RuleSource* rule, const Budget& budget) {
  RuleTestFile out{.file = test.shown};
  try {
    if (rule == nullptr) throw Error(test.shown + ": there is no " + rule_of(test.shown) + " beside it to test");
    TestBench bench(*rule, budget);
    out.rule = bench.rule();
    bench.run(test, out.cases);
    if (out.cases.empty()) throw Error(test.shown + ": has no case(\"a sentence\", function() … end)");
  } catch (const Error& error) {
    out.failure = error.what();
  }
  return out;
}

std::vector<RuleSource> all_sources(const std::vector<std::filesystem::path>& directories) {
  std::vector<RuleSource> out;
  if (directories.empty()) {
    for (const EmbeddedFile& file : lua_files()) out.push_back({std::string(file.name), std::string(file.text)});
  }
  for (const std::filesystem::path& directory : directories) {
    for (RuleSource& source : sources_below(directory, true)) out.push_back(std::move(source));
  }
  std::sort(out.begin(), out.end(), [](const auto& a, const auto& b) { return a.shown < b.shown; });
  return out;
}

}  // namespace

bool RuleTestFile::passed() const {
  return failure.empty() && std::all_of(cases.begin(), cases.end(), [](const auto& c) { return c.failure.empty(); });
}

std::vector<RuleTestFile> run_rule_tests(const std::vector<std::filesystem::path>& directories, Budget budget) {
  std::vector<RuleTestFile> out;
  const std::vector<RuleSource> sources = all_sources(directories);
  for (const RuleSource& test : sources) {
    if (!is_test_name(test.shown)) continue;
    const auto rule = std::find_if(sources.begin(), sources.end(),
                                   [&](const RuleSource& s) { return s.shown == rule_of(test.shown); });
    out.push_back(run_file(test, rule == sources.end() ? nullptr : &*rule, budget));
  }
  return out;
}

std::string as_text(const std::vector<RuleTestFile>& files) {
  std::string out;
  std::size_t failed = 0, cases = 0;
  for (const RuleTestFile& file : files) {
    out += (file.passed() ? "ok      " : "FAILED  ") + file.file + "\n";
    if (!file.failure.empty()) out += "        " + file.failure + "\n";
    for (const RuleTestCase& test : file.cases) {
      ++cases;
      if (!test.failure.empty()) out += "        " + test.name + ": " + test.failure + "\n";
    }
    failed += !file.passed();
  }
  return out + std::to_string(cases) + " cases in " + std::to_string(files.size()) + " files, " +
         (failed == 0 ? "all good" : std::to_string(failed) + " files failed") + "\n";
}

std::string as_tap(const std::vector<RuleTestFile>& files) {
  std::string lines;
  int count = 0;
  const auto line = [&](const std::string& name, const std::string& failure) {
    lines += (failure.empty() ? "ok " : "not ok ") + std::to_string(++count) + " - " + name + "\n";
    if (!failure.empty()) lines += "# " + failure + "\n";
  };
  for (const RuleTestFile& file : files) {
    if (!file.failure.empty()) line(file.file, file.failure);
    for (const RuleTestCase& test : file.cases) line(file.rule + ": " + test.name, test.failure);
  }
  return "TAP version 13\n1.." + std::to_string(count) + "\n" + lines;
}

}  // namespace scenelore::rules
