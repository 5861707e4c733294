// What the sensors share: the room ready for rays, where a sensor stands, and what it measures.
#pragma once

#include <functional>
#include <vector>

#include "simulator/bvh.hpp"
#include "simulator/random.hpp"
#include "simulator/scene.hpp"

namespace scenelore::simulator {

/// A room as the sensors see it. Every ray draws from a stream of its own, named by pose, line and step; hence the
/// result does not depend on the number of threads.
struct World {
  const Bvh& shapes;
  std::uint64_t seed;
  double noise;              ///< metres
  std::vector<double> bias;  ///< metres, of each object
  int threads = 2;
  bool bends = false;        ///< a depth camera's errors change smoothly over its picture
};

struct SensorPose {
  Vector3d position = Vector3d::Zero();
  double heading = 0;  ///< radians about the vertical
  double pitch = 0;    ///< radians, downwards; of the depth camera
  int number = 0;      ///< which of the poses of one simulation
};

struct Sample {
  Vector3d point;
  int object;     ///< index; -1 for a mixed pixel
  int face = -1;  ///< index of the planar face; -1 on curved things, and for a mixed pixel
};

/// Tilting line scanner; `scale` multiplies its angular steps of 0.25 and 0.3 degrees.
[[nodiscard]] std::vector<Sample> scan_lidar(const World& world, const SensorPose& pose, double scale);
/// One frame of a depth camera; `scale` divides its 640×480 pixels along each side.
[[nodiscard]] std::vector<Sample> scan_depth_camera(const World& world, const SensorPose& pose, double scale);

/// First surface that answers: panes of glass let most rays through.
[[nodiscard]] Hit first_answer(const World& world, const Ray& ray, double farthest, Random& random);
/// Cosine of the angle between the ray and the surface's normal, in [0, 1].
[[nodiscard]] double incidence(const Hit& hit, const Ray& ray);
/// Share of the light that comes back to a sensor beside the lamp: an even part and a mirror's lobe 8 degrees wide.
[[nodiscard]] double brightness(const Hit& hit, double cosine);

/// Runs measure(line, samples) for all lines and joins what they append, in the order of the lines.
/// Requires: threads ≥ 1; measure may run for several lines at a time.
[[nodiscard]] std::vector<Sample> measure_lines(int lines, int threads,
                                                const std::function<void(int, std::vector<Sample>&)>& measure);

}  // namespace scenelore::simulator
