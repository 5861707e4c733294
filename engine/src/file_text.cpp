#include "file_text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "scenelore/engine/error.hpp"

namespace scenelore::engine {

FileText::FileText(std::string text, std::string name, std::string_view punctuation, bool quotes)
    : text_(std::move(text)), name_(std::move(name)), quotes_(quotes) {
  for (const char c : punctuation) is_punctuation_[static_cast<unsigned char>(c)] = true;
}

void FileText::scan() {
  if (scanned_) return;
  const auto is_space = [](char c) { return c == ' ' || (c >= '\t' && c <= '\r'); };
  const auto is_punctuation = [&](char c) { return is_punctuation_[static_cast<unsigned char>(c)]; };
  while (position_ < text_.size() && is_space(text_[position_])) ++position_;
  word_begin_ = word_end_ = position_;
  quoted_ = false;
  scanned_ = true;
  if (position_ == text_.size()) return;
  if (quotes_ && text_[position_] == '"') {
    word_begin_ = position_ + 1;
    word_end_ = text_.find('"', word_begin_);
    if (word_end_ == std::string::npos) fail("a name begins with a quote, which nothing closes");
    position_ = word_end_ + 1;
    quoted_ = true;
    return;
  }
  if (is_punctuation(text_[position_])) {
    word_end_ = ++position_;
    return;
  }
  while (position_ < text_.size() && !is_space(text_[position_]) && !is_punctuation(text_[position_]) &&
         !(quotes_ && text_[position_] == '"'))
    ++position_;
  word_end_ = position_;
}

std::size_t FileText::here() {
  scan();
  return word_begin_;
}

void FileText::go_to(std::size_t place) {
  position_ = place;
  scanned_ = false;
}

bool FileText::at_end() {
  scan();
  return word_end_ == word_begin_ && !quoted_;
}

std::string_view FileText::peek() {
  scan();
  return std::string_view(text_).substr(word_begin_, word_end_ - word_begin_);
}

std::string_view FileText::next() {
  const std::string_view word = peek();
  if (word.empty() && !quoted_) fail("the file ends too early");
  scanned_ = false;
  return word;
}

bool FileText::peek_is_quoted() {
  scan();
  return quoted_;
}

bool FileText::accept(std::string_view word) {
  if (peek() != word || quoted_) return false;
  scanned_ = false;
  return true;
}

void FileText::expect(std::string_view word) {
  if (accept(word)) return;
  if (at_end()) fail("the file ends where '" + std::string(word) + "' is expected");
  fail("'" + std::string(word) + "' is expected, not '" + std::string(peek().substr(0, 40)) + "'");
}

long long FileText::integer(const char* what, long long least, long long most) {
  const std::string_view word = peek();
  long long value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (at_end()) fail(std::string("the file ends where ") + what + " is expected");
  if (error != std::errc() || end != word.data() + word.size())
    fail(std::string(what) + " is expected, not '" + std::string(word.substr(0, 40)) + "'");
  if (value < least || value > most)
    fail(std::string(what) + " is " + std::to_string(value) + "; it must be from " + std::to_string(least) + " to " +
         std::to_string(most));
  scanned_ = false;
  return value;
}

double FileText::number(const char* what) {
  std::string_view word = peek();
  if (word.starts_with('+')) word.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (at_end()) fail(std::string("the file ends where ") + what + " is expected");
  if (error == std::errc::result_out_of_range && word.find("e-") != std::string_view::npos)
    value = 0;  // too small for a double
  else if (error != std::errc() || end != word.data() + word.size() || std::isnan(value))
    fail(std::string(what) + " is expected, not '" + std::string(word.substr(0, 40)) + "'");
  scanned_ = false;
  return value;
}

void FileText::fail(const std::string& what) const {
  const auto line = 1 + std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(word_begin_), '\n');
  throw FileError(name_ + ", line " + std::to_string(line) + ": " + what);
}

}  // namespace scenelore::engine
