// Planes found in a simulated room held against its faces, point by point.
#pragma once

#include "scenelore/perception/cloud.hpp"
#include "simulator/simulate.hpp"

namespace scenelore::experiment {

/// Counts over one or several rooms. A face counts when it is planar and 50 of its points are seen.
struct SegmentationScore {
  int planes = 0, right = 0;            ///< planes found; those with an IoU of 0.5 with some face
  int faces = 0, found = 0, well = 0;   ///< faces; those with an IoU of 0.5, of 0.8 with some plane
  int split = 0;                        ///< faces of which two planes or more hold a tenth each
  int joined = 0;                       ///< planes of which two faces or more make up a tenth each
  int keyboards = 0, keyboards_found = 0;  ///< with 60 points at least
  std::vector<double> normal_errors;    ///< degrees, of faces found with more than 1,000 points
  SegmentationScore& operator+=(const SegmentationScore& other);
};

/// Points that the simulator made between two faces (instance 0) count for nobody.
[[nodiscard]] SegmentationScore score_segmentation(const simulator::SimulatedScan& scan, const perception::Cloud& cloud,
                                                   const std::vector<std::int32_t>& plane_of_point);

/// Labelled instances of a real scan that are planar by their class. One is found at t when the plane that holds most of it
/// holds at least the share t of its points, and at least t of that plane's points on labelled instances are its own.
struct InstanceScore {
  int planes = 0;
  int instances = 0, found = 0, well = 0;  ///< of 300 points at least; found at 0.5, at 0.8
};

/// `table` may have columns `instance` (0 = none) and `label` (ids as in the collection's labels.txt); without them no
/// instance is counted.
[[nodiscard]] InstanceScore score_instances(const perception::PointTable& table, const std::vector<std::int32_t>& plane_of_point);

}  // namespace scenelore::experiment
