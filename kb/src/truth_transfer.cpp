#include "truth_transfer.hpp"

#include <map>
#include <utility>

namespace scenelore::kb {

std::vector<std::int32_t> match_planes(std::span<const std::int32_t> old_plane_of_point,
                                       std::span<const std::int32_t> new_plane_of_point, std::size_t old_planes) {
  std::vector<std::int32_t> match(old_planes, -1);
  if (old_plane_of_point.size() != new_plane_of_point.size()) return match;
  std::map<std::int32_t, std::size_t> old_size, new_size;
  std::map<std::pair<std::int32_t, std::int32_t>, std::size_t> shared;
  for (std::size_t i = 0; i < old_plane_of_point.size(); ++i) {
    const std::int32_t before = old_plane_of_point[i], after = new_plane_of_point[i];
    ++old_size[before];
    ++new_size[after];
    if (before >= 0 && after >= 0) ++shared[{before, after}];
  }
  for (const auto& [pair, points] : shared) {
    const bool mutual = 2 * points > old_size[pair.first] && 2 * points > new_size[pair.second];
    if (mutual && static_cast<std::size_t>(pair.first) < old_planes) match[static_cast<std::size_t>(pair.first)] = pair.second;
  }
  return match;
}

}  // namespace scenelore::kb
