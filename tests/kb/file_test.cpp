// The file as such: opening what is odd, migrating, surviving a kill, being a valid GeoPackage.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <thread>

#include "process.hpp"
#include "rooms.hpp"
#include "scenelore/kb/error.hpp"
#include "sqlite.hpp"

namespace scenelore::kb {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::ask;
using testing::error_of;
using testing::TemporaryFolder;

// A file with one stored and labelled room.
fs::path labelled_room(const TemporaryFolder& folder) {
  KnowledgeBase base = KnowledgeBase::create(folder / "room.gpkg");
  const testing::Room room = testing::room();
  const ScanId scan = base.store_scan(room.scan, room.planes, room.plane_of_point);
  base.store_features(scan, {1, 2, 3, 4}, built_in_features(*base.find_scan("room"), base.planes(scan)));
  base.store_inference(scan, testing::inference(base.planes(scan)));
  return folder / "room.gpkg";
}

std::string refused(const fs::path& path, Access access = Access::read_write) {
  return error_of([&] { KnowledgeBase::open(path, access); });
}

bool has_program(const std::string& name, const TemporaryFolder& folder) {
  return test::run({"sh", "-c", "command -v " + name}, folder).code == 0;
}

TEST(KnowledgeFile, IsRefusedWithAReasonWhenItIsNone) {
  const TemporaryFolder folder;
  EXPECT_THAT(refused(folder / "none.gpkg"), AllOf(HasSubstr("none.gpkg"), HasSubstr("kb init")));
  EXPECT_FALSE(fs::exists(folder / "none.gpkg"));
  EXPECT_THAT(refused(folder.path()), HasSubstr("folder"));
  test::write_file(folder / "empty.gpkg", "");
  EXPECT_THAT(refused(folder / "empty.gpkg"), HasSubstr("empty"));
  test::write_file(folder / "text.gpkg", std::string(5000, 'x'));
  EXPECT_THAT(refused(folder / "text.gpkg"), AllOf(HasSubstr("text.gpkg"), HasSubstr("no SQLite file")));
  Database(folder / "other.gpkg", OpenMode::create).execute("CREATE TABLE mine (x)");
  EXPECT_THAT(refused(folder / "other.gpkg"), HasSubstr("not a Scenelore knowledge base"));
}

TEST(KnowledgeFile, ThatIsCutShortIsRefused) {
  const TemporaryFolder folder;
  const fs::path path = labelled_room(folder);
  const auto size = fs::file_size(path);
  for (const std::uintmax_t left : {size - 4096, size / 2, std::uintmax_t{4096}, std::uintmax_t{100}}) {
    fs::resize_file(path, left);
    EXPECT_THAT(refused(path), AnyOf(HasSubstr("damaged"), HasSubstr("no SQLite file"))) << left;
    EXPECT_EQ(fs::file_size(path), left);
  }
}

TEST(KnowledgeFile, OfANewerVersionIsReadOnlyIfItSaysSo) {
  const TemporaryFolder folder;
  const fs::path path = labelled_room(folder);
  Database(path, OpenMode::read_write).execute("UPDATE scenelore_meta SET schema_version = 99, oldest_reader = 98");
  EXPECT_THAT(refused(path), AllOf(HasSubstr("newer Scenelore"), HasSubstr("99")));
  EXPECT_THAT(refused(path, Access::read_only), HasSubstr("newer Scenelore"));
  Database(path, OpenMode::read_write).execute("UPDATE scenelore_meta SET oldest_reader = 2");
  EXPECT_THAT(refused(path), HasSubstr("must not write"));
  EXPECT_EQ(KnowledgeBase::open(path, Access::read_only).planes(1).size(), 4U);
}

TEST(KnowledgeFile, OfVersionOneIsMigratedWithAllItsRows) {
  const TemporaryFolder folder;
  const fs::path path = folder / "old.gpkg";
  Database(path, OpenMode::create).execute(test::read_file(fs::path(SCENELORE_SOURCE_DIR) / "tests/kb/data/version_1.sql"));
  EXPECT_THAT(refused(path, Access::read_only), HasSubstr("older schema version 1"));
  const KnowledgeBase base = KnowledgeBase::open(path);
  EXPECT_THAT(ask(base, "SELECT schema_version, oldest_reader FROM scenelore_meta"), ElementsAre("13|1"));
  EXPECT_EQ(base.knowledge().classes.size(), 3U);
  ASSERT_EQ(base.planes(1).size(), 2U);
  EXPECT_EQ(base.planes(1)[0].plane.behind, -1) << "was not measured then";
  EXPECT_EQ(base.planes(1)[0].plane.edge_free_top, -1);
  EXPECT_THAT(base.truth(1), ElementsAre(std::pair<PlaneId, std::string>(1, "table")));
  EXPECT_THAT(base.plane_of_point(1), ElementsAre(1, 1, 1, 1, 1, 2, 2, 2, 2, 2));
  EXPECT_THAT(ask(base, "SELECT count(*) FROM plane_plan WHERE geom IS NOT NULL"), ElementsAre("2"));
  // The same tables as a file made today.
  const KnowledgeBase fresh = KnowledgeBase::create(folder / "new.gpkg", "empty");
  const std::string schema = "SELECT name, sql FROM sqlite_master ORDER BY name";
  EXPECT_EQ(ask(base, schema), ask(fresh, schema));
}

TEST(KnowledgeFile, HasOnePartAtRestEvenAfterAGisSwitchedItToWal) {
  const TemporaryFolder folder;
  const fs::path path = labelled_room(folder);
  Database(path, OpenMode::read_write).execute("PRAGMA journal_mode = WAL");
  KnowledgeBase::open(path);
  EXPECT_THAT(ask(KnowledgeBase::open(path, Access::read_only), "SELECT name FROM scan"), ElementsAre("room"));
  const std::string header = test::read_file(path).substr(18, 2);  // file format versions: 1 = journal, 2 = WAL
  EXPECT_EQ(header, std::string("\1\1"));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 1);
}

TEST(KnowledgeFile, IsRolledBackByTheFirstReaderAfterAKillThatCutAChangeInTwo) {
  const TemporaryFolder folder;
  const fs::path path = labelled_room(folder);
  const std::string question = "SELECT class, feature, mean FROM class_feature ORDER BY id";
  const auto before = ask(KnowledgeBase::open(path, Access::read_only), question);
  const pid_t child = fork();
  if (child == 0) {
    Database database(path, OpenMode::read_write);
    // A cache this small writes half the change to the file before it is committed.
    database.execute("PRAGMA cache_size = 1; BEGIN; UPDATE class_feature SET mean = mean + 1; UPDATE class_density SET density = density * 2;");
    kill(getpid(), SIGKILL);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  ASSERT_GT(fs::file_size(path.string() + "-journal"), 0U);
  EXPECT_EQ(ask(KnowledgeBase::open(path, Access::read_only), question), before);
  EXPECT_FALSE(fs::exists(path.string() + "-journal"));
}

// Root may write everything, so a child without its powers looks at the read-only file. Returns the child's exit code.
int without_powers(const std::function<int()>& action) {
  const pid_t child = fork();
  if (child == 0) {
    if (geteuid() == 0 && (setgid(65534) != 0 || setuid(65534) != 0)) _exit(99);
    int code = 98;
    try {
      code = action();
    } catch (const std::exception& error) {
      fprintf(stderr, "%s\n", error.what());
    }
    _exit(code);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 97;
}

TEST(KnowledgeFile, InAReadOnlyFolderCanBeReadAndSaysSoWhenWritten) {
  for (const char* const mode : {"DELETE", "WAL"}) {
    const TemporaryFolder folder;
    const fs::path path = labelled_room(folder);
    Database(path, OpenMode::read_write).execute(std::string("PRAGMA journal_mode = ") + mode);
    chmod(path.c_str(), 0444);
    chmod(folder.path().c_str(), 0555);
    const int code = without_powers([&] {
      if (KnowledgeBase::open(path, Access::read_only).planes(1).size() != 4) return 1;
      KnowledgeBase base = KnowledgeBase::open(path);
      if (base.knowledge().classes.empty()) return 2;
      try {
        base.store_inference(1, {});
      } catch (const Error& error) {
        return std::string(error.what()).find("read-only") != std::string::npos ? 0 : 3;
      }
      return 4;
    });
    chmod(folder.path().c_str(), 0755);
    EXPECT_EQ(code, 0) << mode;
  }
}

TEST(KnowledgeFile, LosesNothingWhenTheWriterIsKilled) {
  const TemporaryFolder folder;
  const fs::path path = labelled_room(folder);
  for (int round = 0; round < 12; ++round) {
    const pid_t child = fork();
    if (child == 0) {
      KnowledgeBase base = KnowledgeBase::open(path);
      testing::Room room = testing::room();
      for (int i = 0;; ++i) {  // alternates between two states of the scan, until it is killed
        room.scan.sha256 = std::string(64, i % 2 == 0 ? 'b' : 'c');
        const ScanId scan = base.store_scan(room.scan, room.planes, room.plane_of_point);
        base.store_inference(scan, testing::inference(base.planes(scan)));
      }
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(20 + 7 * round));
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    const KnowledgeBase base = KnowledgeBase::open(path);
    EXPECT_THAT(ask(base, "PRAGMA integrity_check"), ElementsAre("ok"));
    EXPECT_TRUE(ask(base, "PRAGMA foreign_key_check").empty());
    EXPECT_EQ(base.planes(1).size(), 4U);
    EXPECT_EQ(base.plane_of_point(1).size(), 450U);
    const std::size_t labels = base.labels(1).size();
    EXPECT_TRUE(labels == 0 || labels == 4) << labels;  // a new segmentation has no labels yet, or all
    EXPECT_EQ(base.knowledge().classes.size(), 14U);
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 1);
}

TEST(KnowledgeFile, IsAGeoPackageThatGdalReadsWithoutAWarning) {
  const TemporaryFolder folder;
  if (!has_program("ogrinfo", folder)) GTEST_SKIP() << "ogrinfo (package gdal-bin) is not installed";
  const fs::path path = labelled_room(folder);
  const test::Finished finished = test::run({"ogrinfo", "-al", path.string()}, folder);
  EXPECT_EQ(finished.code, 0);
  EXPECT_EQ(finished.err, "");
  EXPECT_THAT(finished.out, AllOf(Not(HasSubstr("Warning")), HasSubstr("Layer name: labelled_plane_3d"),
                                  HasSubstr("Layer name: labelled_plane_plan"), HasSubstr("Layer name: class_constraint"),
                                  HasSubstr("POLYGON Z ((0.3 0.6 0.72,"), HasSubstr("class (String) = flat_screen"),
                                  HasSubstr("Geometry: 3D Polygon"), HasSubstr("Geometry: Polygon")));
}

TEST(KnowledgeFile, HasFootprintsThatAreValidPolygons) {
  const TemporaryFolder folder;
  if (!has_program("ogrinfo", folder)) GTEST_SKIP() << "ogrinfo (package gdal-bin) is not installed";
  const fs::path path = labelled_room(folder);
  const test::Finished finished =
      test::run({"ogrinfo", path.string(), "-dialect", "SQLite", "-sql",
                 "SELECT sum(ST_IsValid(geom)) AS valid, count(*) AS n, sum(ST_Area(geom)) AS area FROM labelled_plane_plan"}, folder);
  EXPECT_THAT(finished.out, AllOf(HasSubstr("valid (Integer) = 4"), HasSubstr("n (Integer) = 4"), HasSubstr("area (Real) = 13.305")));
}

TEST(KnowledgeFile, TakesALabelEditedInAGisAsTruth) {
  const TemporaryFolder folder;
  if (!has_program("ogrinfo", folder)) GTEST_SKIP() << "ogrinfo (package gdal-bin) is not installed";
  const fs::path path = labelled_room(folder);
  const auto edit = [&](const std::string& layer, const std::string& name, const std::string& plane) {
    const test::Finished finished =
        test::run({"ogrinfo", path.string(), "-sql", "UPDATE " + layer + " SET class = '" + name + "' WHERE id = " + plane}, folder);
    EXPECT_EQ(finished.code, 0);
    EXPECT_THAT(finished.err, Not(HasSubstr("ERROR")));
  };
  edit("labelled_plane_3d", "cabinet", "3");
  edit("labelled_plane_plan", "door", "2");
  EXPECT_THAT(ask(KnowledgeBase::open(path, Access::read_only), "SELECT plane_id, class FROM truth ORDER BY 1"),
              ElementsAre("2|door", "3|cabinet"));
}

TEST(KnowledgeFile, PassesSqlitesOwnChecks) {
  const TemporaryFolder folder;
  const KnowledgeBase base = KnowledgeBase::open(labelled_room(folder), Access::read_only);
  EXPECT_THAT(ask(base, "PRAGMA integrity_check"), ElementsAre("ok"));
  EXPECT_TRUE(ask(base, "PRAGMA foreign_key_check").empty());
  EXPECT_THAT(ask(base, "PRAGMA application_id"), ElementsAre("1196444487"));
  EXPECT_THAT(ask(base, "PRAGMA user_version"), ElementsAre("10300"));
  EXPECT_TRUE(ask(base, "SELECT name FROM pragma_table_list WHERE type = 'table' AND schema = 'main' AND strict = 0 AND name NOT LIKE 'gpkg%' "
                        "AND name NOT LIKE 'sqlite%' AND name NOT IN ('plane', 'plane_plan')").empty());
}

}  // namespace
}  // namespace scenelore::kb
