#include "point_file_support.hpp"
#include "scenelore/perception/cloud.hpp"

namespace scenelore::perception {
namespace {

using TextPoints = PointFiles;

std::vector<std::string> names(const PointTable& table) {
  std::vector<std::string> all;
  for (const Column& column : table.columns) all.push_back(column.name);
  return all;
}

using Names = std::vector<std::string>;

TEST_F(TextPoints, ReadsEverySeparator) {
  for (const char* content : {"1.5 2 3\n4 5 -6e-1\n", "1.5\t2\t3\r\n4\t5\t-0.6", "1.5,2,3\n4, 5, -.6\n",
                              "1.5;2;3\n4 ; 5 ;-0.60\n", "  1.5   2 3 \n\n4 5 -0.6\n\n"}) {
    for (const char* name : {"a.xyz", "a.txt", "a.csv", "a.asc", "a.unknown", "noextension"}) {
      const PointTable table = read(name, content);
      ASSERT_EQ(table.rows, 2U) << content;
      EXPECT_EQ(names(table), (Names{"x", "y", "z"}));
      EXPECT_EQ(table.value(table.columns[0], 0), 1.5);
      EXPECT_EQ(table.value(table.columns[2], 1), -0.6);
    }
  }
}

TEST_F(TextPoints, KeepsCoordinatesInDoublePrecision) {
  const PointTable table = read("utm.xyz", "4500000.1234 5400000.5678 312.25\n4500001.1234 5400000.5678 312.25\n");
  EXPECT_EQ(table.columns[0].type, ScalarType::f64);
  EXPECT_EQ(table.value(table.columns[0], 0), 4500000.1234);
  const Cloud cloud = to_cloud(table, "utm.xyz");
  EXPECT_NEAR(cloud.position(1).x(), 4500001.1234, 1e-6);
  EXPECT_NEAR(cloud.position(1).y(), 5400000.5678, 1e-6);
}

TEST_F(TextPoints, TakesNamesFromHeadersOfAllKinds) {
  for (const char* header :
       {"x y z intensity\n", "X,Y,Z,I\n", "# x y z intensity\n", "//X Y Z i\n", "\"x\";\"y\";\"z\";\"intensity\"\n",
        "\xef\xbb\xbfx;y;z;intensity\n", "# written by a scanner\n\n#x,y,z,intensity\n"}) {
    const PointTable table = read("a.csv", header + std::string("1 2 3 0.5\n"));
    EXPECT_EQ(names(table), (Names{"x", "y", "z", "intensity"})) << header;
    EXPECT_EQ(table.value(table.columns[3], 0), 0.5);
  }
  EXPECT_EQ(names(read("a.txt", "//X Y Z R G B\n1 2 3 4 5 6\n")), (Names{"x", "y", "z", "red", "green", "blue"}));
  EXPECT_EQ(names(read("a.txt", "x y z b\n1 2 3 4\n")), (Names{"x", "y", "z", "b"})) << "b alone is no blue";
  const PointTable swapped = read("a.csv", "label,z,y,x,Scalar field\n7,3,2,1,0.25\n");
  EXPECT_EQ(names(swapped), (Names{"label", "z", "y", "x", "Scalar_field"}));
  EXPECT_EQ(swapped.find("label")->type, ScalarType::i32);
  EXPECT_EQ(to_cloud(swapped, "a").x[0], 1.0F);
}

TEST_F(TextPoints, NamesColumnsWithoutAHeaderByWhatTheyHold) {
  EXPECT_EQ(names(read("a.xyz", "1 2 3 0.5\n")), (Names{"x", "y", "z", "intensity"}));
  EXPECT_EQ(names(read("a.xyz", "1 2 3 255 0 128\n")), (Names{"x", "y", "z", "red", "green", "blue"}));
  EXPECT_EQ(names(read("a.xyz", "1 2 3 0.1 0.2 0.9\n")), (Names{"x", "y", "z", "scalar_3", "scalar_4", "scalar_5"}));
  EXPECT_EQ(names(read("a.pts", "1 2 3 -900 255 0 128\n")),
            (Names{"x", "y", "z", "intensity", "red", "green", "blue"}));
  EXPECT_EQ(names(read("a.xyz", "1 2 3 255 0 128 0.5\n")), (Names{"x", "y", "z", "red", "green", "blue", "scalar_6"}));
}

TEST_F(TextPoints, ChoosesTheNarrowestTypeThatLosesNothing) {
  const PointTable table = read(
      "a.csv", "x,y,z,red,green,blue,label,big,weight\n1,2,3,255,0,7,-5,3000000000,0.1\n4,5,6,0,255,8,70000,1,0.2\n");
  const auto type = [&](const char* name) { return table.find(name)->type; };
  EXPECT_EQ(type("red"), ScalarType::u8);
  EXPECT_EQ(type("label"), ScalarType::i32);
  EXPECT_EQ(type("big"), ScalarType::f64);
  EXPECT_EQ(type("weight"), ScalarType::f64);
  EXPECT_EQ(table.value(*table.find("label"), 1), 70000.0);
  EXPECT_EQ(table.value(*table.find("big"), 0), 3000000000.0);
  EXPECT_EQ(table.value(*table.find("blue"), 1), 8.0);
  EXPECT_EQ(table.value(*table.find("weight"), 1), 0.2);
}

TEST_F(TextPoints, HoldsALeadingCountToItsWord) {
  EXPECT_EQ(read("a.pts", "2\n1 2 3\n4 5 6\n").rows, 2U);
  EXPECT_EQ(error_of("a.pts", "3\n1 2 3\n4 5 6\n"), "a.pts: the first line promises 3 points, the file holds 2");
}

TEST_F(TextPoints, ErrorsNameLineAndColumn) {
  EXPECT_EQ(error_of("a.xyz", "1 2 3\n4 5\n"), "a.xyz, line 2: no value for column 3");
  EXPECT_EQ(error_of("a.xyz", "1 2 3\n4 5 6 7\n"), "a.xyz, line 2: more than 3 values");
  EXPECT_EQ(error_of("a.csv", "x,y,z\n1,2,3\n4,,6\n"),
            "a.csv, line 3: no value for column 2 ('y') (write nan where there is none)");
  EXPECT_EQ(error_of("a.csv", "x,y,z\n1,2,3\n4,five,6\n"), "a.csv, line 3: 'five' is no number, column 2 ('y')");
  EXPECT_EQ(error_of("a.csv", "1,5;2,5;3,5\n"),
            "a.csv, line 1: '1,5' is no number, and the line does not name columns x, y and z");
  EXPECT_EQ(error_of("a.txt", "Dear reader, this is a letter.\n"),
            "a.txt, line 1: 'Dear reader' is no number, and the line does not name columns x, y and z");
  EXPECT_EQ(error_of("a.csv", "x,y,z\n1,2,3,4\n"), "a.csv, line 2: 4 values, but 3 columns are named above");
  EXPECT_EQ(error_of("a.csv", "x,y,z,x\n1,2,3,4\n"), "a.csv: two columns are named 'x'");
  EXPECT_EQ(error_of("a.xyz", "1 2\n"), "a.xyz, line 1: a point needs three numbers at least, found 2");
  EXPECT_EQ(error_of("a.xyz", "# nothing here\n\n"), "a.xyz holds no points");
}

TEST_F(TextPoints, WritesCsvThatReadsBackEqual) {
  for (const ScalarType coordinates : {ScalarType::f32, ScalarType::f64}) {
    const PointTable table = table_of_every_type(coordinates, false);
    write_points(path("out.csv"), table);
    const PointTable back = read_points(path("out.csv"));
    ASSERT_EQ(back.rows, table.rows);
    ASSERT_EQ(names(back), names(table));
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
      const bool narrow = table.columns[i].type == ScalarType::f32;
      for (std::size_t row = 0; row < table.rows; ++row) {
        const double expected = table.value(table.columns[i], row), got = back.value(back.columns[i], row);
        const bool equal = narrow ? static_cast<float>(got) == static_cast<float>(expected) : got == expected;
        EXPECT_TRUE(equal || (std::isnan(expected) && std::isnan(got)))
            << table.columns[i].name << " " << row << ": " << got;
      }
    }
  }
}

TEST_F(TextPoints, WritesIntegersExactly) {
  PointTable table = table_of_every_type(ScalarType::f64, true);
  write_points(path("out.csv"), table);
  EXPECT_NE(get("out.csv").find(",-9223372036854775808,0\n"), std::string::npos);
  EXPECT_NE(get("out.csv").find(",9223372036854775807,18446744073709551615\n"), std::string::npos);
}

}  // namespace
}  // namespace scenelore::perception
