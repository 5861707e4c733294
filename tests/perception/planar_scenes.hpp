// Clouds of known planes for tests.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "scenelore/perception/cloud.hpp"

namespace scenelore::perception::testing {

/// SplitMix64 and Box–Muller: the same numbers with every library.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  double uniform() {  // [0, 1)
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15ULL);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1.0p-53;
  }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  double normal() { return std::sqrt(-2 * std::log(1 - uniform())) * std::cos(2 * std::numbers::pi * uniform()); }

 private:
  std::uint64_t state_;
};

/// Collects points with the number of the plane they were made from.
struct Scene {
  Cloud cloud;
  std::vector<int> truth;  ///< −1 = on no plane

  void add(const Eigen::Vector3d& p, int plane) {
    const Eigen::Vector3f q = (p - cloud.origin).cast<float>();
    cloud.x.push_back(q.x()), cloud.y.push_back(q.y()), cloud.z.push_back(q.z());
    if (!cloud.valid(cloud.size() - 1)) ++cloud.invalid;
    truth.push_back(plane);
  }

  /// Evenly random points of the parallelogram at `corner` with sides a and b, with Gaussian noise along the normal.
  void add_rectangle(const Eigen::Vector3d& corner, const Eigen::Vector3d& a, const Eigen::Vector3d& b, double per_m2, double noise,
                     int plane, Random& random) {
    const Eigen::Vector3d normal = a.cross(b);
    const auto count = static_cast<int>(per_m2 * normal.norm());
    for (int i = 0; i < count; ++i) {
      add(corner + random.uniform() * a + random.uniform() * b + noise * random.normal() * normal.normalized(), plane);
    }
  }

  Scene moved(const Eigen::Isometry3d& motion) const {
    Scene result;
    for (std::size_t i = 0; i < cloud.size(); ++i) result.add(motion * cloud.position(i), truth[i]);
    return result;
  }
};

/// Floor 0, ceiling 1, four walls 2 to 5, a table top 6 at 0.74 m.
inline Scene room(double noise, double per_m2 = 2500, std::uint64_t seed = 1) {
  Scene scene;
  Random random(seed);
  using V = Eigen::Vector3d;
  scene.add_rectangle(V(0, 0, 0), V(4, 0, 0), V(0, 3, 0), per_m2, noise, 0, random);
  scene.add_rectangle(V(0, 0, 2.5), V(4, 0, 0), V(0, 3, 0), per_m2, noise, 1, random);
  scene.add_rectangle(V(0, 0, 0), V(4, 0, 0), V(0, 0, 2.5), per_m2, noise, 2, random);
  scene.add_rectangle(V(0, 3, 0), V(4, 0, 0), V(0, 0, 2.5), per_m2, noise, 3, random);
  scene.add_rectangle(V(0, 0, 0), V(0, 3, 0), V(0, 0, 2.5), per_m2, noise, 4, random);
  scene.add_rectangle(V(4, 0, 0), V(0, 3, 0), V(0, 0, 2.5), per_m2, noise, 5, random);
  scene.add_rectangle(V(1, 1, 0.74), V(1.6, 0, 0), V(0, 0.8, 0), per_m2, noise, 6, random);
  return scene;
}

/// Intersection over union of each true plane with the found plane that fits it best.
inline std::vector<double> best_overlaps(const Scene& scene, const std::vector<std::int32_t>& found, int planes) {
  std::int32_t most = -1;
  for (const std::int32_t f : found) most = std::max(most, f);
  const auto width = static_cast<std::size_t>(most + 1);
  std::vector<double> truths(static_cast<std::size_t>(planes), 0), sizes(width, 0), both(static_cast<std::size_t>(planes) * width, 0);
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (scene.truth[i] >= 0) ++truths[static_cast<std::size_t>(scene.truth[i])];
    if (found[i] >= 0) ++sizes[static_cast<std::size_t>(found[i])];
    if (scene.truth[i] >= 0 && found[i] >= 0) ++both[static_cast<std::size_t>(scene.truth[i]) * width + static_cast<std::size_t>(found[i])];
  }
  std::vector<double> best(truths.size(), 0);
  for (std::size_t t = 0; t < truths.size(); ++t) {
    for (std::size_t f = 0; f < width; ++f) best[t] = std::max(best[t], both[t * width + f] / (truths[t] + sizes[f] - both[t * width + f]));
  }
  return best;
}

}  // namespace scenelore::perception::testing
