#include "numbers.hpp"

#include <charconv>
#include <cmath>
#include <limits>
#include <type_traits>

#include "bytes.hpp"

namespace scenelore::perception {
namespace {

std::string_view without_plus(std::string_view token) {
  if (token.size() > 1 && token[0] == '+' && token[1] != '-' && token[1] != '+') token.remove_prefix(1);
  return token;
}

enum class Parsed { yes, no, out_of_range };

template <class T>
Parsed parse_whole_token(std::string_view token, T& value) {
  const char* const end = token.data() + token.size();
  const auto [stop, error] = std::from_chars(token.data(), end, value);
  if (stop != end || token.empty()) return Parsed::no;
  if (error == std::errc::result_out_of_range) return Parsed::out_of_range;
  return error == std::errc{} ? Parsed::yes : Parsed::no;
}

/// from_chars gives no value for what under- or overflows. A number with a negative exponent, or one that begins
/// with 0., underflows; all others overflow.
bool underflows(std::string_view token) {
  const std::size_t exponent = token.find_first_of("eE");
  if (exponent != std::string_view::npos && exponent + 1 < token.size()) return token[exponent + 1] == '-';
  return token.find_first_of("123456789") > token.find('.');
}

template <class T>
bool parse_float(std::string_view token, T& value) {
  const Parsed parsed = parse_whole_token(token, value);
  if (parsed == Parsed::out_of_range && underflows(token)) {
    value = token[0] == '-' ? -T{0} : T{0};
    return true;
  }
  return parsed == Parsed::yes;
}

template <class T>
bool parse_integer(std::string_view token, T& value) {
  const Parsed parsed = parse_whole_token(token, value);
  if (parsed != Parsed::no) return parsed == Parsed::yes;
  double number = 0;
  if (!parse_float(token, number) || std::trunc(number) != number) return false;
  // The upper limit as a power of two is exact in double, the largest value itself may not be.
  const double upper = std::ldexp(1.0, std::numeric_limits<T>::digits);
  const double lower = std::is_signed_v<T> ? -upper : 0.0;
  if (number < lower || number >= upper) return false;
  value = static_cast<T>(number);
  return true;
}

}  // namespace

std::optional<double> parse_double(std::string_view token) {
  double value = 0;
  if (!parse_float(without_plus(token), value)) return std::nullopt;
  return value;
}

std::optional<std::size_t> parse_count(std::string_view token) {
  std::size_t value = 0;
  if (token.size() > 18 || parse_whole_token(token, value) != Parsed::yes) return std::nullopt;
  return value;
}

bool parse_scalar(std::string_view token, ScalarType type, std::byte* to) {
  return with_type(type, [&](auto value) {
    bool parsed = false;
    if constexpr (std::is_floating_point_v<decltype(value)>) {
      parsed = parse_float(without_plus(token), value);
    } else {
      parsed = parse_integer(without_plus(token), value);
    }
    if (parsed) store(to, value);
    return parsed;
  });
}

}  // namespace scenelore::perception
