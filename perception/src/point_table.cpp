#include "scenelore/perception/point_table.hpp"

#include <algorithm>
#include <cassert>

#include "bytes.hpp"
#include "scenelore/perception/error.hpp"

namespace scenelore::perception {
namespace {

template <class T>
constexpr ScalarType type_of() {
  if constexpr (std::is_same_v<T, std::int32_t>)
    return ScalarType::i32;
  else if constexpr (std::is_same_v<T, float>)
    return ScalarType::f32;
  else
    return ScalarType::u8;
}

/// The table with one more column at the end; its bytes are zero.
void append_column(PointTable& table, const std::string& name, ScalarType type) {
  const std::size_t old_stride = table.stride;
  add_column(table, name, type);
  table.bytes.resize(table.rows * table.stride);
  for (std::size_t row = table.rows; row-- > 0;) {  // from the back: no row overwrites one that has not moved yet
    std::memmove(table.bytes.data() + row * table.stride, table.bytes.data() + row * old_stride, old_stride);
  }
}

void drop_column(PointTable& table, std::size_t index) {
  const Column dropped = table.columns[index];
  const std::size_t size = size_of(dropped.type), new_stride = table.stride - size;
  const std::size_t behind = dropped.offset + size;
  for (std::size_t row = 0; row < table.rows; ++row) {
    const std::byte* const from = table.bytes.data() + row * table.stride;
    std::byte* const to = table.bytes.data() + row * new_stride;
    std::memmove(to, from, dropped.offset);
    std::memmove(to + dropped.offset, from + behind, table.stride - behind);
  }
  table.columns.erase(table.columns.begin() + static_cast<std::ptrdiff_t>(index));
  for (Column& column : table.columns) {
    if (column.offset > dropped.offset) column.offset -= size;
  }
  table.stride = new_stride;
  table.bytes.resize(table.rows * new_stride);
}

template <class T>
void set_values(PointTable& table, const std::string& name, std::span<const T> values) {
  if (values.size() != table.rows) {
    throw Error("column '" + name + "': " + std::to_string(values.size()) + " values for " +
                std::to_string(table.rows) + " points");
  }
  const auto known = [&] {
    return std::find_if(table.columns.begin(), table.columns.end(), [&](const Column& c) { return c.name == name; });
  };
  auto column = known();
  if (column != table.columns.end() && column->type != type_of<T>()) {
    drop_column(table, static_cast<std::size_t>(column - table.columns.begin()));
    column = table.columns.end();
  }
  if (column == table.columns.end()) append_column(table, name, type_of<T>());
  column = known();
  for (std::size_t row = 0; row < table.rows; ++row)
    store(table.bytes.data() + row * table.stride + column->offset, values[row]);
}

}  // namespace

const Column* PointTable::find(std::string_view name) const {
  const auto column = std::find_if(columns.begin(), columns.end(), [&](const Column& c) { return c.name == name; });
  return column == columns.end() ? nullptr : &*column;
}

double PointTable::value(const Column& column, std::size_t row) const {
  assert(row < rows);
  const std::byte* const at = bytes.data() + row * stride + column.offset;
  return with_type(column.type, [&](auto zero) { return static_cast<double>(load<decltype(zero)>(at)); });
}

void PointTable::set_column(const std::string& name, std::span<const std::int32_t> values) {
  set_values(*this, name, values);
}
void PointTable::set_column(const std::string& name, std::span<const float> values) { set_values(*this, name, values); }
void PointTable::set_column(const std::string& name, std::span<const std::uint8_t> values) {
  set_values(*this, name, values);
}

}  // namespace scenelore::perception
