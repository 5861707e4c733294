// Planes found in a simulated room held against its faces as geometry has them, point by point.
#pragma once

#include <span>

#include "scenelore/perception/cloud.hpp"
#include "simulator/simulate.hpp"

namespace scenelore::experiment {

/// Counts over one or several rooms. Looked for are the faces (simulator/faces.hpp) on which planar objects lie, with 50 points seen and 3 cm wide, three
/// deviations of the noise: of a paper that lies on a desk often just the edge is seen. A door that is flush with its wall is one face with it. A plane is right on any face of 5 cm width with 50 points, the side of a
/// niche or the foot of a screen as well: they are there, though nobody asks for them.
struct SegmentationScore {
  int planes = 0, right = 0;            ///< planes found; those with an IoU of 0.5 with some face
  int faces = 0, found = 0, well = 0;   ///< faces looked for; those with an IoU of 0.5, of 0.8 with some plane
  int split = 0;                        ///< faces of which two planes or more hold a tenth each
  int joined = 0;                       ///< planes of which two faces or more make up a tenth each
  int keyboards = 0, keyboards_found = 0;  ///< with 60 points at least
  std::vector<double> normal_errors;    ///< degrees, of faces found with more than 1,000 points
  SegmentationScore& operator+=(const SegmentationScore& other);
};

/// Points that the simulator made between two faces (instance 0) count for nobody.
[[nodiscard]] SegmentationScore score_segmentation(const simulator::SimulatedScan& scan, const perception::Cloud& cloud,
                                                   const std::vector<std::int32_t>& plane_of_point);

/// For each of `count` regions the IoU with the face that it is most like, over these points of the scan (one region a point, −1 = none);
/// 0 for those like no face that counts as right.
[[nodiscard]] std::vector<double> face_overlaps(const simulator::SimulatedScan& scan, std::span<const std::uint32_t> points,
                                                std::span<const std::int32_t> region_of_point, std::size_t count);

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
