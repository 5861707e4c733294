// Where in a wall something may stand out by less than its points scatter.
#pragma once

#include <vector>

#include "height_grid.hpp"

namespace scenelore::perception {

/// A rectangle of cells, ends excluded.
struct CellRectangle {
  int left = 0, right = 0, bottom = 0, top = 0;
};

/// The rectangles that explain most when all of each is offset by one height, none like another, best first: the scan
/// statistic of Kulldorff (1997) for Gaussian heights, after a polynomial of second degree is taken away from all
/// (partial regression: Frisch & Waugh 1933, Lovell 1963), so that a bent wall is no step. `weight` is one over the
/// variance of each height, 1/m². Only those with more than `evidence` nats; at most `most`.
[[nodiscard]] std::vector<CellRectangle> scan_for_steps(const HeightGrid& grid, const std::vector<double>& weight,
                                                        double evidence, std::size_t most);

}  // namespace scenelore::perception
