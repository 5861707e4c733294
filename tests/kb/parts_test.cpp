// The parts of kb that no user sees: SQLite layer, hash, blobs, runs, footprints, matching.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "footprint.hpp"
#include "geometry_blob.hpp"
#include "point_runs.hpp"
#include "rooms.hpp"
#include "scenelore/kb/error.hpp"
#include "scenelore/kb/sha256.hpp"
#include "sqlite.hpp"
#include "scenelore/kb/suggest.hpp"
#include "truth_transfer.hpp"

namespace scenelore::kb {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::error_of;
using testing::TemporaryFolder;

TEST(Sha256, GivesTheDigestsOfTheStandard) {
  EXPECT_EQ(sha256_of(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256_of("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256_of("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(sha256_of(std::string(1'000'000, 'a')), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, IsTheSameWithAndWithoutTheProcessorsInstructions) {
  std::string text;
  for (int size = 0; size < 300; ++size) {
    Sha256::use_hardware = true;
    const std::string fast = sha256_of(text);
    Sha256::use_hardware = false;
    EXPECT_EQ(sha256_of(text), fast) << size << " bytes";
    text += static_cast<char>(37 * size + 11);
  }
  Sha256::use_hardware = true;
}

TEST(Sha256, DoesNotDependOnHowTheBytesArrive) {
  const std::string text(317, 'x');
  for (std::size_t piece = 1; piece < 130; ++piece) {
    Sha256 hash;
    for (std::size_t at = 0; at < text.size(); at += piece) hash.add(std::string_view(text).substr(at, piece));
    EXPECT_EQ(hash.hex(), sha256_of(text));
  }
}

TEST(Sha256, NamesAFileThatCannotBeRead) {
  const TemporaryFolder folder;
  test::write_file(folder / "a", std::string(100'000, 'q'));
  EXPECT_EQ(sha256_of_file(folder / "a"), sha256_of(std::string(100'000, 'q')));
  EXPECT_THAT(error_of([&] { (void)sha256_of_file(folder / "b"); }), HasSubstr("b: cannot be read"));
}

TEST(PointRuns, GiveBackWhatWentIn) {
  std::mt19937 random(5);
  for (const int longest : {1, 3, 1000}) {
    std::vector<std::int32_t> numbers;
    while (numbers.size() < 5000) {
      const auto number = static_cast<std::int32_t>(random() % 300) - 1;
      numbers.insert(numbers.end(), 1 + random() % static_cast<unsigned>(longest), number);
    }
    numbers.push_back(std::numeric_limits<std::int32_t>::max() - 1);
    EXPECT_EQ(decode_runs(encode_runs(numbers), numbers.size()), numbers);
  }
  EXPECT_TRUE(decode_runs(encode_runs({}), 0).empty());
}

TEST(PointRuns, RefuseADamagedBlob) {
  std::vector<std::byte> blob = encode_runs(std::vector<std::int32_t>(500, 3));
  EXPECT_EQ(blob.size(), 3U);
  EXPECT_THROW((void)decode_runs(blob, 499), Error);
  EXPECT_THROW((void)decode_runs(blob, 501), Error);
  blob.pop_back();
  EXPECT_THROW((void)decode_runs(blob, 500), Error);
}

TEST(GeometryBlob, GivesBackThePolygonAndHasTheHeaderOfTheStandard) {
  const perception::Plane table = testing::room().planes[2];
  const std::vector<std::byte> blob = encode_polygon(table.hull, Dimensions::xyz);
  EXPECT_EQ(blob[0], std::byte{'G'});
  EXPECT_EQ(blob[3], std::byte{0x05});
  const perception::Polygon back = decode_polygon(blob);
  EXPECT_EQ(back.outer, table.hull.outer);
  EXPECT_EQ(back.holes, table.hull.holes);
  const std::vector<std::byte> empty = encode_polygon({}, Dimensions::xyz);
  EXPECT_EQ(empty[3], std::byte{0x11});
  EXPECT_TRUE(decode_polygon(empty).outer.empty());
}

TEST(GeometryBlob, RefusesEveryCutOfABlob) {
  const std::vector<std::byte> blob = encode_polygon(testing::room().planes[2].hull, Dimensions::xyz);
  for (std::size_t size = 0; size < blob.size(); ++size) {
    EXPECT_THROW((void)decode_polygon(std::span(blob).first(size)), Error) << size;
  }
}

TEST(Footprint, KeepsLevelPlanesAndDrawsWallsAsStrips) {
  const testing::Room room = testing::room();
  const perception::Polygon table = footprint(room.scan, room.planes[2]);
  EXPECT_EQ(table.outer.size(), 4U);
  ASSERT_EQ(table.holes.size(), 1U);
  for (const Eigen::Vector3d& corner : table.outer) EXPECT_EQ(corner.z(), 0);
  const perception::Polygon wall = footprint(room.scan, room.planes[1]);
  EXPECT_THAT(wall.outer, ElementsAre(Eigen::Vector3d(4, 2.975, 0), Eigen::Vector3d(4, 3.025, 0), Eigen::Vector3d(0, 3.025, 0),
                                      Eigen::Vector3d(0, 2.975, 0)));
  EXPECT_TRUE(footprint(room.scan, {}).outer.empty());
}

TEST(Footprint, TurnsTiltedScansUprightAboutTheirOrigin) {
  testing::Room room = testing::room();
  const perception::Polygon before = footprint(room.scan, room.planes[2]);
  const Eigen::Vector3d origin(690000, 5330000, 500);
  const Eigen::Quaterniond tilt(Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitX()));
  room.scan.origin = origin;
  room.scan.rotation = tilt;
  perception::Plane table = room.planes[2];
  table.normal = tilt.inverse() * table.normal;
  for (Eigen::Vector3d& corner : table.hull.outer) corner = origin + tilt.inverse() * corner;
  const perception::Polygon after = footprint(room.scan, table);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_LT((after.outer[i] - before.outer[i] - origin).head<2>().norm(), 1e-8);
}

TEST(MatchPlanes, WantsMoreThanHalfOfBoth) {
  const std::vector<std::int32_t> before = {0, 0, 0, 0, 1, 1, 2, 2, 2, 2, -1, -1};
  //                                        0 loses one; 1 is swallowed by what was 2; nothing from nothing
  const std::vector<std::int32_t> after = {5, 5, 5, 0, 7, 7, 7, 7, 7, 7, -1, -1};
  EXPECT_THAT(match_planes(before, after, 3), ElementsAre(5, -1, 7));
  EXPECT_THAT(match_planes(before, {}, 3), ElementsAre(-1, -1, -1));
}

TEST(DidYouMean, OffersTheNearestNameOrNothing) {
  EXPECT_EQ(did_you_mean("flat_scren", {"floor", "flat_screen"}), "; did you mean 'flat_screen'?");
  EXPECT_EQ(did_you_mean("elephant", {"floor", "flat_screen"}), "");
}

TEST(Sqlite, NamesTheFileAndTheExpandedStatement) {
  const TemporaryFolder folder;
  Database database(folder / "a.db", OpenMode::create);
  database.execute("CREATE TABLE t (id INTEGER PRIMARY KEY, name TEXT NOT NULL CHECK (name <> 'ab')) STRICT; -- end");
  Statement insert = database.prepare("INSERT INTO t (name) VALUES (?)");
  EXPECT_THAT(error_of([&] { insert.use()("ab").run(); }),
              AllOf(HasSubstr("a.db"), HasSubstr("CHECK"), HasSubstr("INSERT INTO t (name) VALUES ('ab')")));
  const std::string with_nul("a\0bc", 4);
  insert.use()(with_nul).run();
  Statement select = database.prepare("SELECT name FROM t");
  auto row = select.use();
  ASSERT_TRUE(row.next());
  EXPECT_EQ(row.text(0), with_nul);
  EXPECT_THAT(error_of([&] { (void)database.prepare("SELECT 1; SELECT 2"); }), HasSubstr("one SQL statement at a time"));
}

TEST(Sqlite, RollsBackATransactionThatIsNotCommitted) {
  const TemporaryFolder folder;
  Database database(folder / "a.db", OpenMode::create);
  database.execute("CREATE TABLE t (x INTEGER)");
  try {
    Transaction transaction(database);
    database.execute("INSERT INTO t VALUES (1)");
    throw Error("stop");
  } catch (const Error&) {
  }
  Statement count = database.prepare("SELECT count(*) FROM t");
  auto row = count.use();
  ASSERT_TRUE(row.next());
  EXPECT_EQ(row.integer(0), 0);
}

}  // namespace
}  // namespace scenelore::kb
