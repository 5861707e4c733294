// The coordinates of rows wherever they stand, in a table or still in the file.
#pragma once

#include "mapped_file.hpp"
#include "scenelore/perception/cloud.hpp"

namespace scenelore::perception {

struct RowSource {
  const PointTable& table;          ///< columns, stride and number of rows
  const std::byte* bytes;           ///< of the first row
  const MappedFile* file = nullptr; ///< when the rows stand in it: pages are let go once read
};

/// As to_cloud() of a table, whatever the number of threads.
[[nodiscard]] Cloud to_cloud(const RowSource& rows, const std::string& source_name, int threads);

}  // namespace scenelore::perception
