// Keyboards, books, pictures, whiteboards: a few centimetres in front of the plane that carries them, less than the noise
// of a single point. Their points together are not: the mean of n of them is known to σ/√n.
#pragma once

#include "regions.hpp"
#include "scenelore/perception/upright.hpp"

namespace scenelore::perception {

/// Splits patches of 1 to 8 cm offset off every plane of more than 0.1 m². Tops that are level within 6 degrees are first
/// fitted level, which leaves one unknown instead of three: what lies on them would otherwise tilt them. Only points of the
/// plane and free points take part. New regions are appended.
void split_thin_objects(const Cloud& cloud, const Upright& upright, const Limits& limits, Regions& regions);

}  // namespace scenelore::perception
