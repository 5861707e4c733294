// Text line by line and word by word, with the position that an error message needs.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace scenelore::perception {

/// Lines end with \n or \r\n, the last one with the text.
class Lines {
 public:
  explicit Lines(std::string_view text) : text_(text) {}

  /// The next line without its end, or nothing after the last one.
  [[nodiscard]] std::optional<std::string_view> next() {
    if (at_ >= text_.size()) return std::nullopt;
    const std::size_t end = text_.find('\n', at_);
    terminated_ = end != std::string_view::npos;
    std::string_view line = text_.substr(at_, terminated_ ? end - at_ : std::string_view::npos);
    at_ = terminated_ ? end + 1 : text_.size();
    ++number_;
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line;
  }

  [[nodiscard]] std::size_t number() const { return number_; }   ///< of the line last given, from 1
  [[nodiscard]] std::size_t position() const { return at_; }     ///< bytes up to the next line
  [[nodiscard]] bool terminated() const { return terminated_; }  ///< whether the line last given had an end

 private:
  std::string_view text_;
  std::size_t at_ = 0, number_ = 0;
  bool terminated_ = true;
};

inline constexpr std::string_view kBlank = " \t\v\f\r";

[[nodiscard]] inline std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kBlank);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

/// Takes the next word from the front of `line`; empty when there is none.
[[nodiscard]] inline std::string_view take_word(std::string_view& line) {
  const auto blank = [](char c) { return c == ' ' || (c >= '\t' && c <= '\r'); };
  std::size_t first = 0;
  while (first < line.size() && blank(line[first])) ++first;
  std::size_t last = first;
  while (last < line.size() && !blank(line[last])) ++last;
  const std::string_view word = line.substr(first, last - first);
  line.remove_prefix(last);
  return word;
}

/// What a foreign file holds, fit for an error message: at most 40 characters, all of them plain ASCII.
[[nodiscard]] inline std::string printable(std::string_view text) {
  std::string out(text.substr(0, 40));
  for (char& c : out) {
    if (c < 0x20 || c == 0x7f) c = '?';
  }
  return text.size() > 40 ? out + "…" : out;
}

[[nodiscard]] inline std::vector<std::string_view> words(std::string_view line) {
  std::vector<std::string_view> all;
  for (std::string_view word = take_word(line); !word.empty(); word = take_word(line)) all.push_back(word);
  return all;
}

}  // namespace scenelore::perception
