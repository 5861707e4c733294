// Values as bytes, for a pipe between two processes of this program, and for answers that one run keeps for the next.
#pragma once

#include <cstring>
#include <string>
#include <string_view>

#include "scenelore/rules/error.hpp"

namespace scenelore::rules {

/// Values one after another; both ends run the same program, so numbers go as they lie in memory.
class Writer {
 public:
  template <typename T>
  void number(T value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  void text(const std::string& value) {
    number(value.size());
    bytes += value;
  }
  std::string bytes;
};

/// The reader trusts nothing: what ends too early is an Error.
class Reader {
 public:
  explicit Reader(std::string_view bytes) : rest_(bytes) {}
  template <typename T>
  T number() {
    T value;
    std::memcpy(&value, take(sizeof value).data(), sizeof value);
    return value;
  }
  std::string text() { return std::string(take(number<std::size_t>())); }
  /// Of a list whose entries take at least one byte each.
  std::size_t count() {
    const auto n = number<std::size_t>();
    if (n > rest_.size()) broken();
    return n;
  }

 private:
  [[noreturn]] static void broken() { throw Error("the isolated rules sent an answer that cannot be read"); }
  std::string_view take(std::size_t size) {
    if (size > rest_.size()) broken();
    const std::string_view taken = rest_.substr(0, size);
    rest_.remove_prefix(size);
    return taken;
  }
  std::string_view rest_;
};

}  // namespace scenelore::rules
