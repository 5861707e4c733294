// Boxes side by side, so that one box is compared with many at once.
#pragma once

#include <Eigen/Geometry>

#include <span>
#include <vector>

namespace scenelore::rules {

using Box3 = Eigen::AlignedBox3d;

class BoxRow {
 public:
  BoxRow() = default;
  explicit BoxRow(std::span<const Box3> boxes);

  [[nodiscard]] std::size_t size() const { return size_; }
  /// Of each from `box`, squared; 0 where they meet. `out` has one place for each.
  void put_squared_distances(const Box3& box, double* out) const;

 private:
  std::size_t size_ = 0;
  std::vector<double> bounds_;  // all least x, then all greatest x, then those of y and z
};

}  // namespace scenelore::rules
