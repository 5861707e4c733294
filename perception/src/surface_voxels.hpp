// What each voxel's neighbourhood looks like, and how noisy the cloud is there.
#pragma once

#include <vector>

#include "voxel_grid.hpp"

namespace scenelore::perception {

/// The plane through the points of the 27 voxels around one voxel.
struct LocalSurface {
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();
  float rmse = 0;       ///< metres, of that plane
  bool planar = false;  ///< enough points, spread in two directions, thin in the third
};

[[nodiscard]] std::vector<LocalSurface> local_surfaces(const VoxelGrid& grid, int threads);

/// Noise by place: range, incidence and material make a glossy screen noisier than the wall behind it, a far wall
/// noisier than a near one. Each block of 8³ voxels gets the lower quartile of its flat neighbourhoods' deviations
/// (clutter and edges only ever raise a deviation), held against the cloud's own typical value.
///
/// Depth cameras round distances to steps that grow with range: small neighbourhoods are then exact planes across the
/// line of sight, stacked centimetres apart. A block where many neighbourhoods are exact although wider ones are not is
/// taken as rounded: its noise is that of the wider ones, and its small neighbourhoods are not believed.
struct NoiseMap {
  std::vector<float> of_voxel;  ///< metres, standard deviation
  std::vector<bool> rounded;    ///< voxels in blocks of rounded distances
  double typical = 0;           ///< metres, median over the flat voxels; 0 when there are none
  double high = 0;              ///< metres, 90th percentile
};

[[nodiscard]] NoiseMap estimate_noise(const VoxelGrid& grid, const std::vector<LocalSurface>& surfaces, int threads);

}  // namespace scenelore::perception
