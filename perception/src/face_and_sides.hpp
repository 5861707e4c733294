// A face that is seen at a slant, and the sides of the thing that it is the face of.
//
// Noise runs along the ray. A face seen at a slant is sharp across, however noisy ranges are, and what belongs to the side of the thing, its front
// edge above all, which the sensor sees more squarely than the face, lies evenly behind it, as far as the plane reaches; feet of what stands on it
// lie before it. Near the front most points may be of the edge, further behind nearly none.
#pragma once

#include <cstdint>
#include <vector>

#include "scenelore/perception/cloud.hpp"
#include "scenelore/perception/plane_fit.hpp"

namespace scenelore::perception {

/// Metres; directions of rays are not exact either.
inline constexpr double kFinestAcross = 0.001;

struct OfFace {
  double probability = 0;
  bool at_front = false;  ///< within six deviations of ranges behind the front of the region
};

/// How likely each point of a region is of the face: a mixture, by how far behind the front of the region a point lies, of a normal
/// distribution across the face and of even ones behind and before it, each seen through the noise of the point (expectation maximisation;
/// Banfield & Raftery 1993, section 2.3, have one even background). `start`: a first guess of the face, near the region's `plane`. `noise`: metres
/// along the ray; the face scatters as that explains where it is seen from, times a scale that is found, `least_scale` at the least. Empty where it is
/// not known of every point from where it was measured.
[[nodiscard]] std::vector<OfFace> points_of_face(const Cloud& cloud, const PlaneFit& plane, const PlaneEquation& start, double noise, double least_scale,
                                                 const std::vector<std::uint32_t>& members);

}  // namespace scenelore::perception
