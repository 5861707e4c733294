// On which side of a plane the sensor stood.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "scenelore/perception/cloud.hpp"
#include "scenelore/perception/plane_fit.hpp"

namespace scenelore::perception {

/// Whether the sensor stood on the side that the normal points to (the plane in the cloud's offsets) when it measured these points, or most
/// of them where it stood on both sides. Nothing where that is not known, or as many points say the one as the other.
[[nodiscard]] std::optional<bool> seen_from_front(const Cloud& cloud, const PlaneEquation& plane, std::span<const std::uint32_t> points);

}  // namespace scenelore::perception
