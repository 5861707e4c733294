#include "box_row.hpp"

namespace scenelore::rules {

BoxRow::BoxRow(std::span<const Box3> boxes) : size_(boxes.size()) {
  bounds_.reserve(6 * size_);
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    for (const Box3& box : boxes) bounds_.push_back(box.min()[axis]);
    for (const Box3& box : boxes) bounds_.push_back(box.max()[axis]);
  }
}

void BoxRow::put_squared_distances(const Box3& box, double* out) const {
  const double *const x = bounds_.data(), *const y = x + 2 * size_, *const z = y + 2 * size_;
  const Eigen::Vector3d least = box.min(), most = box.max();
  const auto apart = [this](double low, double high, const double* bounds, std::size_t i) {
    const double one = low - bounds[size_ + i], other = bounds[i] - high, away = one < other ? other : one;
    return away < 0 ? 0 : away;
  };
  for (std::size_t i = 0; i < size_; ++i) {
    const double along_x = apart(least.x(), most.x(), x, i), along_y = apart(least.y(), most.y(), y, i), along_z = apart(least.z(), most.z(), z, i);
    out[i] = along_x * along_x + along_y * along_y + along_z * along_z;
  }
}

}  // namespace scenelore::rules
