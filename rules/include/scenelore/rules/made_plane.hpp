// Made-up rectangular planes: what tests of rules and the checks of `rules check` ask relations about.
#pragma once

#include <Eigen/Core>

#include "scenelore/perception/plane.hpp"
#include "scenelore/rules/scene.hpp"

namespace scenelore::rules {

/// A rectangle in the upright frame.
struct MadePlane {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< any length but 0
  double length = 1, width = 1;                       ///< metres; length is along `along`
  Eigen::Vector3d along = Eigen::Vector3d::Zero();    ///< direction of the length; zero: level, along x where flat
  double rmse = 0;                                    ///< metres
};

/// All fields of a Plane as perception would find them on a fully seen rectangle.
[[nodiscard]] perception::Plane make_plane(const MadePlane& made);

/// Planes numbered from 1, without further features.
[[nodiscard]] Scene make_scene(const std::vector<MadePlane>& planes);

}  // namespace scenelore::rules
