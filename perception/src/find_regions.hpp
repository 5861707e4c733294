// The steps of segmentation, shared by segment() and perceive().
#pragma once

#include "face_model.hpp"
#include "promises.hpp"
#include "scenelore/perception/perceive.hpp"

namespace scenelore::perception {

struct FoundRegions : Settled {
  Limits limits;
  Upright upright;
  double voxel = 0, spacing = 0, noise = 0;  ///< metres
  std::vector<Moments> voxels;               ///< of all points, in the cloud's offsets
};

/// Regions that the face model is asked about at one time.
struct FaceRound {
  std::size_t first = 0;                     ///< regions before this one had been judged before
  std::vector<FaceTraits> traits;            ///< by region
  std::vector<Origin> origins;               ///< by region
  std::vector<std::int32_t> region_of_point; ///< by point of the sample; −1 = none
};

/// All that the face model is asked about, for learning it.
struct FaceQuestions {
  std::vector<std::uint32_t> points;  ///< of the cloud, those in the sample
  std::vector<FaceRound> rounds;
};

/// Everything up to the promises, which hold for the result. Throws Error for a parameter out of range. With `questions`, tells
/// there what the face model was asked about.
[[nodiscard]] FoundRegions find_regions(const Cloud& cloud, const PerceptionOptions& options, FaceQuestions* questions = nullptr);

}  // namespace scenelore::perception
