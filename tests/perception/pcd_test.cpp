#include <lzf.h>

#include <cmath>

#include "point_file_support.hpp"

namespace scenelore::perception {
namespace {

using Pcd = PointFiles;

/// Three points with a normal of three values, padding, and a colour packed into a float, as the Point Cloud Library
/// writes them.
std::string header(const std::string& data, const std::string& points = "3",
                   const std::string& viewpoint = "0 0 0 1 0 0 0") {
  return "# .PCD v0.7 - Point Cloud Data file format\n# made in a test\nVERSION 0.7\nFIELDS x y z _ normal rgb "
         "label\nSIZE 4 4 8 1 4 4 2\n"
         "TYPE F F F U F F U\nCOUNT 1 1 1 4 3 1 1\nWIDTH " +
         points + "\nHEIGHT 1\nVIEWPOINT " + viewpoint + "\nPOINTS " + points + "\nDATA " + data + "\n";
}

constexpr std::uint32_t kColour = 0xff8040;  // as a float: not a number that survives arithmetic
constexpr std::size_t kRow = 4 + 4 + 8 + 4 + 12 + 4 + 2;

std::string row(int i) {
  const auto f = static_cast<float>(i);
  return raw(f) + raw(f + 0.5F) + raw(0.1 * i) + "____" + raw(0.0F) + raw(f) + raw(1.0F) +
         raw(kColour + static_cast<std::uint32_t>(i)) + raw(static_cast<std::uint16_t>(60000 + i));
}

std::string rows() { return row(0) + row(1) + row(2); }

std::string compressed(const std::string& by_field) {
  std::string packed(by_field.size() * 2 + 64, '\0');
  const unsigned size = lzf_compress(by_field.data(), static_cast<unsigned>(by_field.size()), packed.data(),
                                     static_cast<unsigned>(packed.size()));
  EXPECT_GT(size, 0U);
  packed.resize(size);
  return raw(size) + raw(static_cast<std::uint32_t>(by_field.size())) + packed;
}

/// The same rows, field after field.
std::string by_field(bool with_padding) {
  const std::size_t sizes[] = {4, 4, 8, 4, 12, 4, 2};
  std::string out;
  std::size_t offset = 0;
  for (std::size_t field = 0; field < 7; offset += sizes[field++]) {
    if (field == 3 && !with_padding) continue;
    for (std::size_t i = 0; i < 3; ++i) out += rows().substr(i * kRow + offset, sizes[field]);
  }
  return out;
}

void expect_the_three_points(const PointTable& table) {
  ASSERT_EQ(table.rows, 3U);
  std::vector<std::string> names;
  for (const Column& column : table.columns) names.push_back(column.name);
  EXPECT_EQ(names, (std::vector<std::string>{"x", "y", "z", "normal_0", "normal_1", "normal_2", "rgb", "label"}));
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(table.value(*table.find("x"), i), static_cast<double>(i));
    EXPECT_EQ(table.value(*table.find("y"), i), static_cast<double>(i) + 0.5);
    EXPECT_EQ(table.value(*table.find("z"), i), 0.1 * static_cast<double>(i));
    EXPECT_EQ(table.value(*table.find("normal_1"), i), static_cast<double>(i));
    EXPECT_EQ(table.value(*table.find("normal_2"), i), 1.0);
    EXPECT_EQ(table.value(*table.find("label"), i), 60000.0 + static_cast<double>(i));
    std::uint32_t colour = 0;
    std::memcpy(&colour, table.bytes.data() + i * table.stride + table.find("rgb")->offset, 4);
    EXPECT_EQ(colour, kColour + i) << "the bits of a packed colour are kept";
  }
  EXPECT_EQ(table.comments, (std::vector<std::string>{"made in a test"}));
}

TEST_F(Pcd, ReadsBinary) { expect_the_three_points(read("a.pcd", header("binary") + rows())); }

TEST_F(Pcd, ReadsCompressedWithAndWithoutPadding) {
  expect_the_three_points(read("a.pcd", header("binary_compressed") + compressed(by_field(true))));
  expect_the_three_points(read("a.pcd", header("binary_compressed") + compressed(by_field(false))));
}

TEST_F(Pcd, ReadsAscii) {
  // The colour's float in decimal: digits enough to give the same bits again.
  char text[3][40];
  for (std::uint32_t i = 0; i < 3; ++i) {
    float colour = 0;
    const std::uint32_t bits = kColour + i;
    std::memcpy(&colour, &bits, 4);
    std::snprintf(text[i], sizeof text[i], "%.9g", static_cast<double>(colour));
  }
  const std::string body = "0 0.5 0 9 9 9 9 0 0 1 " + std::string(text[0]) + " 60000\r\n\n1 1.5 0.1 9 9 9 9 0 1 1 " +
                           text[1] + " 60001\n2 2.5 0.2 9 9 9 9 0 2 1 " + text[2] + " 60002";
  expect_the_three_points(read("a.pcd", header("ascii") + body));
}

TEST_F(Pcd, ReadsNanAsNan) {
  const PointTable table =
      read("a.pcd", "VERSION .5\nCOLUMNS x y z\nSIZE 4 4 4\nTYPE F F F\nPOINTS 1\nDATA ascii\nnan NaN -nan\n");
  for (const Column& column : table.columns) EXPECT_TRUE(std::isnan(table.value(column, 0)));
}

TEST_F(Pcd, TakesTheViewpointUnlessItIsTheDefault) {
  EXPECT_FALSE(read("a.pcd", header("binary") + rows()).viewpoint);
  EXPECT_EQ(read("a.pcd", header("binary", "3", "1 -2.5 0.25 0 1 0 0") + rows()).viewpoint,
            Eigen::Vector3d(1, -2.5, 0.25));
}

TEST_F(Pcd, WritesAndReadsBackEveryTypeBitExactly) {
  for (const ScalarType coordinates : {ScalarType::f32, ScalarType::f64}) {
    const PointTable table = table_of_every_type(coordinates, true);
    write_points(path("out.pcd"), table);
    const PointTable back = read_points(path("out.pcd"));
    expect_same(table, back);
    EXPECT_EQ(back.comments, table.comments);
  }
}

TEST_F(Pcd, EveryPrefixOfAFileIsAnErrorOrTheWholeScene) {
  for (const std::string& whole :
       {header("binary") + rows(), header("binary_compressed") + compressed(by_field(true)),
        header("ascii") + "0 0 0 9 9 9 9 0 0 1 0 1\n0 0 0 9 9 9 9 0 0 1 0 2\n0 0 0 9 9 9 9 0 0 1 0 3\n"}) {
    const PointTable table = read("whole.pcd", whole);
    for (std::size_t size = 0; size < whole.size(); ++size) {
      const std::string error = error_of("part.pcd", whole.substr(0, size));
      if (error != "no error") continue;
      EXPECT_EQ(size, whole.size() - 1) << "only the last line's end may be missing";
      expect_same(table, read("part.pcd", whole.substr(0, size)));
    }
  }
}

TEST_F(Pcd, SaysHowManyPointsOfACutFileAreThere) {
  const std::string cut = header("binary") + row(0) + row(1) + "abc";
  EXPECT_EQ(
      error_of("cut.pcd", cut),
      "cut.pcd: the file is cut off: 2 of the 3 points that the header promises are there; the file ends at byte " +
          std::to_string(cut.size()));
}

TEST_F(Pcd, CountsThatLieAreRefusedWithoutAllocating) {
  for (const char* points : {"1000000000000", "99999999999999999"}) {
    EXPECT_NE(error_of("lie.pcd", header("binary", points) + rows()).find("cut off"), std::string::npos);
    EXPECT_NE(error_of("lie.pcd", header("ascii", points) + "0 0 0 9 9 9 9 0 0 1 0 1\n").find("cut off"),
              std::string::npos);
    EXPECT_NE(error_of("lie.pcd", header("binary_compressed", points) + compressed(by_field(true)))
                  .find("the header promises"),
              std::string::npos);
  }
  EXPECT_NE(error_of("lie.pcd", header("binary", "-3") + rows()).find("'-3' is no WIDTH"), std::string::npos);
  const std::string many =
      "VERSION .7\nFIELDS x\nSIZE 4\nTYPE F\nCOUNT 1000000000000\nWIDTH 1\nHEIGHT 1\nPOINTS 1\nDATA binary\n";
  EXPECT_NE(error_of("lie.pcd", many).find("more than 4096 values a point"), std::string::npos);
  const std::string bomb =
      "VERSION .7\nFIELDS x\nSIZE 4\nTYPE F\nCOUNT 1\nWIDTH 1000000000\nHEIGHT 1\nPOINTS 1000000000\nDATA "
      "binary_compressed\n";
  EXPECT_NE(error_of("lie.pcd", bomb + raw(std::uint32_t{3}) + raw(std::uint32_t{4000000000U}) + "abc").find("damaged"),
            std::string::npos);
}

TEST_F(Pcd, HeadersThatContradictThemselvesAreErrors) {
  const auto error = [&](const std::string& text) { return error_of("h.pcd", "VERSION .7\n" + text); };
  EXPECT_NE(error("FIELDS x y\nSIZE 4\nTYPE F F\nWIDTH 1\nDATA ascii\n").find("SIZE has 1 entries for 2 fields"),
            std::string::npos);
  EXPECT_NE(error("FIELDS x\nSIZE 3\nTYPE F\nWIDTH 1\nDATA ascii\n").find("there is no type F of 3 bytes"),
            std::string::npos);
  EXPECT_NE(error("FIELDS x\nSIZE 4\nTYPE F\nWIDTH 2\nHEIGHT 3\nPOINTS 5\nDATA ascii\n")
                .find("WIDTH 2 times HEIGHT 3 is not POINTS 5"),
            std::string::npos);
  EXPECT_NE(
      error("FIELDS x\nSIZE 4\nTYPE F\nWIDTH 999999999999\nHEIGHT 999999999999\nDATA ascii\n").find("is not POINTS"),
      std::string::npos);
  EXPECT_NE(error("FIELDS x x\nSIZE 4 4\nTYPE F F\nWIDTH 1\nDATA ascii\n").find("'x' appears twice"),
            std::string::npos);
  EXPECT_NE(error("FIELDS x\nSIZE 4\nTYPE F\nWIDTH 1\nWIDTH 1\nDATA ascii\n").find("a second line 'WIDTH'"),
            std::string::npos);
  EXPECT_NE(error("FIELDS x\nSIZE 4\nTYPE F\nDATA ascii\n").find("neither WIDTH nor POINTS"), std::string::npos);
  EXPECT_NE(error("FIELDS x\nSIZE 4\nTYPE F\nWIDTH 1\nDATA zipped\n").find("unknown DATA 'zipped'"), std::string::npos);
  EXPECT_NE(error("FIELDS x\nSIZE 4\nTYPE F\nWIDTH 1\n").find("no line 'DATA'"), std::string::npos);
  EXPECT_NE(error_of("h.pcd", "nonsense\n").find("unknown keyword 'nonsense'"), std::string::npos);
}

TEST_F(Pcd, TextInANumberIsNamedWithLineAndField) {
  EXPECT_EQ(error_of("t.pcd", "VERSION .7\nFIELDS x y\nSIZE 4 4\nTYPE F F\nWIDTH 2\nDATA ascii\n1 2\n3 four\n"),
            "t.pcd, line 8: 'four' is no value of field 'y'");
}

TEST_F(Pcd, PaddingZerosMayFollowOtherDataNot) {
  EXPECT_EQ(error_of("a.pcd", header("binary") + rows() + std::string(100, '\0')), "no error");
  EXPECT_NE(error_of("a.pcd", header("binary") + rows() + "x").find("1 bytes follow"), std::string::npos);
}

}  // namespace
}  // namespace scenelore::perception
