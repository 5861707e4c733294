// Point files made in the test: a folder that goes away, raw bytes in either order, and what reading them said.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <iterator>
#include <string>

#include "scenelore/perception/error.hpp"
#include "scenelore/perception/point_table.hpp"
#include "temporary_folder.hpp"

namespace scenelore::perception {

/// A folder of its own for each test; removed with it.
class PointFiles : public ::testing::Test {
 protected:
  [[nodiscard]] std::filesystem::path path(const std::string& name) const { return folder_ / name; }
  std::filesystem::path put(const std::string& name, const std::string& content) const {
    std::filesystem::remove(
        path(name));  // a new file is quick; one cut to nothing and rewritten is synchronised by ext4
    test::write_file(path(name), content);
    return path(name);
  }
  [[nodiscard]] std::string get(const std::string& name) const { return test::read_file(path(name)); }
  [[nodiscard]] PointTable read(const std::string& name, const std::string& content) const {
    return read_points(put(name, content));
  }

  /// The error message without the folder, or "no error".
  [[nodiscard]] std::string error_of(const std::string& name, const std::string& content) const {
    put(name, content);
    return error_of_reading(name);
  }
  [[nodiscard]] std::string error_of_reading(const std::string& name) const {
    try {
      (void)read_points(path(name));
    } catch (const Error& error) {
      return without_folder(error.what());
    }
    return "no error";
  }
  [[nodiscard]] std::string without_folder(std::string text) const {
    const std::string prefix = folder_.path().string() + "/";
    for (std::size_t at = text.find(prefix); at != std::string::npos; at = text.find(prefix))
      text.erase(at, prefix.size());
    return text;
  }
  [[nodiscard]] std::size_t files_in_folder() const {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder_.path()), {}));
  }

  test::TemporaryFolder folder_;
};

/// The bytes of a scalar; big-endian on demand.
template <class T>
std::string raw(T value, bool big_endian = false) {
  std::string bytes(sizeof value, '\0');
  std::memcpy(bytes.data(), &value, sizeof value);
  if (big_endian) std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

/// Same columns, same bytes in them, same viewpoint and comments.
inline void expect_same(const PointTable& a, const PointTable& b) {
  ASSERT_EQ(a.rows, b.rows);
  ASSERT_EQ(a.columns.size(), b.columns.size());
  for (std::size_t i = 0; i < a.columns.size(); ++i) {
    EXPECT_EQ(a.columns[i].name, b.columns[i].name);
    EXPECT_EQ(a.columns[i].type, b.columns[i].type) << a.columns[i].name;
    EXPECT_EQ(a.columns[i].offset, b.columns[i].offset) << a.columns[i].name;
  }
  EXPECT_EQ(a.stride, b.stride);
  EXPECT_TRUE(a.bytes == b.bytes);
  EXPECT_EQ(a.viewpoint.has_value(), b.viewpoint.has_value());
  if (a.viewpoint && b.viewpoint) {
    EXPECT_EQ(*a.viewpoint, *b.viewpoint);
  }
}

/// A table with one column of every type, x y z of type `coordinates`, and values at the ends of each range.
[[nodiscard]] PointTable table_of_every_type(ScalarType coordinates, bool with_64_bit_integers);

}  // namespace scenelore::perception
