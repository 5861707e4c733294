// The five parameters: what the user set, and what follows from the cloud for the rest.
#pragma once

#include "regions.hpp"
#include "scale.hpp"
#include "scenelore/perception/parameters.hpp"
#include "surface_voxels.hpp"

namespace scenelore::perception {

/// Throws Error naming the parameter that is out of range.
void check(const SegmentationParameters& parameters);

[[nodiscard]] Limits derive_limits(const SegmentationParameters& parameters, const Scale& scale, const NoiseMap& noise);

/// The limits as parameters, all set.
[[nodiscard]] SegmentationParameters to_parameters(const Limits& limits);

}  // namespace scenelore::perception
