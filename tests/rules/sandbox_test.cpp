// Rules from strangers are harmless: each attack known to beat a count hook, an allocator limit or both ends in an Error.
#include <gtest/gtest.h>

#include <chrono>

#include "pair_geometry.hpp"
#include "rule_file.hpp"
#include "scenelore/rules/made_plane.hpp"

namespace scenelore::rules {
namespace {

using std::chrono::milliseconds;

const Budget kSmall{.instructions = 2'000'000, .time = milliseconds(400), .memory_bytes = 16u << 20};

std::string relation_with(const std::string& body) {
  return "return relation { api = 1, name = 'attack', summary = 's', degree = function(a, b)\n" + body + "\nend }\n";
}

/// What comes of asking a relation with this body about two planes; "<degree>" when nothing went wrong.
std::string outcome_of_text(const std::string& text) {
  const Scene scene = make_scene(std::vector<MadePlane>{{}, {.center = {0, 0, 1}}});
  PairGeometry geometry(scene.planes);
  const auto start = std::chrono::steady_clock::now();
  std::string outcome;
  try {
    RuleFile file({"attack.lua", text}, kSmall);
    file.look_at(&scene, &geometry);
    outcome = std::to_string(file.degree(0, 1));
  } catch (const Error& error) {
    outcome = error.what();
  }
  EXPECT_LT(std::chrono::steady_clock::now() - start, milliseconds(5000)) << text;
  return outcome;
}

std::string outcome_of(const std::string& body) { return outcome_of_text(relation_with(body)); }

struct Attack {
  const char* name;
  const char* body;
  const char* expected;  ///< a part of the Error's text
};

class Sandbox : public testing::TestWithParam<Attack> {};

TEST_P(Sandbox, EndsTheAttackWithAnError) {
  const std::string outcome = outcome_of(GetParam().body);
  EXPECT_NE(outcome.find(GetParam().expected), std::string::npos) << outcome;
  EXPECT_EQ(outcome.rfind("attack.lua:", 0), 0U) << "names the file: " << outcome;
}

const Attack kAttacks[] = {
    {"LoopsForEver", "while true do end", "does it loop for ever?"},
    {"LoopsInsidePcall", "while true do pcall(function() while true do end end) end", "does it loop for ever?"},
    {"NestsPcalls", "local function f() pcall(f) return f() end f()", "attack.lua:"},
    {"RecursesForEver", "local function f() return 1 + f() end return f()", "attack.lua:"},
    {"RepeatsAText", "return #('x'):rep(1 << 62)", "string has no 'rep'"},
    {"MatchesSlowly", "return ('a'):find(('.-'))", "string has no 'find'"},
    {"SubstitutesSlowly", "return string.gsub('a', 'a', 'b')", "string has no 'gsub'"},
    {"FormatsHugely", "return #string.format('%99999d', 1)", "attack.lua:"},
    {"MovesATable", "table.move({}, 1, 1 << 62, 2)", "table has no 'move'"},
    {"RemovesFromAHugeLength", "table.remove(setmetatable({}, { __len = function() return 1 << 62 end }))", "'setmetatable' is not declared"},
    {"LoopsInAFinalizer", "setmetatable({}, { __gc = function() while true do end end })", "'setmetatable' is not declared"},
    {"LoopsInAHandler", "xpcall(error, function() while true do end end)", "'xpcall' is not declared"},
    {"FillsMemoryWithText", "local s = 'x' while true do s = s .. s end", "used more than 16 MB of memory"},
    {"FillsMemoryWithTables", "local t = {} while true do t = { t, {} } end", "attack.lua:"},
    {"FillsMemoryInsidePcall", "local t = {} while true do pcall(function() while true do t[#t + 1] = {} end end) end", "attack.lua:"},
    {"FillsTheStack", "while true do pcall(table.unpack, {}, 1, 900000) end", "attack.lua:"},
    {"CopiesArguments", "local function f(...) return f(...) end return f(table.unpack({}, 1, 200000))", "attack.lua:"},
    {"InsertsInFront", "local t = {} while true do table.insert(t, 1, 0) end", "attack.lua:"},
    {"LoadsText", "return load('return 1')()", "'load' is not declared"},
    {"ReadsAFile", "return dofile('/etc/passwd')", "'dofile' is not declared"},
    {"RequiresAModule", "return require('os')", "'require' is not declared"},
    {"RunsAProgram", "return os.execute('true')", "'os' is not declared; rules reach nothing outside"},
    {"OpensAFile", "return io.open('/etc/passwd')", "'io' is not declared"},
    {"StartsACoroutine", "return coroutine.wrap(function() end)()", "'coroutine' is not declared"},
    {"UsesDebug", "return debug.getregistry()", "'debug' is not declared"},
    {"CollectsGarbage", "collectgarbage('stop')", "'collectgarbage' is not declared"},
    {"ReadsMetatablesOfTexts", "return getmetatable('').__index", "'getmetatable' is not declared"},
    {"ChangesTheLibraryThroughAText", "return ('').dump(print)", "string has no 'dump'"},
    {"ChangesAPlane", "a.z = 7", "planes cannot be changed"},
    {"ChangesANormal", "a.normal.x = 7", "planes cannot be changed"},
    {"ReadsAPlanesTable", "return rawget(a, 'z')", "table expected"},
    {"MakesAGlobal", "counter = 1", "'counter' would be a global; write 'local counter'"},
    {"MisspellsAGlobal", "return fallof(1, 2, 3)", "'fallof' is not declared; did you mean 'falloff'?"},
    {"MisspellsAField", "return a.hight", "a plane has no 'hight'; did you mean 'height'?"},
    {"MisspellsAFunction", "return geometry.gapp(a, b)", "geometry has no 'gapp'; did you mean 'gap'?"},
    {"MisspellsATolerance", "return (select(3, a, b, 1)).x", "attack.lua:2: attempt to index a number value"},
    {"PassesNoPlane", "return geometry.gap(a, 3)", "attack.lua:2: geometry.gap: argument 2 must be a plane, not a number"},
    {"PassesANormalAsPlane", "return geometry.gap(a, b.normal)", "argument 2 must be a plane"},
    {"ThrowsATable", "error({ code = 1 })", "attack.lua:2: error with a table instead of a text"},
    {"ThrowsNothing", "error()", "error with a nil instead of a text"},
    {"ThrowsALongText", "error(table.concat({ 'x', 'y' }, ('12345678'):upper()))", "x12345678y"},
    {"RollsDice", "return math.random()", "math has no 'random'"},
    {"ReadsAddresses", "return string.format('%p', a)", "%p is not available"},
    {"OrdersKeysByAddress", "for k in pairs({ [{}] = 1 }) do return k end", "a key is a table"},
    {"UsesNext", "return next({})", "'next' is not declared; use pairs"},
    {"PrintsSomething", "print(a)", "'print' is not declared"},
    {"JudgesNothing", "local d = falloff(nil, 1, 2)\nreturn d", "attack.lua:2: attempt to perform arithmetic on a nil value (local 'value')"},
    {"ReturnsNothing", "", "degree returned nil; it must return a number from 0 to 1, true or false"},
    {"ReturnsAText", "return 'yes'", "degree returned 'yes'"},
    {"ReturnsNotANumber", "return 0 / 0", "it must lie in 0 to 1"},
    {"ReturnsTooMuch", "return 1.5", "degree returned 1.5; it must lie in 0 to 1"},
    {"ReturnsTooLittle", "return -0.1", "degree returned -0.1; it must lie in 0 to 1"},
};

std::string attack_name(const testing::TestParamInfo<Attack>& tested) { return tested.param.name; }

INSTANTIATE_TEST_SUITE_P(Attacks, Sandbox, testing::ValuesIn(kAttacks), attack_name);

TEST(SandboxedFile, LoadsNoBytecode) {
  EXPECT_EQ(outcome_of_text("\x1bLua garbage"), "attack.lua: is compiled Lua; only text is loaded");
}

TEST(SandboxedFile, IsHeldToTheBudgetWhileLoading) {
  const std::string outcome = outcome_of_text("while true do end");
  EXPECT_NE(outcome.find("attack.lua:1: stopped after"), std::string::npos) << outcome;
}

TEST(SandboxedFile, CanBeAskedAgainAfterAnError) {
  const Scene scene = make_scene(std::vector<MadePlane>{{}, {.center = {0, 0, 1}}});
  PairGeometry geometry(scene.planes);
  RuleFile file({"a.lua", relation_with("if a.z < b.z then while true do pcall(error) end end return 0.25")}, kSmall);
  file.look_at(&scene, &geometry);
  for (int round = 0; round < 3; ++round) {
    EXPECT_THROW((void)file.degree(0, 1), Error);
    EXPECT_EQ(file.degree(1, 0), 0.25);
  }
}

TEST(SandboxedFile, SeesKeysInTheSameOrderInEveryRun) {
  const std::string body =
      "local order = {}\n"
      "for k in pairs({ zebra = 1, apple = 2, [3] = 3, [1] = 1, mango = 4, [true] = 5 }) do order[#order + 1] = tostring(k) end\n"
      "error(table.concat(order, ' '), 0)";
  EXPECT_EQ(outcome_of(body), "attack.lua: true 1 3 apple mango zebra (relation 'attack', planes 1 and 2)");
}

TEST(SandboxedFile, SortsStably) {
  const std::string body =
      "local t = {}\n"
      "for i = 1, 200 do t[i] = { key = i % 3, place = i } end\n"
      "table.sort(t, function(p, q) return p.key < q.key end)\n"
      "for i = 2, 200 do if t[i - 1].key > t[i].key or (t[i - 1].key == t[i].key and t[i - 1].place > t[i].place) then return 0 end end\n"
      "return 1";
  EXPECT_EQ(outcome_of(body), "1.000000");
}

TEST(SandboxedFile, NamesThePlanesItFailedOn) {
  EXPECT_EQ(outcome_of("error('no')"), "attack.lua:2: no (relation 'attack', planes 1 and 2)");
}

TEST(SandboxedFile, NamesThePlanesItFailedOnAmongManyPairs) {
  const Scene scene = make_scene(std::vector<MadePlane>{{}, {.center = {0, 0, 1}}, {.center = {0, 0, 2}}});
  PairGeometry geometry(scene.planes);
  RuleFile file({"a.lua", relation_with("if a.z > 1.5 and b.z > 0.5 then error('no') end return a.z > b.z")}, kSmall);
  file.look_at(&scene, &geometry);
  const std::vector<std::pair<int, int>> pairs{{1, 0}, {0, 1}, {2, 0}, {0, 2}, {2, 1}, {1, 2}};
  double degrees[6] = {};
  try {
    file.degrees(pairs, degrees);
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "a.lua:2: no (relation 'attack', planes 3 and 2)");
  }
  file.degrees(std::span(pairs).first(4), degrees);
  EXPECT_EQ(std::vector<double>(degrees, degrees + 4), (std::vector<double>{1, 0, 1, 0}));
}

TEST(SandboxedFile, HasTheWholeBudgetForEachOfManyPairs) {
  const Scene scene = make_scene(std::vector<MadePlane>{{}, {.center = {0, 0, 1}}});
  PairGeometry geometry(scene.planes);
  RuleFile file({"a.lua", relation_with("for i = 1, 200000 do end return 1")}, kSmall);
  file.look_at(&scene, &geometry);
  const std::vector<std::pair<int, int>> pairs(20, {0, 1});
  std::vector<double> degrees(pairs.size());
  file.degrees(pairs, degrees.data());
  EXPECT_EQ(degrees, std::vector<double>(pairs.size(), 1));
}

TEST(SandboxedFile, TellsWhatIsWrongWithLimits) {
  EXPECT_EQ(outcome_of("return geometry.gap(a, b, 2, 0.5) == 1 and geometry.gap(a, b, 0.1, 0.5) == 0.5"), "1.000000") << "in any order";
  EXPECT_EQ(outcome_of("return geometry.gap(a, b, 2)"),
            "attack.lua:2: geometry.gap: arguments 3 and 4 must be the two limits between which the answer matters (relation 'attack', "
            "planes 1 and 2)");
  EXPECT_EQ(outcome_of("return geometry.footprint_overlap(a, b, 0, 'x', 1)").substr(0, 85),
            "attack.lua:2: geometry.footprint_overlap: arguments 4 and 5 must be the two limits be");
}

}  // namespace
}  // namespace scenelore::rules
