// The only source that sees OpenCV.
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

#include "scenelore/perception/hull.hpp"

namespace scenelore::perception {

Rectangle minimum_rectangle(std::span<const Eigen::Vector2d> points) {
  Rectangle rectangle;
  std::vector<cv::Point2f> corners;
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& p : points) middle += p / static_cast<double>(points.size());
  // About their middle: OpenCV computes in single precision.
  for (const Eigen::Vector2d& p : points) {
    corners.emplace_back(static_cast<float>(p.x() - middle.x()), static_cast<float>(p.y() - middle.y()));
  }
  if (corners.empty()) return rectangle;
  cv::Point2f box[4];
  const cv::RotatedRect found = cv::minAreaRect(corners);
  found.points(box);
  const Eigen::Vector2d a(box[1].x - box[0].x, box[1].y - box[0].y), b(box[2].x - box[1].x, box[2].y - box[1].y);
  const Eigen::Vector2d& longer = a.norm() >= b.norm() ? a : b;
  rectangle.center = middle + Eigen::Vector2d(found.center.x, found.center.y);
  rectangle.length = std::max(found.size.width, found.size.height);
  rectangle.width = std::min(found.size.width, found.size.height);
  if (longer.norm() > 0) rectangle.along = longer.normalized();
  return rectangle;
}

namespace {

constexpr int kColumns = 640, kRows = 480;  // the paper's bitmap

/// Where the middles of the rows of pixels cross the ring.
void add_crossings(const Ring2& ring, std::vector<std::vector<double>>& crossings) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Eigen::Vector2d &a = ring[i], &b = ring[(i + 1) % ring.size()];
    const double low = std::min(a.y(), b.y()), high = std::max(a.y(), b.y());
    const auto first = static_cast<int>(std::clamp(std::ceil(low - 0.5), 0.0, double(kRows)));
    for (int row = first; row < kRows; ++row) {
      const double y = row + 0.5;
      if (y >= high) break;
      crossings[static_cast<std::size_t>(row)].push_back(a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
    }
  }
}

/// Pixels with centres at i + ½ in [from, to).
int centers_between(double from, double to) {
  const auto first = static_cast<int>(std::ceil(std::clamp(from, 0.0, double(kColumns)) - 0.5));
  const auto last = static_cast<int>(std::ceil(std::clamp(to, 0.0, double(kColumns)) - 0.5));
  return std::max(0, last - first);
}

}  // namespace

double rectangularity(const Outline& outline, const Rectangle& rectangle) {
  if (outline.outer.empty() || !(rectangle.width > 0)) return 0;
  const Eigen::Vector2d across(-rectangle.along.y(), rectangle.along.x());
  std::vector<Ring2> rings{outline.outer};
  rings.insert(rings.end(), outline.holes.begin(), outline.holes.end());
  for (Ring2& ring : rings) {
    for (Eigen::Vector2d& p : ring) {
      const Eigen::Vector2d d = p - rectangle.center;
      p = {(d.dot(rectangle.along) / rectangle.length + 0.5) * kColumns, (d.dot(across) / rectangle.width + 0.5) * kRows};
    }
  }
  std::vector<std::vector<double>> crossings(kRows);
  for (const Ring2& ring : rings) add_crossings(ring, crossings);
  int filled = 0;
  for (std::vector<double>& row : crossings) {
    std::sort(row.begin(), row.end());
    for (std::size_t i = 0; i + 1 < row.size(); i += 2) filled += centers_between(row[i], row[i + 1]);
  }
  return static_cast<double>(filled) / (kColumns * kRows);
}

}  // namespace scenelore::perception
