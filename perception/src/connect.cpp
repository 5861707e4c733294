#include "connect.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "cell_index.hpp"
#include "disjoint_sets.hpp"

namespace scenelore::perception {
namespace {

/// Square cells in the plane, so small that all points of a cell lie within one step of each other although the points
/// scatter by ±spread across the plane: 2 c² + (2 spread)² ≤ step².
double cell_size(double step, double spread) {
  const double across = std::min(2 * spread, 0.9 * step);
  return std::sqrt((step * step - across * across) / 2);
}

class Connector {
 public:
  Connector(const Cloud& cloud, std::span<const std::uint32_t> points, const PlaneFit& plane, double step, std::size_t max_neighbours)
      : cloud_(cloud), points_(points), step_(step), most_(std::max<std::size_t>(1, max_neighbours)) {
    double spread = 0;
    for (const std::uint32_t i : points) spread = std::max(spread, std::abs(plane.distance(cloud.offset(i).cast<double>())));
    const double size = cell_size(step_, spread);
    // Scatter of the same order as the step: cells in all three directions.
    const bool flat = 2 * spread <= 0.9 * step_;
    std::vector<CellKey> keys(points.size());
    for (std::size_t k = 0; k < points.size(); ++k) {
      const Eigen::Vector3d d = plane.axes.transpose() * (cloud.offset(points[k]).cast<double>() - plane.centroid);
      keys[k] = flat ? place(d[1] / size, d[2] / size, 0) : place(d[1] * 2 / step_, d[2] * 2 / step_, d[0] * 2 / step_);
    }
    reach_ = flat ? static_cast<int>(std::ceil(step_ / size)) : 2;
    depth_ = flat ? 0 : 2;
    cells_ = CellIndex(keys);
    sets_ = DisjointSets(cells_.size());
    for (std::size_t direction = 0; direction < outwards_.size(); ++direction) {
      const double angle = static_cast<double>(direction) * std::numbers::pi / 4;
      outwards_[direction] = (std::cos(angle) * plane.axes.col(1) + std::sin(angle) * plane.axes.col(2)).cast<float>();
    }
    choose_speakers();
  }

  std::vector<std::vector<std::uint32_t>> parts() {
    // Adjacent cells first: they join nearly everything, and what is joined already need not be compared.
    for (int ring = 1; ring <= reach_; ++ring) {
      for (std::size_t c = 0; c < cells_.size(); ++c) join_ring(c, ring);
    }
    std::vector<std::vector<std::uint32_t>> result;
    std::vector<std::int32_t> part(cells_.size(), -1);
    for (std::size_t k = 0; k < points_.size(); ++k) {
      if (cells_.cell_of(k) < 0) continue;
      const auto root = sets_.root(static_cast<std::uint32_t>(cells_.cell_of(k)));
      if (part[root] < 0) {
        part[root] = static_cast<std::int32_t>(result.size());
        result.emplace_back();
      }
      result[static_cast<std::size_t>(part[root])].push_back(points_[k]);
    }
    std::stable_sort(result.begin(), result.end(), [](const auto& a, const auto& b) { return a.size() > b.size(); });
    return result;
  }

 private:
  /// Points more than a million cells from the centroid cannot be compared and are left out.
  static CellKey place(double x, double y, double z) {
    constexpr auto limit = static_cast<double>(kCellLimit);
    if (std::max({std::abs(x), std::abs(y), std::abs(z)}) >= limit) return kNoCell;
    const auto cell = [](double a) { return static_cast<std::int64_t>(std::floor(a)); };
    return cell_key(cell(x), cell(y), cell(z));
  }

  void join_ring(std::size_t c, int ring) {
    for (int dx = -ring; dx <= ring; ++dx) {
      for (int dy = -ring; dy <= ring; ++dy) {
        for (int dz = -std::min(ring, depth_); dz <= std::min(ring, depth_); ++dz) {
          if (std::max({std::abs(dx), std::abs(dy), std::abs(dz)}) != ring) continue;
          const std::int32_t other = cells_.find(moved(cells_.key(c), dx, dy, dz));
          if (other <= static_cast<std::int32_t>(c)) continue;
          const auto a = static_cast<std::uint32_t>(c), b = static_cast<std::uint32_t>(other);
          if (sets_.root(a) != sets_.root(b) && within_step(c, b)) sets_.join(a, b);
        }
      }
    }
  }

  /// Some of the points of each cell, or all where there are few.
  void choose_speakers() {
    speakers_.resize(cells_.size());
    const std::size_t between = most_ > 16 ? most_ - 8 : most_ / 2;
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      const auto items = cells_.items(c);
      std::vector<std::uint32_t>& chosen = speakers_[c];
      if (items.size() <= most_) {
        chosen.assign(items.begin(), items.end());
      } else {
        for (std::size_t k = 0; k < between; ++k) chosen.push_back(items[k * items.size() / between]);
      }
    }
  }

  /// Adds the points of a cell that lie furthest out in eight directions: where two cells come near each other, some of these do. False where
  /// there are no more.
  bool add_outermost(std::size_t c) {
    const auto items = cells_.items(c);
    std::vector<std::uint32_t>& chosen = speakers_[c];
    if (items.size() <= most_ || chosen.size() >= most_) return false;
    for (std::size_t direction = 0; direction < outwards_.size() && chosen.size() < most_; ++direction) {
      const auto out = [&](std::uint32_t k) { return outwards_[direction].dot(cloud_.offset(points_[k])); };
      std::uint32_t furthest = items.front();
      float most = out(furthest);
      for (const std::uint32_t k : items.subspan(1)) {
        const float here = out(k);
        if (most < here) most = here, furthest = k;
      }
      chosen.push_back(furthest);
    }
    return true;
  }

  /// Most cells are within a step by any of their points; only where they are not the outermost ones are looked for.
  bool within_step(std::size_t a, std::size_t b) {
    if (speakers_within_step(a, b)) return true;
    const bool more_of_a = add_outermost(a), more_of_b = add_outermost(b);
    return (more_of_a || more_of_b) && speakers_within_step(a, b);
  }

  bool speakers_within_step(std::size_t a, std::size_t b) const {
    const auto limit = static_cast<float>(step_ * step_);
    for (const std::uint32_t i : speakers_[a]) {
      const Eigen::Vector3f p = cloud_.offset(points_[i]);
      for (const std::uint32_t j : speakers_[b]) {
        if ((cloud_.offset(points_[j]) - p).squaredNorm() <= limit) return true;
      }
    }
    return false;
  }

  const Cloud& cloud_;
  std::span<const std::uint32_t> points_;
  double step_;
  std::size_t most_;
  int reach_ = 1, depth_ = 0;
  std::array<Eigen::Vector3f, 8> outwards_;
  CellIndex cells_;
  std::vector<std::vector<std::uint32_t>> speakers_;  ///< by cell
  DisjointSets sets_{0};  ///< of cells
};

}  // namespace

std::vector<std::vector<std::uint32_t>> connected_parts(const Cloud& cloud, std::span<const std::uint32_t> points, const PlaneFit& plane,
                                                        double step, std::size_t max_neighbours) {
  if (points.empty()) return {};
  return Connector(cloud, points, plane, step, max_neighbours).parts();
}

}  // namespace scenelore::perception
