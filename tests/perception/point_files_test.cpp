#include <sys/resource.h>

#include <csignal>
#include <cstring>
#include <limits>
#include <random>

#include "point_file_support.hpp"
#include "scenelore/perception/cloud.hpp"

namespace scenelore::perception {
namespace {

using ReadPoints = PointFiles;
using WritePoints = PointFiles;

TEST_F(ReadPoints, SaysWhatIsWrongWithFilesThatAreNoPointFiles) {
  EXPECT_EQ(error_of("a.ply", ""), "a.ply is empty");
  EXPECT_EQ(error_of_reading("absent.ply"), "absent.ply: cannot be opened: No such file or directory");
  std::filesystem::create_directory(path("folder.ply"));
  EXPECT_EQ(error_of_reading("folder.ply"), "folder.ply is a folder, not a point file");
  EXPECT_EQ(error_of("photo.png", std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16)),
            "photo.png is not a PLY, PCD or text point file");
  EXPECT_EQ(error_of("letter", "Dear reader,\nthis is no scan.\n"), "letter is not a PLY, PCD or text point file");
  EXPECT_EQ(error_of("binary.xyz", std::string("1 2 3\0\1\2", 8)), "binary.xyz is not a PLY, PCD or text point file");
  EXPECT_NE(error_of("scan.las", "LASF____").find("is a LAS or LAZ file"), std::string::npos);
}

TEST_F(ReadPoints, TellsTheFormatFromTheContentNotFromTheName) {
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\nend_header\n1 2 "
      "3\n";
  const std::string pcd =
      "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 1\nDATA ascii\n1 2 3\n";
  for (const char* name : {"a.ply", "a.pcd", "a.txt", "a"}) {
    for (const std::string& content : {ply, pcd}) {
      const PointTable table = read(name, content);
      EXPECT_EQ(table.rows, 1U);
      EXPECT_EQ(table.columns[2].type, ScalarType::f32);
    }
  }
}

void expect_same_cloud(const Cloud& a, const Cloud& b) {
  ASSERT_EQ(a.size(), b.size());
  EXPECT_EQ(a.origin, b.origin);
  EXPECT_EQ(a.invalid, b.invalid);
  EXPECT_EQ(a.sensors.positions(), b.sensors.positions());
  EXPECT_EQ(a.sensors.single(), b.sensors.single());
  for (const auto axis : {&Cloud::x, &Cloud::y, &Cloud::z}) {
    EXPECT_EQ(0, std::memcmp((a.*axis).data(), (b.*axis).data(), a.size() * sizeof(float)));  // NaN is equal to itself, too
  }
}

TEST_F(ReadPoints, GivesTheCloudOfTheTableWithoutTheTable) {
  constexpr std::size_t kRows = 600'000;  // several pieces of work
  std::mt19937 random(1);
  std::uniform_real_distribution<float> place(-5, 5);
  PointTable table;
  table.rows = kRows;
  for (const char* name : {"x", "intensity", "y", "z"}) {
    std::vector<float> values(kRows);
    for (float& value : values) value = place(random);
    values[kRows / 2] = std::numeric_limits<float>::quiet_NaN();
    table.set_column(name, values);
  }
  table.viewpoint = Eigen::Vector3d(1, 2, 3);
  for (const char* name : {"scan.ply", "scan.pcd"}) {
    SCOPED_TRACE(name);
    write_points(path(name), table);
    const Cloud whole = to_cloud(read_points(path(name)), name);
    EXPECT_EQ(whole.invalid, 1U);
    for (const int threads : {1, 2, 4}) expect_same_cloud(read_cloud(path(name), threads), whole);
  }
}

TEST_F(ReadPoints, GivesTheCloudOfEveryCoordinateTypeAndEncoding) {
  for (const ScalarType type : {ScalarType::f32, ScalarType::f64, ScalarType::i16, ScalarType::i32}) {
    const PointTable table = table_of_every_type(type, false);
    for (const char* name : {"scan.ply", "scan.pcd", "scan.csv"}) {
      SCOPED_TRACE(name);
      write_points(path(name), table);
      expect_same_cloud(read_cloud(path(name)), to_cloud(read_points(path(name)), path(name).string()));
    }
  }
}

TEST_F(ReadPoints, RefusesAsACloudWhatItRefusesAsATable) {
  PointTable table;
  table.rows = 3;
  for (const char* name : {"x", "y", "z"}) table.set_column(name, std::vector<float>{1, 2, 3});
  for (const char* name : {"scan.ply", "scan.pcd"}) {
    write_points(path(name), table);
    const std::string whole = get(name);
    for (const std::string& damaged : {whole.substr(0, whole.size() - 1), whole.substr(0, whole.size() / 2), whole + "more", std::string()}) {
      const std::string expected = error_of(name, damaged);
      ASSERT_NE(expected, "no error");
      try {
        (void)read_cloud(path(name));
        ADD_FAILURE() << "read what is refused with: " << expected;
      } catch (const Error& error) {
        EXPECT_EQ(without_folder(error.what()), expected);
      }
    }
  }
  PointTable flat;
  flat.rows = 1;
  for (const char* name : {"x", "y"}) flat.set_column(name, std::vector<float>{1});
  write_points(path("flat.ply"), flat);
  EXPECT_THROW((void)read_cloud(path("flat.ply")), Error);
}

TEST_F(ReadPoints, ReadsFromAPipe) {
  put("points", "1 2 3\n4 5 6\n");
  ASSERT_EQ(::mkfifo(path("pipe.xyz").c_str(), 0600), 0);
  ASSERT_EQ(std::system(("cat '" + path("points").string() + "' > '" + path("pipe.xyz").string() + "' &").c_str()), 0);
  EXPECT_EQ(read_points(path("pipe.xyz")).rows, 2U);
}

TEST_F(ReadPoints, DamagedBytesGiveAnErrorOrSomeTableNeverACrash) {
  const PointTable table = table_of_every_type(ScalarType::f32, false);
  write_points(path("whole.ply"), table);
  write_points(path("whole.pcd"), table);
  write_points(path("whole.csv"), table);
  std::mt19937_64 random(20140801);
  for (const char* name : {"whole.ply", "whole.pcd", "whole.csv"}) {
    const std::string whole = get(name);
    int errors = 0;
    for (int round = 0; round < 3000; ++round) {
      std::string damaged = whole;
      for (std::uint64_t flips = 1 + random() % 3; flips > 0; --flips)
        damaged[random() % damaged.size()] ^= static_cast<char>(1U << (random() % 8));
      const std::string error = error_of("damaged", damaged);
      if (error == "no error") {
        const PointTable result = read_points(path("damaged"));
        ASSERT_EQ(result.bytes.size(), result.rows * result.stride);
        try {
          (void)to_cloud(result, "damaged");
        } catch (const Error&) {
        }
      } else {
        ++errors;
      }
    }
    EXPECT_GT(errors, 300) << name;
  }
}

TEST_F(ReadPoints, EveryRealScanHasTheRowsOfItsHeader) {
  const std::filesystem::path scans = SCENELORE_SHARED_DATA;
  if (!std::filesystem::exists(scans)) GTEST_SKIP() << "needs the real scans, which are not in the folder " << scans;
  int read = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(scans)) {
    if (entry.path().extension() != ".ply") continue;
    SCOPED_TRACE(entry.path());
    std::ifstream in(entry.path(), std::ios::binary);
    std::string word;
    while (in >> word && word != "vertex") {
    }
    std::size_t rows = 0;
    in >> rows;
    const PointTable table = read_points(entry.path());
    EXPECT_EQ(table.rows, rows);
    const Cloud cloud = to_cloud(table, entry.path().string());
    EXPECT_EQ(cloud.size(), rows);
    EXPECT_EQ(cloud.invalid, 0U);
    EXPECT_EQ(cloud.origin, Eigen::Vector3d::Zero());
    EXPECT_EQ(cloud.position(rows - 1).y(), table.value(*table.find("y"), rows - 1));
    ++read;
  }
  EXPECT_GT(read, 0);
}

std::string error_of_writing(const std::filesystem::path& path, const PointTable& table) {
  try {
    write_points(path, table);
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST_F(WritePoints, NeedsAKnownExtensionAndUsableNames) {
  PointTable table = table_of_every_type(ScalarType::f32, false);
  EXPECT_NE(error_of_writing(path("out.las"), table).find("must end in .ply, .pcd or .csv"), std::string::npos);
  table.columns[4].name = "two words";
  EXPECT_NE(error_of_writing(path("out.ply"), table).find("'two words' cannot name a column"), std::string::npos);
  table.columns[4].name = "x";
  EXPECT_NE(error_of_writing(path("out.ply"), table).find("two columns are named 'x'"), std::string::npos);
  EXPECT_NE(error_of_writing(path("out.ply"), PointTable{}).find("at least one column"), std::string::npos);
  EXPECT_EQ(files_in_folder(), 0U);
}

TEST_F(WritePoints, ReplacesAFileWholeAndKeepsItsModeAndLinks) {
  const PointTable table = table_of_every_type(ScalarType::f32, false);
  put("real.ply", "old");
  std::filesystem::permissions(path("real.ply"),
                               std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
  std::filesystem::create_symlink("real.ply", path("link.ply"));
  write_points(path("link.ply"), table);
  EXPECT_TRUE(std::filesystem::is_symlink(path("link.ply")));
  expect_same(table, read_points(path("real.ply")));
  EXPECT_EQ(std::filesystem::status(path("real.ply")).permissions(),
            std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
  EXPECT_EQ(files_in_folder(), 2U);
}

TEST_F(WritePoints, AFullDiskIsAnError) {
  std::filesystem::create_symlink("/dev/full", path("full.ply"));
  const std::string error = error_of_writing(path("full.ply"), table_of_every_type(ScalarType::f32, false));
  EXPECT_NE(error.find("No space left on device"), std::string::npos) << error;
}

TEST_F(WritePoints, AWriteThatFailsHalfwayLeavesTheOldFile) {
  PointTable table;
  table.rows = 100000;
  table.set_column("x", std::vector<float>(table.rows, 1.0F));
  put("out.ply", "old");
  rlimit before{}, small{};
  ::getrlimit(RLIMIT_FSIZE, &before);
  small = before;
  small.rlim_cur = 100000;  // bytes a file of this process may have: a disk that is full in the middle
  auto* const handler = std::signal(SIGXFSZ, SIG_IGN);
  ::setrlimit(RLIMIT_FSIZE, &small);
  const std::string error = error_of_writing(path("out.ply"), table);
  ::setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_NE(error.find("cannot be written"), std::string::npos) << error;
  EXPECT_EQ(get("out.ply"), "old");
  EXPECT_EQ(files_in_folder(), 1U);
}

TEST_F(WritePoints, SaysWhyAFolderTakesNoFile) {
  const PointTable table = table_of_every_type(ScalarType::f32, false);
  EXPECT_EQ(without_folder(error_of_writing(path("absent/out.ply"), table)),
            "absent/out.ply cannot be written: No such file or directory");
  std::filesystem::create_directory(path("folder.ply"));
  EXPECT_EQ(without_folder(error_of_writing(path("folder.ply"), table)),
            "folder.ply is a folder, not a file to write to");
}

}  // namespace
}  // namespace scenelore::perception
