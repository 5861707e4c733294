// Moments in whole numbers: sums of them do not depend on the order of the points or on how they were shared between
// threads, and what is taken away again leaves exactly what would be there without it.
#pragma once

#include <cstdint>

#include "moments.hpp"

namespace scenelore::perception {

/// Coordinates are counted in 2^14 steps an edge of the voxel, from its lower corner. 3 µm at 5 cm.
inline constexpr int kFixedBits = 14;
inline constexpr std::int32_t kFixedSteps = 1 << kFixedBits;

/// Up to 2^35 points: squares take 28 bits.
struct FixedMoments {
  std::int64_t n = 0, x = 0, y = 0, z = 0, xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;

  void add(std::int32_t px, std::int32_t py, std::int32_t pz) {
    n += 1, x += px, y += py, z += pz;
    xx += px * px, xy += px * py, xz += px * pz, yy += py * py, yz += py * pz, zz += pz * pz;
  }
  FixedMoments& operator+=(const FixedMoments& o) {
    n += o.n, x += o.x, y += o.y, z += o.z;
    xx += o.xx, xy += o.xy, xz += o.xz, yy += o.yy, yz += o.yz, zz += o.zz;
    return *this;
  }
  FixedMoments& operator-=(const FixedMoments& o) {
    n -= o.n, x -= o.x, y -= o.y, z -= o.z;
    xx -= o.xx, xy -= o.xy, xz -= o.xz, yy -= o.yy, yz -= o.yz, zz -= o.zz;
    return *this;
  }
};

/// In metres about the origin of the coordinates. A step's points count with its middle.
[[nodiscard]] inline Moments to_moments(const FixedMoments& f, const Eigen::Vector3d& corner, double step) {
  Moments m;
  if (f.n == 0) return m;
  const Eigen::Vector3d o = corner + Eigen::Vector3d::Constant(step / 2);
  const Eigen::Vector3d s = step * Eigen::Vector3d(static_cast<double>(f.x), static_cast<double>(f.y), static_cast<double>(f.z));
  const double n = static_cast<double>(f.n), q = step * step;
  m.n = n;
  m.sum = s + n * o;
  m.xx = q * static_cast<double>(f.xx) + 2 * o.x() * s.x() + n * o.x() * o.x();
  m.yy = q * static_cast<double>(f.yy) + 2 * o.y() * s.y() + n * o.y() * o.y();
  m.zz = q * static_cast<double>(f.zz) + 2 * o.z() * s.z() + n * o.z() * o.z();
  m.xy = q * static_cast<double>(f.xy) + o.x() * s.y() + o.y() * s.x() + n * o.x() * o.y();
  m.xz = q * static_cast<double>(f.xz) + o.x() * s.z() + o.z() * s.x() + n * o.x() * o.z();
  m.yz = q * static_cast<double>(f.yz) + o.y() * s.z() + o.z() * s.y() + n * o.y() * o.z();
  return m;
}

}  // namespace scenelore::perception
