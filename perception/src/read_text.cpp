#include <algorithm>
#include <cctype>
#include <cmath>

#include "bytes.hpp"
#include "formats.hpp"
#include "lines.hpp"
#include "numbers.hpp"
#include "scenelore/perception/error.hpp"
#include "text_columns.hpp"

namespace scenelore::perception {
namespace {

constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";

std::string_view without_mark(std::string_view text) {
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  return text;
}

/// The text of a comment line, or nothing when the line is none.
std::optional<std::string_view> comment(std::string_view line) {
  if (line.starts_with('#')) return line.substr(1);
  if (line.starts_with("//")) return line.substr(2);
  return std::nullopt;
}

/// Takes all values of one file row by row, as doubles; the columns get names and narrower types at the end.
class TextReader {
 public:
  TextReader(const MappedFile& file, const std::string& name)
      : text_(without_mark(file.text())), name_(name), lines_(text_) {}

  PointTable read() && {
    while (const auto raw = lines_.next()) {
      const std::string_view line = trimmed(*raw);
      if (line.empty()) continue;
      if (const auto text = comment(line))
        take_comment(*text);
      else if (rows_ == 0)
        take_first(line);
      else
        take_row(line);
    }
    return finish();
  }

 private:
  void take_comment(std::string_view text) {
    const auto names = split(trimmed(text), separator_of(text));
    if (rows_ == 0 && names_.empty() && names_coordinates(names))
      names_ = column_names(names);
    else
      table_.comments.emplace_back(trimmed(text));
  }

  /// The first lines may be a number of points and a line of names; the first point tells separator and number of
  /// columns.
  void take_first(std::string_view line) {
    separator_ = separator_of(line);
    const auto tokens = split(line, separator_);
    const bool numeric = parse_double(tokens[0]).has_value();
    if (tokens.size() == 1 && numeric && !promised_) {
      promised_ = parse_count(tokens[0]);
      if (!promised_) fail("'" + printable(tokens[0]) + "' is neither a point nor a number of points");
      return;
    }
    if (!numeric && names_coordinates(tokens)) {
      names_ = column_names(tokens);
      return;
    }
    if (!numeric) fail("'" + printable(tokens[0]) + "' is no number, and the line does not name columns x, y and z");
    if (tokens.size() < 3) fail("a point needs three numbers at least, found " + std::to_string(tokens.size()));
    if (!names_.empty() && names_.size() != tokens.size()) {
      fail(std::to_string(tokens.size()) + " values, but " + std::to_string(names_.size()) +
           " columns are named above");
    }
    columns_.resize(tokens.size());
    const std::size_t likely_rows = (text_.size() - lines_.position()) / (line.size() + 1) + 2;
    table_.bytes.reserve(likely_rows * tokens.size() * sizeof(double));
    take_row(line);
  }

  void take_row(std::string_view line) {
    std::size_t at = table_.bytes.size();
    table_.bytes.resize(at + columns_.size() * sizeof(double));
    for (std::size_t i = 0; i < columns_.size(); ++i, at += sizeof(double)) {
      if (i > 0 && line.data() == nullptr) fail("no value for column " + column_name(i));
      const std::string_view token = take_field(line, separator_);
      if (token.empty())
        fail("no value for column " + column_name(i) + (separator_ == ' ' ? "" : " (write nan where there is none)"));
      const auto value = parse_double(token);
      if (!value) fail("'" + printable(token) + "' is no number, column " + column_name(i));
      columns_[i].take(token, *value);
      store(table_.bytes.data() + at, *value);
    }
    if (line.data() != nullptr && !trimmed(line).empty())
      fail("more than " + std::to_string(columns_.size()) + " values");
    ++rows_;
  }

  [[nodiscard]] std::string column_name(std::size_t index) const {
    return std::to_string(index + 1) + (index < names_.size() ? " ('" + printable(names_[index]) + "')" : "");
  }

  PointTable finish() {
    if (promised_ && *promised_ != rows_) {
      throw Error(name_ + ": the first line promises " + std::to_string(*promised_) + " points, the file holds " +
                  std::to_string(rows_));
    }
    if (rows_ == 0) throw Error(name_ + " holds no points");
    table_.rows = rows_;
    if (names_.empty()) names_ = default_names(columns_);
    narrow(table_, unique_names(names_), columns_);
    return std::move(table_);
  }

  [[nodiscard]] std::vector<std::string> unique_names(std::vector<std::string> names) const {
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (std::find(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(i), names[i]) !=
          names.begin() + static_cast<std::ptrdiff_t>(i)) {
        throw Error(name_ + ": two columns are named '" + printable(names[i]) + "'");
      }
    }
    return names;
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw Error(name_ + ", line " + std::to_string(lines_.number()) + ": " + what);
  }

  std::string_view text_;
  const std::string& name_;
  Lines lines_;
  PointTable table_;
  std::vector<std::string> names_;
  std::vector<TextColumn> columns_;
  char separator_ = ' ';
  std::optional<std::size_t> promised_;
  std::size_t rows_ = 0;
};

}  // namespace

bool looks_like_text(std::string_view text) {
  text = without_mark(text);
  if (text.substr(0, 4096).find('\0') != std::string_view::npos) return false;
  Lines lines(text.substr(0, 65536));
  while (const auto raw = lines.next()) {
    const std::string_view line = trimmed(*raw);
    if (line.empty()) continue;
    const auto text_of_comment = comment(line);
    const std::string_view content = text_of_comment ? trimmed(*text_of_comment) : line;
    const auto tokens = split(content, separator_of(content));
    if (names_coordinates(tokens)) return true;
    if (text_of_comment) continue;
    if (tokens.size() == 1) return parse_count(tokens[0]).has_value();
    return tokens.size() >= 3 &&
           std::all_of(tokens.begin(), tokens.begin() + 3, [](auto token) { return parse_double(token).has_value(); });
  }
  return false;
}

PointTable read_text(const MappedFile& file, const std::string& file_name) {
  return TextReader(file, file_name).read();
}

}  // namespace scenelore::perception
