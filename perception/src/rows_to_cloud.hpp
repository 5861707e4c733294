// The coordinates of rows wherever they stand, in a table or still in the file.
#pragma once

#include "bytes.hpp"
#include "mapped_file.hpp"
#include "scenelore/perception/cloud.hpp"

namespace scenelore::perception {

struct RowSource {
  const PointTable& table;          ///< columns, stride and number of rows
  const std::byte* bytes;           ///< of the first row
  const MappedFile* file = nullptr; ///< when the rows stand in it: pages are let go once read
};

/// In double precision; exact for all types but 64-bit integers.
[[nodiscard]] inline double value_at(const RowSource& rows, const Column& column, std::size_t row) {
  const std::byte* const at = rows.bytes + row * rows.table.stride + column.offset;
  return with_type(column.type, [&](auto zero) { return static_cast<double>(load<decltype(zero)>(at)); });
}

/// Where the sensor stood, by the properties vp_x, vp_y, vp_z of the points, else by what the table knows of the whole file. Throws
/// Error where only some of them are there, and where those of a valid point are no position. More positions than SensorPositions
/// holds (a sensor on the move) become the middles of cubes of 5 cm, or of the smallest power of two times that that will do.
[[nodiscard]] SensorPositions sensors_of(const RowSource& rows, const Cloud& cloud, const std::string& source_name);

/// As to_cloud() of a table, whatever the number of threads.
[[nodiscard]] Cloud to_cloud(const RowSource& rows, const std::string& source_name, int threads);

}  // namespace scenelore::perception
