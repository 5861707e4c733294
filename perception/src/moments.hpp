// Ten sums over points are all that fitting and testing planes needs: adding, removing, joining sets of points costs
// the same few additions however many points they hold (Poppinga et al. 2008, incremental plane fit).
#pragma once

#include <Eigen/Core>

#include "scenelore/perception/plane_fit.hpp"

namespace scenelore::perception {

struct Moments {
  double n = 0;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;

  void add(double x, double y, double z) {
    n += 1;
    sum += Eigen::Vector3d(x, y, z);
    xx += x * x, xy += x * y, xz += x * z, yy += y * y, yz += y * z, zz += z * z;
  }
  void add(const Eigen::Vector3d& p) { add(p.x(), p.y(), p.z()); }

  Moments& operator+=(const Moments& o) {
    n += o.n, sum += o.sum;
    xx += o.xx, xy += o.xy, xz += o.xz, yy += o.yy, yz += o.yz, zz += o.zz;
    return *this;
  }
  Moments& operator-=(const Moments& o) {
    n -= o.n, sum -= o.sum;
    xx -= o.xx, xy -= o.xy, xz -= o.xz, yy -= o.yy, yz -= o.yz, zz -= o.zz;
    return *this;
  }

  Moments& operator*=(double weight) {
    n *= weight, sum *= weight;
    xx *= weight, xy *= weight, xz *= weight, yy *= weight, yz *= weight, zz *= weight;
    return *this;
  }

  /// Requires n > 0.
  [[nodiscard]] Eigen::Vector3d mean() const { return sum / n; }
  [[nodiscard]] Eigen::Matrix3d covariance() const;
  [[nodiscard]] double mean_distance(const PlaneEquation& plane) const { return plane.normal.dot(sum) / n - plane.offset; }
  /// Mean squared distance of the points to any plane, from the sums alone; not negative.
  [[nodiscard]] double mean_squared_distance(const PlaneEquation& plane) const;
};

/// Total least squares; accurate, for the planes themselves. Zero points give the default plane with count 0.
[[nodiscard]] PlaneFit fit_plane(const Moments& moments);

/// What judging a neighbourhood needs: normal, smallest and middle eigenvalue of the covariance. Newton's method from
/// below finds the smallest root of the characteristic polynomial of a flat set in a few steps, without trigonometry.
/// Points on a line give some normal across it; equal points give z.
struct FlatFit {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  double across = 0, along = 0;  ///< m²
};
[[nodiscard]] FlatFit fit_flat(const Moments& moments);

/// fit_plane() by the closed form of the eigenvalues: several times faster, good to about 1e-8 of the extent squared.
[[nodiscard]] PlaneFit fit_plane_fast(const Moments& moments);

}  // namespace scenelore::perception
