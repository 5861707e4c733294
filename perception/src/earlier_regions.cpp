#include "earlier_regions.hpp"

#include <algorithm>

namespace scenelore::perception {
namespace {

constexpr double kMost = 0.7;  // of a region's points; of one that lost more to others little is left to judge

}  // namespace

void bring_back(const Cloud& cloud, std::span<const std::int32_t> earlier, int fewest, Regions& regions) {
  const auto count = earlier.empty() ? 0 : static_cast<std::size_t>(*std::max_element(earlier.begin(), earlier.end()) + 1);
  std::vector<std::size_t> all(count), free(count);
  for (std::size_t i = 0; i < earlier.size(); ++i) {
    if (earlier[i] < 0) continue;
    ++all[static_cast<std::size_t>(earlier[i])];
    if (regions.of_point[i] < 0) ++free[static_cast<std::size_t>(earlier[i])];
  }
  std::vector<std::int32_t> number(count, -1);
  for (std::size_t r = 0; r < count; ++r) {
    if (static_cast<double>(free[r]) < std::max(static_cast<double>(fewest), kMost * static_cast<double>(all[r]))) continue;
    number[r] = static_cast<std::int32_t>(regions.planes.size());
    regions.planes.emplace_back();
  }
  std::vector<Moments> moments(regions.planes.size());
  for (std::size_t i = 0; i < earlier.size(); ++i) {
    if (earlier[i] < 0 || regions.of_point[i] >= 0 || number[static_cast<std::size_t>(earlier[i])] < 0) continue;
    regions.of_point[i] = number[static_cast<std::size_t>(earlier[i])];
    moments[static_cast<std::size_t>(regions.of_point[i])].add(cloud.x[i], cloud.y[i], cloud.z[i]);
  }
  for (const std::int32_t n : number) {
    if (n >= 0) regions.planes[static_cast<std::size_t>(n)] = fit_plane(moments[static_cast<std::size_t>(n)]);
  }
}

}  // namespace scenelore::perception
