// The planar faces of a scene as geometry has them, whatever objects they belong to: what a segmentation can be asked to find.
#pragma once

#include <vector>

#include "simulator/shape.hpp"

namespace scenelore::simulator {

/// Flat shapes that lie in one plane and touch: the floors of a room and of the corridor behind its door, a door leaf that
/// is flush with its wall, the desks of a row.
struct Face {
  Vector3d normal = Vector3d::Zero();  ///< unit; of its largest shape
  double width = 0;                    ///< metres, shorter side of its widest shape
  double area = 0;                     ///< m², of all its shapes; those that overlap count twice
};

/// Two flat shapes are of one face when no corner of either is further than this from the other's plane, their normals
/// differ by less than half a degree, and they come as near to each other as `kFaceGap`. Where a sensor scatters by a centimetre, hundreds
/// of points tell a step of a few millimetres, those of less nothing does.
inline constexpr double kFaceStep = 0.002, kFaceGap = 0.02;  // metres

/// Sets `face` of each shape to the index of its face; −1 for curved ones.
[[nodiscard]] std::vector<Face> number_faces(std::vector<Shape>& shapes);

}  // namespace scenelore::simulator
