#include "pcd_header.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "lines.hpp"
#include "numbers.hpp"
#include "scenelore/perception/error.hpp"

namespace scenelore::perception {
namespace {

constexpr std::size_t kMaxColumns = 4096;  // far above any point type; a lying COUNT must not become a million names

std::optional<ScalarType> scalar_type(std::string_view letter, std::size_t size) {
  if (letter == "F" && size == 4) return ScalarType::f32;
  if (letter == "F" && size == 8) return ScalarType::f64;
  if (letter != "I" && letter != "U") return std::nullopt;
  const bool is_signed = letter == "I";
  switch (size) {
    case 1:
      return is_signed ? ScalarType::i8 : ScalarType::u8;
    case 2:
      return is_signed ? ScalarType::i16 : ScalarType::u16;
    case 4:
      return is_signed ? ScalarType::i32 : ScalarType::u32;
    case 8:
      return is_signed ? ScalarType::i64 : ScalarType::u64;
    default:
      return std::nullopt;
  }
}

/// Reads one header, line by line; what the lines say together is checked at the end.
class HeaderParser {
 public:
  HeaderParser(std::string_view text, const std::string& file_name) : lines_(text), file_(file_name) {}

  PcdHeader parse() {
    while (const auto line = lines_.next()) {
      if (trimmed(*line).starts_with('#')) {
        take_comment(trimmed(*line).substr(1));
        continue;
      }
      const auto parts = words(*line);
      if (parts.empty()) continue;
      take_entry(parts.front(), {parts.begin() + 1, parts.end()});
      if (parts.front() == "DATA") return finish();
    }
    fail("the header has no line 'DATA': the file is cut off or is no PCD file");
  }

 private:
  using Words = std::vector<std::string_view>;

  void take_comment(std::string_view text) {
    if (trimmed(text).starts_with(".PCD")) return;  // the title line
    if (text.starts_with(' ')) text.remove_prefix(1);
    header_.comments.emplace_back(text);
  }

  void take_entry(std::string_view keyword, const Words& values) {
    if (!seen_.insert(keyword).second) fail("a second line '" + printable(keyword) + "'");
    if (keyword == "VERSION") return check_version(values);
    if (keyword == "FIELDS" || keyword == "COLUMNS") return void(names_ = values);
    if (keyword == "SIZE") return void(sizes_ = counts(keyword, values));
    if (keyword == "TYPE") return void(types_ = values);
    if (keyword == "COUNT") return void(counts_ = counts(keyword, values));
    if (keyword == "WIDTH") return void(width_ = one_count(keyword, values));
    if (keyword == "HEIGHT") return void(height_ = one_count(keyword, values));
    if (keyword == "POINTS") return void(points_ = one_count(keyword, values));
    if (keyword == "VIEWPOINT") return take_viewpoint(values);
    if (keyword == "DATA") return take_encoding(values);
    fail("unknown keyword '" + printable(keyword) + "' in the header");
  }

  void check_version(const Words& values) const {
    for (const std::string_view known : {".7", "0.7", ".6", "0.6", ".5", "0.5"}) {
      if (values.size() == 1 && values[0] == known) return;
    }
    fail("PCD version '" + (values.empty() ? std::string() : printable(values[0])) + "' (known: 0.5 to 0.7)");
  }

  std::vector<std::size_t> counts(std::string_view keyword, const Words& values) const {
    std::vector<std::size_t> numbers;
    for (const std::string_view value : values) {
      const auto number = parse_count(value);
      if (!number) fail("'" + printable(value) + "' is no " + std::string(keyword));
      numbers.push_back(*number);
    }
    return numbers;
  }

  std::size_t one_count(std::string_view keyword, const Words& values) const {
    if (values.size() != 1) fail(std::string(keyword) + " needs one number");
    return counts(keyword, values).front();
  }

  void take_viewpoint(const Words& values) {
    if (values.size() != 7) fail("VIEWPOINT needs seven numbers: x y z qw qx qy qz");
    Eigen::Vector3d position;
    for (std::size_t i = 0; i < 7; ++i) {
      const auto number = parse_double(values[i]);
      if (!number || !std::isfinite(*number)) fail("'" + printable(values[i]) + "' is no coordinate of VIEWPOINT");
      if (i < 3) position[static_cast<Eigen::Index>(i)] = *number;
    }
    if (!position.isZero(0)) header_.viewpoint = position;
  }

  void take_encoding(const Words& values) {
    const std::string_view name = values.size() == 1 ? values[0] : "";
    if (name == "ascii")
      header_.encoding = PcdEncoding::ascii;
    else if (name == "binary")
      header_.encoding = PcdEncoding::binary;
    else if (name == "binary_compressed")
      header_.encoding = PcdEncoding::binary_compressed;
    else
      fail("unknown DATA '" + printable(name) + "' (known: ascii, binary, binary_compressed)");
  }

  PcdHeader finish() {
    if (!lines_.terminated() && header_.encoding != PcdEncoding::ascii) fail("the file ends with the header");
    make_fields();
    header_.points = number_of_points();
    header_.body = lines_.position();
    header_.lines = lines_.number();
    return std::move(header_);
  }

  void make_fields() {
    if (names_.empty()) fail("the header has no FIELDS");
    if (counts_.empty()) counts_.assign(names_.size(), 1);
    check_length("SIZE", sizes_.size());
    check_length("TYPE", types_.size());
    check_length("COUNT", counts_.size());
    std::set<std::string_view> seen;
    std::size_t columns = 0;
    for (std::size_t i = 0; i < names_.size(); ++i) {
      const auto type = scalar_type(types_[i], sizes_[i]);
      if (!type)
        fail("field '" + printable(names_[i]) + "': there is no type " + printable(types_[i]) + " of " +
             std::to_string(sizes_[i]) + " bytes");
      if (names_[i] != "_" && !seen.insert(names_[i]).second)
        fail("field '" + printable(names_[i]) + "' appears twice");
      if (counts_[i] > kMaxColumns || (columns += counts_[i]) > kMaxColumns) {
        fail("more than " + std::to_string(kMaxColumns) + " values a point");
      }
      header_.fields.push_back({std::string(names_[i]), *type, counts_[i]});
    }
  }

  void check_length(const char* keyword, std::size_t length) const {
    if (length != names_.size()) {
      fail(std::string(keyword) + " has " + std::to_string(length) + " entries for " + std::to_string(names_.size()) +
           " fields");
    }
  }

  std::size_t number_of_points() const {
    if (!width_) {
      if (!points_) fail("the header has neither WIDTH nor POINTS");
      return *points_;
    }
    std::size_t product = 0;
    if (__builtin_mul_overflow(*width_, height_.value_or(1), &product) || (points_ && *points_ != product)) {
      fail("WIDTH " + std::to_string(*width_) + " times HEIGHT " + std::to_string(height_.value_or(1)) +
           " is not POINTS " + std::to_string(points_.value_or(product)));
    }
    return product;
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw Error(file_ + ", line " + std::to_string(lines_.number()) + ": " + what);
  }

  Lines lines_;
  const std::string& file_;
  PcdHeader header_;
  std::set<std::string_view> seen_;
  Words names_, types_;
  std::vector<std::size_t> sizes_, counts_;
  std::optional<std::size_t> width_, height_, points_;
};

}  // namespace

PcdHeader parse_pcd_header(std::string_view text, const std::string& file_name) {
  return HeaderParser(text, file_name).parse();
}

}  // namespace scenelore::perception
