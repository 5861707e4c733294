// GeoPackage geometry blobs of polygons (OGC 12-128r17, clause 2.1.3; ISO WKB inside).
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "scenelore/perception/plane.hpp"

namespace scenelore::kb {

enum class Dimensions { xy, xyz };  ///< xy: POLYGON, z is left out; xyz: POLYGON Z

/// Rings are closed in the blob. A polygon without corners becomes the empty geometry, with the envelope left out.
[[nodiscard]] std::vector<std::byte> encode_polygon(const perception::Polygon& polygon, Dimensions dimensions);

/// The inverse for POLYGON Z blobs of our own making, and those that GIS programs write back (any envelope).
/// Throws Error saying what is wrong with the blob.
[[nodiscard]] perception::Polygon decode_polygon(std::span<const std::byte> blob);

}  // namespace scenelore::kb
