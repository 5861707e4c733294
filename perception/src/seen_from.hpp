// From where the sensor saw a plane: on which side it stood, and at what slant.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "scenelore/perception/cloud.hpp"
#include "scenelore/perception/plane_fit.hpp"

namespace scenelore::perception {

/// Whether the sensor stood on the side that the normal points to (the plane in the cloud's offsets) when it measured these points, or most
/// of them where it stood on both sides. Nothing where that is not known, or as many points say the one as the other.
[[nodiscard]] std::optional<bool> seen_from_front(const Cloud& cloud, const PlaneEquation& plane, std::span<const std::uint32_t> points);

/// Cosines between the normal and the rays to these points, 0 (along the plane) to 1 (squarely). None where it is not known of every point from
/// where it was measured.
[[nodiscard]] std::vector<double> slants_of(const Cloud& cloud, const Eigen::Vector3d& normal, std::span<const std::uint32_t> points);

/// Their mean. Nothing where there are none.
[[nodiscard]] std::optional<double> slant_of(const Cloud& cloud, const Eigen::Vector3d& normal, std::span<const std::uint32_t> points);

/// How far points scatter across a plane that is seen at this slant, metres, when ranges scatter by `noise`: noise runs along the ray. A tenth of it at
/// the least, since directions are not exact either.
[[nodiscard]] double noise_across(double noise, double slant);

}  // namespace scenelore::perception
