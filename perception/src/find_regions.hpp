// The steps of segmentation, shared by segment() and perceive().
#pragma once

#include "face_traits.hpp"
#include "promises.hpp"
#include "scenelore/perception/perceive.hpp"

namespace scenelore::perception {

struct FoundRegions : Settled {
  Limits limits;
  Upright upright;
  double voxel = 0, spacing = 0, noise = 0;  ///< metres
  std::vector<Moments> voxels;               ///< of all points, in the cloud's offsets
};

/// The regions that the face model is asked about, for learning it.
struct Unjudged {
  std::vector<FaceTraits> traits;            ///< by region
  Things things;
  std::vector<std::uint32_t> points;         ///< of the cloud, those in the sample
  std::vector<std::int32_t> region_of_point; ///< by point of the sample; −1 = none
};

/// Everything up to the promises, which hold for the result. Throws Error for a parameter out of range. With `unjudged`, tells
/// there what the face model would be asked about, and gives nothing up.
[[nodiscard]] FoundRegions find_regions(const Cloud& cloud, const PerceptionOptions& options, Unjudged* unjudged = nullptr);

}  // namespace scenelore::perception
