#include "text_columns.hpp"

#include <algorithm>
#include <cctype>

#include "bytes.hpp"
#include "lines.hpp"

namespace scenelore::perception {
namespace {

std::string_view unquoted(std::string_view field) {
  field = trimmed(field);
  if (field.size() >= 2 && field.front() == '"' && field.back() == '"')
    field = trimmed(field.substr(1, field.size() - 2));
  return field;
}

std::string lower(std::string_view text) {
  std::string out(text);
  std::transform(out.begin(), out.end(), out.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return out;
}

bool is_coordinate(std::string_view name) { return name == "x" || name == "y" || name == "z"; }

bool is_colour(std::string_view name) { return name == "red" || name == "green" || name == "blue" || name == "alpha"; }

ScalarType type_for(std::string_view name, const TextColumn& column) {
  if (is_coordinate(name)) return ScalarType::f64;
  if (is_colour(name) && column.is_byte) return ScalarType::u8;
  return column.whole ? ScalarType::i32 : ScalarType::f64;
}

}  // namespace

char separator_of(std::string_view line) {
  if (line.find(';') != std::string_view::npos) return ';';
  return line.find(',') != std::string_view::npos ? ',' : ' ';
}

std::string_view take_field(std::string_view& line, char separator) {
  if (separator == ' ') {
    const std::string_view word = take_word(line);
    if (trimmed(line).empty()) line = {};
    return unquoted(word);
  }
  const std::size_t end = line.find(separator);
  const std::string_view field = line.substr(0, end);
  line = end == std::string_view::npos ? std::string_view{} : line.substr(end + 1);
  return unquoted(field);
}

std::vector<std::string_view> split(std::string_view line, char separator) {
  std::vector<std::string_view> fields{take_field(line, separator)};
  while (line.data() != nullptr) fields.push_back(take_field(line, separator));
  return fields;
}

bool names_coordinates(const std::vector<std::string_view>& names) {
  const auto has = [&](char axis) {
    return std::any_of(names.begin(), names.end(),
                       [&](std::string_view name) { return name.size() == 1 && std::tolower(name[0]) == axis; });
  };
  return has('x') && has('y') && has('z');
}

std::vector<std::string> column_names(const std::vector<std::string_view>& tokens) {
  const auto has = [&](std::string_view name) {
    return std::any_of(tokens.begin(), tokens.end(), [&](std::string_view token) { return lower(token) == name; });
  };
  const bool colour = has("r") && has("g") && has("b");
  std::vector<std::string> names;
  for (const std::string_view token : tokens) {
    std::string name = lower(token);
    if (colour && name == "r")
      name = "red";
    else if (colour && name == "g")
      name = "green";
    else if (colour && name == "b")
      name = "blue";
    else if (name == "i")
      name = "intensity";
    else if (!is_coordinate(name))
      name = token;
    std::replace_if(
        name.begin(), name.end(), [](unsigned char c) { return std::isspace(c) || c == ','; }, '_');
    names.push_back(name.empty() ? "scalar_" + std::to_string(names.size()) : name);
  }
  return names;
}

void TextColumn::take(std::string_view token, double value) {
  if (!whole) return;
  whole = token.find_first_not_of("+-0123456789") == std::string_view::npos && value >= -2147483648.0 &&
          value <= 2147483647.0;
  is_byte = is_byte && whole && value >= 0 && value <= 255;
}

std::vector<std::string> default_names(const std::vector<TextColumn>& columns) {
  std::vector<std::string> names{"x", "y", "z"};
  const auto colour_at = [&](std::size_t first) {
    return columns.size() >= first + 3 && columns[first].is_byte && columns[first + 1].is_byte &&
           columns[first + 2].is_byte;
  };
  if (columns.size() == 4) return {"x", "y", "z", "intensity"};
  const bool intensity_first = columns.size() == 7 && colour_at(4);  // x y z i r g b, as PTS files have it
  if (intensity_first) names.push_back("intensity");
  if (colour_at(names.size())) names.insert(names.end(), {"red", "green", "blue"});
  while (names.size() < columns.size()) names.push_back("scalar_" + std::to_string(names.size()));
  return names;
}

void narrow(PointTable& table, const std::vector<std::string>& names, const std::vector<TextColumn>& columns) {
  for (std::size_t i = 0; i < names.size(); ++i) add_column(table, names[i], type_for(names[i], columns[i]));
  std::vector<double> row(names.size());
  for (std::size_t r = 0; r < table.rows; ++r) {  // the narrower row never begins behind the wide one it comes from
    std::memcpy(row.data(), table.bytes.data() + r * row.size() * sizeof(double), row.size() * sizeof(double));
    std::byte* const to = table.bytes.data() + r * table.stride;
    for (std::size_t i = 0; i < row.size(); ++i) {
      with_type(table.columns[i].type,
                [&](auto zero) { store(to + table.columns[i].offset, static_cast<decltype(zero)>(row[i])); });
    }
  }
  table.bytes.resize(table.rows * table.stride);
}

}  // namespace scenelore::perception
