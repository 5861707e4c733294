#include "point_file_support.hpp"

#include <limits>

namespace scenelore::perception {
namespace {

constexpr std::size_t kRows = 7;

/// Row by row: least, largest, 0, 1, 2, … of the type.
template <class T>
void append(PointTable& table, const std::string& name, ScalarType type) {
  const std::size_t old_stride = table.stride, size = sizeof(T);
  std::vector<std::byte> bytes(kRows * (old_stride + size));
  for (std::size_t row = 0; row < kRows; ++row) {
    T value = static_cast<T>(row);
    if (row == 0) value = std::numeric_limits<T>::lowest();
    if (row == 1) value = std::numeric_limits<T>::max();
    if (std::is_floating_point_v<T> && row == 2) value = std::numeric_limits<T>::quiet_NaN();
    if (std::is_floating_point_v<T> && row == 3) value = std::numeric_limits<T>::denorm_min();
    if (std::is_floating_point_v<T> && row == 4) value = static_cast<T>(0.1);
    std::byte* const to = bytes.data() + row * (old_stride + size);
    if (old_stride > 0) std::memcpy(to, table.bytes.data() + row * old_stride, old_stride);
    std::memcpy(to + old_stride, &value, size);
  }
  table.columns.push_back({name, type, old_stride});
  table.stride = old_stride + size;
  table.bytes = std::move(bytes);
}

}  // namespace

PointTable table_of_every_type(ScalarType coordinates, bool with_64_bit_integers) {
  PointTable table;
  table.rows = kRows;
  for (const char* axis : {"x", "y", "z"}) {
    if (coordinates == ScalarType::f32)
      append<float>(table, axis, coordinates);
    else
      append<double>(table, axis, coordinates);
  }
  append<std::int8_t>(table, "a", ScalarType::i8);
  append<std::uint8_t>(table, "b", ScalarType::u8);
  append<std::int16_t>(table, "c", ScalarType::i16);
  append<std::uint16_t>(table, "d", ScalarType::u16);
  append<std::int32_t>(table, "e", ScalarType::i32);
  append<std::uint32_t>(table, "f", ScalarType::u32);
  append<float>(table, "g", ScalarType::f32);
  append<double>(table, "h", ScalarType::f64);
  if (with_64_bit_integers) {
    append<std::int64_t>(table, "k", ScalarType::i64);
    append<std::uint64_t>(table, "l", ScalarType::u64);
  }
  table.viewpoint = Eigen::Vector3d(0.1, -2, 1e-7);
  table.comments = {"made for a test", "  two leading blanks"};
  return table;
}

}  // namespace scenelore::perception
