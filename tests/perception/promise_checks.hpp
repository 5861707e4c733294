// The promises of a segmentation, checked by brute force on its output.
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <map>
#include <tuple>
#include <vector>

#include "scenelore/perception/cloud.hpp"
#include "scenelore/perception/parameters.hpp"

namespace scenelore::perception::testing {

/// Whether steps of at most `step` connect the points: breadth first over cells of that size, every pair compared.
inline bool connected(const std::vector<Eigen::Vector3d>& points, double step) {
  using Cell = std::tuple<long, long, long>;
  const auto cell = [step](const Eigen::Vector3d& p) {
    return Cell(std::lround(std::floor(p.x() / step)), std::lround(std::floor(p.y() / step)), std::lround(std::floor(p.z() / step)));
  };
  std::map<Cell, std::vector<std::size_t>> waiting;
  for (std::size_t i = 1; i < points.size(); ++i) waiting[cell(points[i])].push_back(i);
  std::vector<std::size_t> open{0};
  std::size_t reached = 1;
  while (!open.empty()) {
    const Eigen::Vector3d p = points[open.back()];
    open.pop_back();
    const auto [x, y, z] = cell(p);
    for (long dx = -1; dx <= 1; ++dx) {
      for (long dy = -1; dy <= 1; ++dy) {
        for (long dz = -1; dz <= 1; ++dz) {
          const auto at = waiting.find(Cell(x + dx, y + dy, z + dz));
          if (at == waiting.end()) continue;
          std::erase_if(at->second, [&](std::size_t i) {
            if ((points[i] - p).norm() > step * (1 + 1e-6)) return false;
            open.push_back(i);
            ++reached;
            return true;
          });
        }
      }
    }
  }
  return reached == points.size();
}

inline void expect_promises(const Cloud& cloud, const SegmentationParameters& p, const std::vector<std::int32_t>& plane_of_point) {
  ASSERT_EQ(plane_of_point.size(), cloud.size());
  ASSERT_TRUE(p.max_point_distance && p.max_plane_distance && p.max_mse && p.min_points && p.max_neighbours);
  std::vector<std::vector<Eigen::Vector3d>> planes;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const std::int32_t plane = plane_of_point[i];
    ASSERT_GE(plane, -1);
    if (plane < 0) continue;
    ASSERT_TRUE(cloud.valid(i));
    if (static_cast<std::size_t>(plane) >= planes.size()) planes.resize(static_cast<std::size_t>(plane) + 1);
    planes[static_cast<std::size_t>(plane)].push_back(cloud.offset(i).cast<double>());
  }
  for (std::size_t k = 0; k < planes.size(); ++k) {
    const auto& points = planes[k];
    ASSERT_GE(points.size(), static_cast<std::size_t>(*p.min_points)) << "plane " << k;
    if (k > 0) {
      EXPECT_LE(points.size(), planes[k - 1].size()) << "planes come by falling point count";
    }
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const auto& q : points) mean += q / static_cast<double>(points.size());
    Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
    for (const auto& q : points) scatter += (q - mean) * (q - mean).transpose() / static_cast<double>(points.size());
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(scatter);
    const Eigen::Vector3d normal = solver.eigenvectors().col(0);
    double furthest = 0;
    for (const auto& q : points) furthest = std::max(furthest, std::abs(normal.dot(q - mean)));
    EXPECT_LE(furthest, *p.max_plane_distance * (1 + 1e-6)) << "plane " << k << " of " << points.size() << " points";
    EXPECT_LE(solver.eigenvalues()[0], *p.max_mse * (1 + 1e-6)) << "plane " << k;
    EXPECT_TRUE(connected(points, *p.max_point_distance)) << "plane " << k << " of " << points.size() << " points";
  }
}

}  // namespace scenelore::perception::testing
