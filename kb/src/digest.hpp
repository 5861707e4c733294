// Values as bytes of which a hash is taken.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "scenelore/kb/sha256.hpp"

namespace scenelore::kb {

/// Puts values in one after another, each with its kind and texts with their length, so that no two contents give the same
/// bytes.
class Digest {
 public:
  Digest& operator()(std::string_view text) {
    number('t', static_cast<std::uint64_t>(text.size()));
    bytes_ += text;
    return *this;
  }
  Digest& operator()(std::int64_t value) { return number('i', value); }
  Digest& operator()(int value) { return number('i', static_cast<std::int64_t>(value)); }
  Digest& operator()(double value) { return number('r', value == 0 ? 0.0 : value); }  // −0 is the same number
  template <typename T>
  Digest& operator()(const std::optional<T>& value) {
    if (value) return (*this)(*value);
    bytes_ += 'n';
    return *this;
  }
  /// Bytes as they are: the caller sees to it that their number is in the digest.
  Digest& raw(std::string_view bytes) {
    bytes_ += bytes;
    return *this;
  }
  [[nodiscard]] const std::string& bytes() const { return bytes_; }
  [[nodiscard]] std::string hex() const { return sha256_of(bytes_); }

 private:
  template <typename T>
  Digest& number(char kind, T value) {
    bytes_ += kind;
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
    return *this;
  }
  std::string bytes_;
};

}  // namespace scenelore::kb
