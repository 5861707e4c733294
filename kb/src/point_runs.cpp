#include "point_runs.hpp"

#include <limits>

#include "scenelore/kb/error.hpp"

namespace scenelore::kb {

namespace {

void put_varint(std::vector<std::byte>& blob, std::uint64_t value) {
  for (; value >= 0x80; value >>= 7) blob.push_back(static_cast<std::byte>(value | 0x80));
  blob.push_back(static_cast<std::byte>(value));
}

std::uint64_t get_varint(std::span<const std::byte>& rest) {
  std::uint64_t value = 0;
  for (unsigned shift = 0; shift < 63; shift += 7) {
    if (rest.empty()) throw Error("plane numbers end too early");
    const auto byte = std::to_integer<std::uint64_t>(rest.front());
    rest = rest.subspan(1);
    value |= (byte & 0x7f) << shift;
    if (byte < 0x80) return value;
  }
  throw Error("plane numbers hold an impossible value");
}

}  // namespace

std::vector<std::byte> encode_runs(std::span<const std::int32_t> numbers) {
  std::vector<std::byte> blob;
  for (std::size_t begin = 0, end = 0; begin < numbers.size(); begin = end) {
    while (end < numbers.size() && numbers[end] == numbers[begin]) ++end;
    put_varint(blob, static_cast<std::uint64_t>(std::int64_t{numbers[begin]} + 1));
    put_varint(blob, end - begin);
  }
  return blob;
}

std::vector<std::int32_t> decode_runs(std::span<const std::byte> blob, std::size_t points) {
  std::vector<std::int32_t> numbers;
  while (!blob.empty()) {
    const std::uint64_t number = get_varint(blob), length = get_varint(blob);
    if (number > std::numeric_limits<std::int32_t>::max() || length > points - numbers.size()) {
      throw Error("plane numbers hold an impossible value");
    }
    numbers.insert(numbers.end(), length, static_cast<std::int32_t>(static_cast<std::int64_t>(number) - 1));
  }
  if (numbers.size() != points) throw Error("plane numbers end too early");
  return numbers;
}

}  // namespace scenelore::kb
