// Scalars in packed records: unaligned, and in either byte order.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstring>

#include "scenelore/perception/point_table.hpp"

namespace scenelore::perception {

static_assert(std::endian::native == std::endian::little, "tables hold little-endian records and are read in place");

template <class T>
[[nodiscard]] inline T load(const std::byte* at) {
  T value;
  std::memcpy(&value, at, sizeof value);
  return value;
}

template <class T>
inline void store(std::byte* at, T value) {
  std::memcpy(at, &value, sizeof value);
}

/// Calls f with a value-initialised T of the given scalar type: from a type known at run time to one known at compile
/// time.
template <class F>
decltype(auto) with_type(ScalarType type, F&& f) {
  switch (type) {
    case ScalarType::i8:
      return f(std::int8_t{});
    case ScalarType::u8:
      return f(std::uint8_t{});
    case ScalarType::i16:
      return f(std::int16_t{});
    case ScalarType::u16:
      return f(std::uint16_t{});
    case ScalarType::i32:
      return f(std::int32_t{});
    case ScalarType::u32:
      return f(std::uint32_t{});
    case ScalarType::i64:
      return f(std::int64_t{});
    case ScalarType::u64:
      return f(std::uint64_t{});
    case ScalarType::f32:
      return f(float{});
    case ScalarType::f64:
      break;
  }
  return f(double{});
}

/// Appends a column behind the last one, packed.
inline void add_column(PointTable& table, std::string name, ScalarType type) {
  table.columns.push_back({std::move(name), type, table.stride});
  table.stride += size_of(type);
}

}  // namespace scenelore::perception
