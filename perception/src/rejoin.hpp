// What is given up as a face of its own, and is a piece of the plane beside it.
#pragma once

#include "adjacency.hpp"

namespace scenelore::perception {

/// By region: of those that are given up, the larger plane beside it that explains it, −1 = none. A plane explains the points of a region
/// that scatter about it as its own do and whose middle lies within half their deviation: pieces of a wall that something parted from it, and not
/// what stands a few millimetres before it. Regions of less than 0.02 m² are left out. `noise` (metres) is that of the cloud. `planes` are
/// those of all regions, also of those given up.
[[nodiscard]] std::vector<std::int32_t> planes_to_rejoin(const Pyramid& pyramid, const Slots& slots, const std::vector<PlaneFit>& planes,
                                                         const std::vector<bool>& given_up, double noise);

}  // namespace scenelore::perception
