// Things that touch and are equally high are told apart by their outline: two rectangles say more than one.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace scenelore::perception {

struct OutlineCut {
  double clearly = 0.83;         ///< area of the two rectangles over that of the one, at most
  double fill = 0;               ///< share of its rectangle that each part must fill: shadows leave triangles, not rectangles
  double smallest_part = 0.003;  ///< m², of the rectangle around a part
  double largest = 0.4;          ///< m², larger sets are left whole
};

/// Cuts a set of cells (mean places, metres; edge of a cell) along a straight line into two, and these again, as long as the
/// smallest rectangles around the two parts together are clearly smaller than the one around both. Returns indices into
/// `places`, each once; one part where no cut pays.
[[nodiscard]] std::vector<std::vector<std::size_t>> cut_outline(const std::vector<Eigen::Vector2d>& places, double edge,
                                                                const OutlineCut& limits = {});

}  // namespace scenelore::perception
