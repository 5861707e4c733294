#include "point_file_support.hpp"
#include "scenelore/perception/cloud.hpp"

namespace scenelore::perception {
namespace {

using Ply = PointFiles;

// The encodings under test write the same scene: two faces before, three points with every type, a camera behind.
struct Encoding {
  const char* name;
  bool binary, big_endian;
};
constexpr Encoding kEncodings[] = {
    {"ascii", false, false}, {"binary_little_endian", true, false}, {"binary_big_endian", true, true}};

template <class T>
std::string value(const Encoding& encoding, T number) {
  return encoding.binary ? raw(number, encoding.big_endian) : std::to_string(number) + " ";
}

std::string end_of_row(const Encoding& encoding) { return encoding.binary ? "" : "\n"; }

/// Property types by their old or by their new names; x y z are floats or doubles.
std::string scene(const Encoding& encoding, bool new_names, bool doubles, const std::string& line_end) {
  const char* const old_type[] = {"char", "uchar", "short", "ushort", "int", "uint", "float", "double"};
  const char* const new_type[] = {"int8", "uint8", "int16", "uint16", "int32", "uint32", "float32", "float64"};
  const auto type = [&](int i) { return std::string(new_names ? new_type[i] : old_type[i]); };
  std::string header = "ply\nformat " + std::string(encoding.name) + " 1.0\ncomment a scene\nobj_info made in a test\n";
  header += "comment viewpoint 1.5 -2 0.25\nelement face 2\nproperty list " + type(1) + " " + type(4) +
            " vertex_indices\nproperty " + type(2) + " flag\n";
  header += "element vertex 3\n";
  for (const char* axis : {"x", "y", "z"}) header += "property " + type(doubles ? 7 : 6) + " " + axis + "\n";
  for (int i = 0; i < 8; ++i) header += "property " + type(i) + " p" + std::to_string(i) + "\n";
  header += "element camera 1\nproperty float view_px\nproperty list uchar float k\nend_header\n";
  std::string body;
  for (int face = 0; face < 2; ++face) {
    const int corners = 3 + face;
    body += value(encoding, static_cast<std::uint8_t>(corners));
    for (int i = 0; i < corners; ++i) body += value(encoding, static_cast<std::int32_t>(i));
    body += value(encoding, static_cast<std::int16_t>(-face)) + end_of_row(encoding);
  }
  for (int row = 0; row < 3; ++row) {
    for (int axis = 0; axis < 3; ++axis) {
      const double coordinate = row + 0.25 * axis;
      body += doubles ? value(encoding, coordinate) : value(encoding, static_cast<float>(coordinate));
    }
    body += value(encoding, static_cast<std::int8_t>(-row)) + value(encoding, static_cast<std::uint8_t>(200 + row));
    body += value(encoding, static_cast<std::int16_t>(-300 - row)) +
            value(encoding, static_cast<std::uint16_t>(65000 + row));
    body += value(encoding, static_cast<std::int32_t>(-70000 - row)) +
            value(encoding, static_cast<std::uint32_t>(4000000000U + row));
    body += value(encoding, 0.5F * static_cast<float>(row)) + value(encoding, -0.125 * row) + end_of_row(encoding);
  }
  body += value(encoding, 9.0F) + value(encoding, static_cast<std::uint8_t>(1)) + value(encoding, 7.0F) +
          end_of_row(encoding);
  if (line_end != "\n") {
    for (std::size_t at = header.find('\n'); at != std::string::npos; at = header.find('\n', at + line_end.size()))
      header.replace(at, 1, line_end);
  }
  return header + body;
}

TEST_F(Ply, ReadsEveryTypeInEveryEncoding) {
  for (const Encoding& encoding : kEncodings) {
    for (const bool new_names : {false, true}) {
      for (const bool doubles : {false, true}) {
        for (const char* line_end : {"\n", "\r\n"}) {
          SCOPED_TRACE(std::string(encoding.name) + (new_names ? " new" : " old") + (doubles ? " double" : " float") +
                       line_end);
          const PointTable table = read("scene.ply", scene(encoding, new_names, doubles, line_end));
          ASSERT_EQ(table.rows, 3U);
          ASSERT_EQ(table.columns.size(), 11U);
          EXPECT_EQ(table.find("x")->type, doubles ? ScalarType::f64 : ScalarType::f32);
          const double expected[][8] = {{0, 200, -300, 65000, -70000, 4000000000.0, 0, 0},
                                        {-1, 201, -301, 65001, -70001, 4000000001.0, 0.5, -0.125},
                                        {-2, 202, -302, 65002, -70002, 4000000002.0, 1, -0.25}};
          for (std::size_t row = 0; row < 3; ++row) {
            for (std::size_t axis = 0; axis < 3; ++axis) {
              EXPECT_EQ(table.value(table.columns[axis], row),
                        static_cast<double>(row) + 0.25 * static_cast<double>(axis));
            }
            for (std::size_t i = 0; i < 8; ++i)
              EXPECT_EQ(table.value(table.columns[3 + i], row), expected[row][i]) << i;
          }
          EXPECT_EQ(table.comments, (std::vector<std::string>{"a scene", "obj_info made in a test"}));
          ASSERT_TRUE(table.viewpoint);
          EXPECT_EQ(*table.viewpoint, Eigen::Vector3d(1.5, -2, 0.25));
        }
      }
    }
  }
}

TEST_F(Ply, EveryPrefixOfAFileIsAnErrorOrTheWholeScene) {
  for (const Encoding& encoding : kEncodings) {
    SCOPED_TRACE(encoding.name);
    const std::string whole = scene(encoding, false, true, "\n");
    const PointTable table = read("whole.ply", whole);
    for (std::size_t size = 0; size < whole.size(); ++size) {
      const std::string error = error_of("part.ply", whole.substr(0, size));
      // An ascii file may miss the end of its last line, or the last digits of its last number.
      if (error == "no error") {
        EXPECT_FALSE(encoding.binary) << size;
        EXPECT_GT(size, whole.size() - 11) << size;
        expect_same(table, read("part.ply", whole.substr(0, size)));
      } else {
        EXPECT_EQ(error.find("part.ply"), 0U) << error;
      }
    }
  }
}

TEST_F(Ply, WritesAndReadsBackEveryTypeBitExactly) {
  for (const ScalarType coordinates : {ScalarType::f32, ScalarType::f64}) {
    const PointTable table = table_of_every_type(coordinates, false);
    write_points(path("out.ply"), table);
    const PointTable back = read_points(path("out.ply"));
    expect_same(table, back);
    EXPECT_EQ(back.comments, table.comments);
  }
}

TEST_F(Ply, KeepsObjInfoAndFlattensCommentsOfSeveralLines) {
  PointTable table = table_of_every_type(ScalarType::f32, false);
  table.comments = {"obj_info from a scanner", "one\nend_header\r"};
  write_points(path("out.ply"), table);
  const PointTable back = read_points(path("out.ply"));
  EXPECT_EQ(back.comments, (std::vector<std::string>{"obj_info from a scanner", "one end_header "}));
  EXPECT_TRUE(back.bytes == table.bytes);
}

TEST_F(Ply, Stores64BitIntegersAsDoublesWhereTheseHoldThem) {
  PointTable table;
  table.rows = 1;
  table.columns = {{"x", ScalarType::f32, 0}, {"id", ScalarType::i64, 4}};
  table.stride = 12;
  const std::string row = raw(1.0F) + raw(std::int64_t{-9007199254740991});
  table.bytes.resize(12);
  std::memcpy(table.bytes.data(), row.data(), 12);
  write_points(path("out.ply"), table);
  const PointTable back = read_points(path("out.ply"));
  EXPECT_EQ(back.find("id")->type, ScalarType::f64);
  EXPECT_EQ(back.value(*back.find("id"), 0), -9007199254740991.0);
  const std::string huge = raw(std::int64_t{9007199254740994});
  std::memcpy(table.bytes.data() + 4, huge.data(), 8);
  EXPECT_THROW(write_points(path("huge.ply"), table), Error);
  EXPECT_EQ(files_in_folder(), 1U) << "the failed file is gone";
}

TEST_F(Ply, TakesTheViewpointOfTheCameraElement) {
  const std::string header =
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n"
      "element camera 1\nproperty float view_px\nproperty float view_py\nproperty float view_pz\nend_header\n1 2 3\n";
  EXPECT_EQ(read("a.ply", header + "0 0.5 -1\n").viewpoint, Eigen::Vector3d(0, 0.5, -1));
  EXPECT_FALSE(read("b.ply", header + "0 0 0\n").viewpoint) << "which is what writers put who know nothing";
}

std::string head(const std::string& count = "2", const std::string& format = "binary_little_endian") {
  return "ply\nformat " + format + " 1.0\nelement vertex " + count +
         "\nproperty float x\nproperty float y\nproperty float z\nend_header\n";
}

TEST_F(Ply, SaysHowManyPointsOfACutFileAreThere) {
  EXPECT_EQ(error_of("cut.ply", head("3") + std::string(30, '\xff')),
            "cut.ply: the file is cut off: element 'vertex' has 2 of the 3 rows that the header promises; the file "
            "ends at byte " +
                std::to_string(head("3").size() + 30));
  EXPECT_EQ(error_of("cut.ply", head("3", "ascii") + "1 2 3\n4 5 6\n"),
            "cut.ply: the file is cut off: element 'vertex' has 2 of the 3 rows that the header promises; the file "
            "ends at byte " +
                std::to_string(head("3", "ascii").size() + 12));
}

TEST_F(Ply, CountsThatLieAreRefusedWithoutAllocating) {
  for (const char* count : {"99999999999999999", "4294967296", "1000000000"}) {
    for (const char* format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
      EXPECT_NE(error_of("lie.ply", head(count, format) + "1 2 3\n").find("cut off"), std::string::npos)
          << count << format;
    }
  }
  EXPECT_EQ(error_of("lie.ply", head("-5")),
            "lie.ply, line 3: an element needs a name and a number of rows, found 'vertex' and '-5'");
  EXPECT_NE(error_of("lie.ply", head("99999999999999999999999")).find("line 3"), std::string::npos);
  const std::string list =
      "ply\nformat binary_little_endian 1.0\nelement face 1000000000000\nproperty list int int i\nelement vertex 0\n"
      "property float x\nend_header\n";
  EXPECT_NE(error_of("lie.ply", list + raw(std::int32_t{-1})).find("negative length"), std::string::npos);
  EXPECT_NE(error_of("lie.ply", list + raw(std::int32_t{2147483647})).find("cut off"), std::string::npos);
}

TEST_F(Ply, TextInABinaryFileIsNamed) {
  const std::string error = error_of("text.ply", head("20") + "0.125 0.25 0.5\n0.125 0.25 0.5\n0.125 0.25 0.5\n");
  EXPECT_NE(error.find("its points look like text, but the header says binary"), std::string::npos) << error;
}

TEST_F(Ply, TextInANumberIsNamedWithLineAndProperty) {
  EXPECT_EQ(error_of("text.ply", head("2", "ascii") + "1 2 3\n4 five 6\n"),
            "text.ply, line 9: 'five' is no float, property 'y' of element 'vertex'");
  EXPECT_EQ(error_of("text.ply", head("2", "ascii") + "1 2 3\n4 5\n"),
            "text.ply, line 9: no value for property 'z' of element 'vertex'");
  EXPECT_EQ(error_of("text.ply", head("2", "ascii") + "1 2 3\n4 5 6 7\n"),
            "text.ply, line 9: '7' is one value too many: element 'vertex' has 3 properties");
  EXPECT_EQ(error_of("text.ply", head("1", "ascii") + "1e50 2 3\n"),
            "text.ply, line 8: '1e50' is no float, property 'x' of element 'vertex'");
}

TEST_F(Ply, WholeNumbersOutOfTheirTypesRangeAreErrors) {
  const auto with = [](const std::string& type, const std::string& number) {
    return "ply\nformat ascii 1.0\nelement vertex 1\nproperty " + type + " label\nend_header\n" + number + "\n";
  };
  for (const auto& [type, number] : {std::pair{"uchar", "256"},
                                     {"uchar", "-1"},
                                     {"char", "128"},
                                     {"ushort", "65536"},
                                     {"int", "2147483648"},
                                     {"uint", "-1"},
                                     {"int", "1.5"},
                                     {"int", "nan"},
                                     {"int", "1e300"},
                                     {"int", "0x10"},
                                     {"int", ""}}) {
    EXPECT_NE(error_of("label.ply", with(type, number)), "no error") << type << number;
  }
  for (const auto& [type, number, value] : {std::tuple{"uchar", "255", 255.0},
                                            {"char", "-128", -128.0},
                                            {"int", "+7", 7.0},
                                            {"int", "12.0", 12.0},
                                            {"float", "-inf", -HUGE_VAL},
                                            {"float", "1e-60", 0.0},
                                            {"float", "+.5", 0.5},
                                            {"double", "1e-400", 0.0}}) {
    const PointTable table = read("label.ply", with(type, number));
    EXPECT_EQ(table.value(table.columns[0], 0), value) << type << number;
  }
}

TEST_F(Ply, MoreDataThanTheHeaderDescribesIsAnError) {
  EXPECT_NE(error_of("more.ply", head("1") + std::string(13, '\x01')).find("1 bytes follow"), std::string::npos);
  EXPECT_NE(error_of("more.ply", head("1", "ascii") + "1 2 3\n4 5 6\n").find("line 9"), std::string::npos);
  EXPECT_EQ(error_of("more.ply", head("1") + std::string(12, '\x01') + "\n"), "no error");
}

TEST_F(Ply, ListsAtThePointsAndMissingPointsAreErrors) {
  EXPECT_NE(
      error_of(
          "list.ply",
          "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty list uchar int near\nend_header\n1 0\n")
          .find("property 'near' of the points is a list"),
      std::string::npos);
  EXPECT_EQ(error_of("none.ply", "ply\nformat ascii 1.0\nelement point 1\nproperty float x\nend_header\n1\n"),
            "none.ply: no element 'vertex', so no points (elements: point)");
}

TEST_F(Ply, HeadersThatAreWrongAreNamedByLine) {
  const auto error = [&](const std::string& lines) { return error_of("h.ply", "ply\n" + lines); };
  EXPECT_NE(
      error("format binary_middle_endian 1.0\nend_header\n").find("line 2: unknown format 'binary_middle_endian'"),
      std::string::npos);
  EXPECT_NE(error("format ascii 2.0\nend_header\n").find("PLY version '2.0'"), std::string::npos);
  EXPECT_NE(error("element vertex 1\nend_header\n").find("no line 'format'"), std::string::npos);
  EXPECT_NE(error("format ascii 1.0\nproperty float x\n").find("before the first element"), std::string::npos);
  EXPECT_NE(error("format ascii 1.0\nelement vertex 1\nproperty half x\n").find("unknown property type 'half'"),
            std::string::npos);
  EXPECT_NE(error("format ascii 1.0\nelement vertex 1\nproperty float x\nproperty int x\n").find("appears twice"),
            std::string::npos);
  EXPECT_NE(error("format ascii 1.0\nelement vertex 1\nproperty list float int x\n").find("whole type"),
            std::string::npos);
  EXPECT_NE(error("format ascii 1.0\nelement vertex 1\nproperty float x\n").find("no line 'end_header'"),
            std::string::npos);
  EXPECT_NE(error("nonsense\n").find("unknown keyword 'nonsense'"), std::string::npos);
  EXPECT_NE(error_of("h.ply", "solid cube\n").find("begins with a line 'ply'"), std::string::npos);
}

TEST_F(Ply, AFileWithoutPointsReadsAsNoRows) {
  const PointTable table = read("empty.ply", head("0"));
  EXPECT_EQ(table.rows, 0U);
  EXPECT_EQ(table.columns.size(), 3U);
  EXPECT_THROW((void)to_cloud(table, "empty.ply"), Error);
}

}  // namespace
}  // namespace scenelore::perception
