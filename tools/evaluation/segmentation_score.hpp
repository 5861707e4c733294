// Planes found held against faces that are there, point by point.
#pragma once

#include <cstdint>
#include <vector>

#include "evaluation/scene_truth.hpp"

namespace scenelore::evaluation {

/// Counts at one threshold. Planar objects with at least `kFewestPoints` points count; of planes, those of which at least
/// half of the points are known. Sizes of planes leave out points that are not known.
struct SegmentationScore {
  double threshold = 0.5;
  int planes = 0, faces = 0;
  /// Pairs of a plane and a face whose intersection over union reaches the threshold (each in one pair at most when it is
  /// above 0.5): found faces, right planes.
  int found = 0, right = 0;
  /// Hoover et al. 1996, An experimental comparison of range image segmentation algorithms, section 5, threshold T: correct
  /// (overlap ≥ T of both), over-segmented (a face that several planes make up), under-segmented (a plane that
  /// joins several faces: counted in faces), missed faces, noise planes. Each region has one verdict, of several the one with the
  /// highest mean overlap.
  int correct = 0, over = 0, under = 0, missed = 0, noise = 0;

  SegmentationScore& operator+=(const SegmentationScore& other);
  [[nodiscard]] double precision() const;  ///< right / planes; 0 without planes
  [[nodiscard]] double recall() const;     ///< found / faces
};

inline constexpr std::size_t kFewestPoints = 50;

/// `plane_of_point` numbers planes from 0, −1 = none; as long as the truth.
[[nodiscard]] SegmentationScore score_segmentation(const SceneTruth& truth, const std::vector<std::int32_t>& plane_of_point,
                                                   double threshold);

}  // namespace scenelore::evaluation
