// Heights over a surface by square cells, row by row.
#pragma once

#include <cstddef>
#include <vector>

namespace scenelore::perception {

struct HeightGrid {
  int columns = 0, rows = 0;
  double edge = 0;             ///< metres
  std::vector<double> count;   ///< points of each cell; 0 = nothing is known there
  std::vector<double> height;  ///< metres, their mean

  [[nodiscard]] std::size_t at(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
  }
  /// Visits (column, row, number) of the cells that hold points.
  void for_each_cell(auto visit) const {
    for (int y = 0; y < rows; ++y) {
      for (int x = 0; x < columns; ++x) {
        if (const std::size_t c = at(x, y); count[c] > 0) visit(x, y, c);
      }
    }
  }
  /// Visits the numbers of each two cells that share a side and hold points.
  void for_each_pair(auto visit) const {
    for_each_cell([&](int x, int y, std::size_t c) {
      if (x + 1 < columns && count[c + 1] > 0) visit(c, c + 1);
      if (const std::size_t above = c + static_cast<std::size_t>(columns); y + 1 < rows && count[above] > 0)
        visit(c, above);
    });
  }
};

}  // namespace scenelore::perception
