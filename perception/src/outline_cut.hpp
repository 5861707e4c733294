// Things that touch and are equally high are told apart by their outline: two rectangles say more than one.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace scenelore::perception {

/// Cuts a set of cells (mean places, metres; edge of a cell) along a straight line into two, and these again, as long as the
/// smallest rectangles around the two parts together are clearly smaller than the one around both. Returns indices into
/// `places`, each once; one part where no cut pays.
[[nodiscard]] std::vector<std::vector<std::size_t>> cut_outline(const std::vector<Eigen::Vector2d>& places, double edge);

}  // namespace scenelore::perception
