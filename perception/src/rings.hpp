// Boundary edges joined to closed loops.
#pragma once

#include <utility>
#include <vector>

namespace scenelore::perception {

/// Requires: every vertex has as many edges coming in as going out. Loops in which no vertex occurs twice; a boundary that
/// touches itself in a vertex falls into two there.
[[nodiscard]] std::vector<std::vector<int>> simple_loops(std::vector<std::pair<int, int>> edges);

}  // namespace scenelore::perception
