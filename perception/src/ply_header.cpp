#include "ply_header.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "lines.hpp"
#include "numbers.hpp"
#include "scenelore/perception/error.hpp"

namespace scenelore::perception {
namespace {

// The first name of each type is the one of Turk's original description, which every reader knows.
constexpr std::array<std::pair<std::string_view, ScalarType>, 16> kTypeNames{{
    {"char", ScalarType::i8},
    {"int8", ScalarType::i8},
    {"uchar", ScalarType::u8},
    {"uint8", ScalarType::u8},
    {"short", ScalarType::i16},
    {"int16", ScalarType::i16},
    {"ushort", ScalarType::u16},
    {"uint16", ScalarType::u16},
    {"int", ScalarType::i32},
    {"int32", ScalarType::i32},
    {"uint", ScalarType::u32},
    {"uint32", ScalarType::u32},
    {"float", ScalarType::f32},
    {"float32", ScalarType::f32},
    {"double", ScalarType::f64},
    {"float64", ScalarType::f64},
}};

constexpr std::size_t kMaxProperties = 4096;  // far above any scanner's; keeps the search for doubles cheap

/// Reads one header, line by line.
class HeaderParser {
 public:
  HeaderParser(std::string_view text, const std::string& file_name) : lines_(text), file_(file_name) {}

  PlyHeader parse() {
    const auto magic = lines_.next();
    if (!magic || trimmed(*magic) != "ply") fail("a PLY file begins with a line 'ply'");
    while (const auto line = lines_.next()) {
      std::string_view rest = *line;
      const std::string_view keyword = take_word(rest);
      if (keyword == "end_header") return finish();
      take_line(keyword, rest, *line);
    }
    fail("the header has no line 'end_header': the file is cut off or is no PLY file");
  }

 private:
  void take_line(std::string_view keyword, std::string_view rest, std::string_view line) {
    if (keyword.empty()) return;
    if (keyword == "comment") return take_comment(rest);
    if (keyword == "obj_info") return header_.comments.emplace_back(trimmed(line)), void();
    if (keyword == "format") return take_format(rest);
    if (keyword == "element") return take_element(rest);
    if (keyword == "property") return take_property(rest);
    fail("unknown keyword '" + printable(keyword) + "' in the header");
  }

  void take_comment(std::string_view rest) {
    const auto parts = words(rest);
    if (parts.size() == 4 && parts[0] == "viewpoint") {
      const auto x = parse_double(parts[1]), y = parse_double(parts[2]), z = parse_double(parts[3]);
      if (x && y && z && std::isfinite(*x + *y + *z)) {
        header_.viewpoint = Eigen::Vector3d(*x, *y, *z);
        return;
      }
    }
    if (rest.starts_with(' ')) rest.remove_prefix(1);
    header_.comments.emplace_back(rest);
  }

  void take_format(std::string_view rest) {
    const std::string_view name = take_word(rest), version = take_word(rest);
    if (name == "ascii")
      header_.format = PlyFormat::ascii;
    else if (name == "binary_little_endian")
      header_.format = PlyFormat::binary_little_endian;
    else if (name == "binary_big_endian")
      header_.format = PlyFormat::binary_big_endian;
    else
      fail("unknown format '" + printable(name) + "' (known: ascii, binary_little_endian, binary_big_endian)");
    if (version != "1.0") fail("PLY version '" + printable(version) + "' (known: 1.0)");
    if (std::exchange(has_format_, true)) fail("a second line 'format'");
  }

  void take_element(std::string_view rest) {
    const std::string_view name = take_word(rest), number = take_word(rest);
    const auto count = parse_count(number);
    if (name.empty() || !count) {
      fail("an element needs a name and a number of rows, found '" + printable(name) + "' and '" + printable(number) +
           "'");
    }
    for (const PlyElement& element : header_.elements) {
      if (element.name == name) fail("element '" + printable(name) + "' appears twice");
    }
    header_.elements.push_back({std::string(name), *count, {}});
  }

  void take_property(std::string_view rest) {
    if (header_.elements.empty()) fail("a property before the first element");
    PlyProperty property;
    std::string_view type = take_word(rest);
    if (type == "list") {
      property.list_count = type_named(take_word(rest));
      if (*property.list_count == ScalarType::f32 || *property.list_count == ScalarType::f64) {
        fail("the length of a list must be of a whole type");
      }
      type = take_word(rest);
    }
    property.type = type_named(type);
    property.name = take_word(rest);
    if (property.name.empty()) fail("a property without a name");
    PlyElement& element = header_.elements.back();
    for (const PlyProperty& other : element.properties) {
      if (other.name == property.name)
        fail("property '" + printable(property.name) + "' appears twice in element '" + element.name + "'");
    }
    if (element.properties.size() == kMaxProperties)
      fail("more than " + std::to_string(kMaxProperties) + " properties in one element");
    element.properties.push_back(std::move(property));
  }

  ScalarType type_named(std::string_view name) const {
    for (const auto& [known, type] : kTypeNames) {
      if (known == name) return type;
    }
    fail("unknown property type '" + printable(name) + "'");
  }

  PlyHeader finish() {
    if (!lines_.terminated()) fail("the file ends within the line 'end_header'");
    if (!has_format_) fail("the header has no line 'format'");
    header_.body = lines_.position();
    header_.lines = lines_.number();
    return std::move(header_);
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw Error(file_ + ", line " + std::to_string(lines_.number()) + ": " + what);
  }

  Lines lines_;
  const std::string& file_;
  PlyHeader header_;
  bool has_format_ = false;
};

}  // namespace

bool PlyElement::has_list() const {
  return std::any_of(properties.begin(), properties.end(),
                     [](const PlyProperty& p) { return p.list_count.has_value(); });
}

std::size_t PlyElement::row_size() const {
  return std::accumulate(properties.begin(), properties.end(), std::size_t{0},
                         [](std::size_t sum, const PlyProperty& p) { return sum + size_of(p.type); });
}

PlyHeader parse_ply_header(std::string_view text, const std::string& file_name) {
  return HeaderParser(text, file_name).parse();
}

std::optional<std::string_view> ply_type_name(ScalarType type) {
  for (const auto& [name, known] : kTypeNames) {
    if (known == type) return name;
  }
  return std::nullopt;
}

}  // namespace scenelore::perception
