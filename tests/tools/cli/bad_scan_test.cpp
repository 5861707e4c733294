// Scans that are broken or odd: one clear error or a sensible result, the documented exit code, nothing lost.
#include <gmock/gmock.h>

#include <cstring>
#include <limits>

#include "command_line.hpp"

namespace scenelore::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;

std::string ply(const std::vector<std::array<float, 3>>& points, std::size_t promised) {
  std::string text = "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(promised) +
                     "\nproperty float x\nproperty float y\nproperty float z\nend_header\n";
  text.append(reinterpret_cast<const char*>(points.data()), points.size() * sizeof(points[0]));
  return text;
}

std::string ply(const std::vector<std::array<float, 3>>& points) { return ply(points, points.size()); }

class BadScan : public CommandLine {
 protected:
  /// Runs over a scan with this content, with a knowledge base that knew something before; checks that it still does.
  Finished run_on(const std::string& content, const std::string& name = "scan.ply") {
    EXPECT_EQ(scenelore({"kb", "init", "@kb.gpkg"}).code, 0);
    edit("kb.gpkg", "INSERT INTO object_class (id, name, prior, description, color, fallback) VALUES (77, 'mine', 0.01, '', '#112233', 0)");
    write_file(folder_ / name, content);
    const Finished finished = scenelore({"run", "@" + name, "--kb", "@kb.gpkg"});
    EXPECT_EQ(ask("kb.gpkg", "SELECT name FROM object_class WHERE id = 77"), "mine\n");
    EXPECT_EQ(ask("kb.gpkg", "PRAGMA integrity_check"), "ok\n");
    return finished;
  }
};

TEST_F(BadScan, IsRefusedWhenThereIsNoSuchFile) {
  const Finished finished = scenelore({"run", "@nowhere.ply"});
  EXPECT_EQ(finished.code, 3);
  EXPECT_THAT(finished.err, HasSubstr("nowhere.ply"));
}

TEST_F(BadScan, IsRefusedWhenEmpty) {
  const Finished finished = run_on("");
  EXPECT_EQ(finished.code, 3);
  EXPECT_THAT(finished.err, AllOf(HasSubstr("scan.ply"), HasSubstr("empty")));
}

TEST_F(BadScan, IsRefusedWhenTruncatedAndSaysHowManyPointsAreThere) {
  const Finished finished = run_on(ply({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, 1000));
  EXPECT_EQ(finished.code, 3);
  EXPECT_THAT(finished.err, AllOf(HasSubstr("scan.ply"), HasSubstr("1000"), HasSubstr("3")));
}

TEST_F(BadScan, IsRefusedWhenTextStandsWhereANumberShould) {
  const Finished finished = run_on("ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
                                   "property float z\nend_header\n0 0 0\n1 two 3\n");
  EXPECT_EQ(finished.code, 3);
  EXPECT_THAT(finished.err, AllOf(HasSubstr("scan.ply"), HasSubstr("9"), HasSubstr("y"), HasSubstr("two")));
}

TEST_F(BadScan, IsRefusedWithoutCoordinatesAndSaysWhatIsThere) {
  const Finished finished = run_on("ply\nformat ascii 1.0\nelement vertex 1\nproperty float intensity\nend_header\n0.5\n");
  EXPECT_EQ(finished.code, 3);
  EXPECT_THAT(finished.err, AllOf(HasSubstr("scan.ply"), HasSubstr("intensity")));
}

TEST_F(BadScan, IsRefusedWhenNoPointIsValid) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const Finished finished = run_on(ply(std::vector<std::array<float, 3>>(500, {nan, nan, nan})));
  EXPECT_EQ(finished.code, 3);
  EXPECT_THAT(finished.err, AllOf(HasSubstr("scan.ply"), HasSubstr("finite")));
}

TEST_F(BadScan, HasNoPlanesWhenAllPointsAreEqual) {
  const Finished finished = run_on(ply(std::vector<std::array<float, 3>>(5000, {1, 2, 3})));
  EXPECT_EQ(finished.code, 1) << finished.err;
  EXPECT_THAT(finished.err, HasSubstr("No plane"));
}

TEST_F(BadScan, HasNoPlanesWithTenPoints) {
  std::vector<std::array<float, 3>> points;
  for (int i = 0; i < 10; ++i) points.push_back({static_cast<float>(i % 3), static_cast<float>(i / 3), 0.1F * static_cast<float>(i)});
  const Finished finished = run_on(ply(points));
  EXPECT_EQ(finished.code, 1) << finished.err;
  EXPECT_THAT(finished.err, HasSubstr("No plane"));
}

TEST_F(BadScan, HasNoPlanesWhenPointsLieOnALine) {
  std::vector<std::array<float, 3>> points;
  for (int i = 0; i < 5000; ++i) points.push_back({0.001F * static_cast<float>(i), 0.002F * static_cast<float>(i), 0});
  const Finished finished = run_on(ply(points));
  EXPECT_EQ(finished.code, 1) << finished.err;
}

TEST_F(BadScan, IsSuspectedOfMillimetres) {
  std::vector<std::array<float, 3>> points;
  for (int i = 0; i < 200; ++i) {
    for (int j = 0; j < 200; ++j) {
      points.push_back({20.0F * static_cast<float>(i), 20.0F * static_cast<float>(j), 0});
      points.push_back({20.0F * static_cast<float>(i), 0, 12.0F * static_cast<float>(j)});
    }
  }
  const Finished finished = run_on(ply(points));
  EXPECT_LE(finished.code, 1) << finished.err;
  EXPECT_THAT(finished.err, HasSubstr("millimetres"));
}

TEST_F(BadScan, IsRefusedWhenItIsSomethingElse) {
  const Finished finished = run_on("<html>404</html>\n", "scan.bin");
  EXPECT_EQ(finished.code, 3);
  EXPECT_THAT(finished.err, HasSubstr("scan.bin"));
}

}  // namespace
}  // namespace scenelore::test
