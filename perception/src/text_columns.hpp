// Columns of a text file: how a line splits, what the columns are called, and which types their values fit.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scenelore/perception/point_table.hpp"

namespace scenelore::perception {

/// Semicolon before comma before blanks: the first of them that the line holds. ' ' stands for any run of blanks.
[[nodiscard]] char separator_of(std::string_view line);

/// Takes the next field, without blanks and quotes, from the front of `line`, which becomes a null view behind the last
/// one.
[[nodiscard]] std::string_view take_field(std::string_view& line, char separator);

/// All fields of the line; one empty field for an empty line.
[[nodiscard]] std::vector<std::string_view> split(std::string_view line, char separator);

/// Whether x, y and z are among the names, in either case.
[[nodiscard]] bool names_coordinates(const std::vector<std::string_view>& names);

/// Names as other formats have them: x y z, red green blue for r g b, intensity for i; blanks become '_'.
[[nodiscard]] std::vector<std::string> column_names(const std::vector<std::string_view>& tokens);

/// What the values of one column have in common, gathered while reading.
struct TextColumn {
  bool whole = true;    ///< written without point or exponent, and fits 32 bits
  bool is_byte = true;  ///< in addition within 0..255

  void take(std::string_view token, double value);
};

/// Names for a file without a header: x y z; a single fourth column is the intensity; three columns of whole numbers of
/// 0..255 behind that are the colour; the others are scalar_3, scalar_4, … after their place.
[[nodiscard]] std::vector<std::string> default_names(const std::vector<TextColumn>& columns);

/// Turns rows of doubles into the table's columns, in place: x y z stay double, colours of 0..255 become uchar, whole
/// numbers int, everything else double.
void narrow(PointTable& table, const std::vector<std::string>& names, const std::vector<TextColumn>& columns);

}  // namespace scenelore::perception
