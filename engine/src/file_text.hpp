// The words of a problem file, with their lines for error messages.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace scenelore::engine {

class FileText {
 public:
  /// `punctuation`: characters that are words of their own; quotes enclose words when `quotes` is set.
  FileText(std::string text, std::string name, std::string_view punctuation, bool quotes);

  bool at_end();
  /// Where the next word begins, which must not be a quoted one, and back to such a place.
  std::size_t here();
  void go_to(std::size_t place);
  /// After the last word that was taken.
  std::size_t end_of_last() const { return scanned_ ? word_begin_ : position_; }
  /// The next word, left where it is; empty at the end (and for an empty quoted word).
  std::string_view peek();
  std::string_view next();
  bool peek_is_quoted();
  /// Takes the next word if it is this one.
  bool accept(std::string_view word);
  void expect(std::string_view word);
  /// Throws unless the next word is a whole number in [least, most].
  long long integer(const char* what, long long least, long long most);
  double number(const char* what);
  std::size_t size() const { return text_.size(); }
  [[noreturn]] void fail(const std::string& what) const;

 private:
  void scan();

  std::string text_, name_;
  std::array<bool, 256> is_punctuation_{};
  bool quotes_;
  std::size_t position_ = 0, word_begin_ = 0, word_end_ = 0;
  bool scanned_ = false, quoted_ = false;
};

}  // namespace scenelore::engine
