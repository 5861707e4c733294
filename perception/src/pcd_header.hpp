// The header of a PCD file (versions 0.5 to 0.7), as the Point Cloud Library defines it.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scenelore/perception/point_table.hpp"

namespace scenelore::perception {

enum class PcdEncoding { ascii, binary, binary_compressed };

struct PcdField {
  std::string name;
  ScalarType type = ScalarType::f32;
  std::size_t count = 1;  ///< values of the type in a row

  [[nodiscard]] bool padding() const { return name == "_"; }
  [[nodiscard]] std::size_t size() const { return count * size_of(type); }  ///< bytes in a binary row
};

struct PcdHeader {
  PcdEncoding encoding = PcdEncoding::ascii;
  std::vector<PcdField> fields;
  std::size_t points = 0;
  std::vector<std::string> comments;
  /// The translation of VIEWPOINT; nothing for 0 0 0, which PCD writers put there when they know nothing. Its rotation
  /// does not move the points and is not kept.
  std::optional<Eigen::Vector3d> viewpoint;
  std::size_t body = 0;   ///< byte at which the data begin
  std::size_t lines = 0;  ///< lines of the header
};

/// Throws Error, with line number, for anything that is no PCD header.
[[nodiscard]] PcdHeader parse_pcd_header(std::string_view text, const std::string& file_name);

}  // namespace scenelore::perception
