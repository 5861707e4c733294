// What tells a planar face from clutter, from a sliver of a larger face and from two faces under one plane: measured of each
// region, judged by face_model.hpp.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "slots.hpp"
#include "surface_voxels.hpp"

namespace scenelore::perception {

enum class Trait : std::uint8_t {
  points,     ///< log10 of their number
  area,       ///< log10 of the m² that they spread over
  length,     ///< log10 of how many times as far they spread along as across
  thickness,  ///< deviation over the spread across; at least 0.04
  roughness,  ///< deviation over the noise of the place; at least 0.9
  agreeing,   ///< share of the points whose 15 cm surroundings lie like the region
  unevenness, ///< log10 of (1 + mean squared deviation of voxel means, in units of what chance allows); at least 0.3
  fill,       ///< area of its voxels over that of the rectangle that it spreads over, a voxel larger each way since the rim takes whole ones
  layer,      ///< distance from larger, almost parallel planes before or behind it, mean of its voxels: in their deviations; of what was found as a
              ///< thing on a plane in centimetres; 8 = far, or none
  contact,    ///< share of its border voxels that go on into another region at a slope
  left,       ///< share of the points in its voxels that no plane explains
  foreign,    ///< share of the points in its voxels that are other planes'
  tilt,       ///< degrees between it and level, 0 to 90: what people build is level or upright
  slant,      ///< mean cosine between its normal and the rays to its points; NaN where it is not known from where they were measured
  excess,     ///< log10 of its deviation over the noise of a range, as much of it as lies across at this slant; NaN as for slant
  bend,       ///< log10 of (1 + what a surface of second degree explains of its voxel means beyond a flat one, in units of what chance allows)
  tails,      ///< log10 of its deviation over the robust one (regions.hpp): of two layers it is more than of one
  square,     ///< share of its border voxels that touch a region at 75 degrees or more: boxes, shelves and rooms have such edges
  turned,     ///< degrees between its horizontal direction and that of most walls, 0 to 45: what people build stands square
};
inline constexpr std::size_t kTraits = 19;
using FaceTraits = std::array<double, kTraits>;

/// Numbers of the regions that one step made.
struct RegionRange {
  std::size_t first = 0, end = 0;
  [[nodiscard]] bool hold(std::size_t region) const { return region >= first && region < end; }
};

/// From where regions are judged.
struct View {
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  double noise = 0;           ///< of a range, metres
  std::vector<double> slant;    ///< by region, see Trait::slant; shorter = not known of the rest
  std::vector<double> scatter;  ///< by region, metres, robust deviation; shorter = as the deviation of the rest
};

/// One row a region; zeros for those without points and those before `first`. `things` are those that thin_objects.hpp made. `noise_of_region`: metres, see merge.hpp.
[[nodiscard]] std::vector<FaceTraits> face_traits(const VoxelGrid& grid, const std::vector<LocalSurface>& surfaces,
                                                  const std::vector<double>& noise_of_region, const Slots& slots, const std::vector<PlaneFit>& planes,
                                                  const View& view, const RegionRange& things = {}, std::size_t first = 0, int threads = 1);

}  // namespace scenelore::perception
