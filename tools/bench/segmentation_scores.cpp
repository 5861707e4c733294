#include "bench/segmentation_scores.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace scenelore::experiment {
namespace {

/// Sums for the normal of a plane.
struct Spread {
  double n = 0;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();

  void add(const Eigen::Vector3d& p) { n += 1, sum += p, squares += p * p.transpose(); }
  [[nodiscard]] Eigen::Vector3d normal() const {
    const Eigen::Vector3d mean = sum / n;
    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(squares / n - mean * mean.transpose()).eigenvectors().col(0);
  }
};

}  // namespace

SegmentationScore& SegmentationScore::operator+=(const SegmentationScore& o) {
  planes += o.planes, right += o.right, faces += o.faces, found += o.found, well += o.well, split += o.split, joined += o.joined;
  keyboards += o.keyboards, keyboards_found += o.keyboards_found;
  normal_errors.insert(normal_errors.end(), o.normal_errors.begin(), o.normal_errors.end());
  return *this;
}

SegmentationScore score_segmentation(const simulator::SimulatedScan& scan, const perception::Cloud& cloud,
                                     const std::vector<std::int32_t>& plane_of_point) {
  const perception::Column& instance = *scan.points.find("instance");
  std::map<int, const simulator::TruthObject*> face;
  for (const simulator::TruthObject& object : scan.objects) face[object.instance] = &object;
  std::map<int, double> seen;                      // points of each face
  std::map<std::int32_t, Spread> spread;           // of each plane
  std::map<std::int32_t, double> size;             // of each plane, without points of no face
  std::map<std::pair<std::int32_t, int>, double> both;
  for (std::size_t i = 0; i < plane_of_point.size(); ++i) {
    const int object = static_cast<int>(scan.points.value(instance, i));
    const std::int32_t plane = plane_of_point[i];
    if (object > 0) seen[object] += 1;
    if (plane < 0) continue;
    spread[plane].add(cloud.offset(i).cast<double>());
    if (object > 0) size[plane] += 1, both[{plane, object}] += 1;
  }
  SegmentationScore score;
  score.planes = static_cast<int>(spread.size());
  std::map<int, std::pair<double, std::int32_t>> best_of_face;
  std::map<std::int32_t, double> best_of_plane;
  std::map<int, int> pieces;
  std::map<std::int32_t, int> parts;
  for (const auto& [pair, n] : both) {
    const auto [plane, object] = pair;
    const auto at = face.find(object);
    if (at == face.end() || !at->second->planar) continue;
    const double overlap = n / (seen[object] + size[plane] - n);
    best_of_face[object] = std::max(best_of_face[object], {overlap, plane});
    best_of_plane[plane] = std::max(best_of_plane[plane], overlap);
    if (n > 0.1 * seen[object]) ++pieces[object];
    if (n > 0.1 * size[plane]) ++parts[plane];
  }
  for (const auto& [plane, overlap] : best_of_plane) score.right += overlap >= 0.5;
  for (const auto& [plane, count] : parts) score.joined += count > 1;
  for (const auto& [number, object] : face) {
    if (!object->planar) continue;
    const auto [overlap, plane] = best_of_face[number];
    if (object->object_class == "keyboard" && seen[number] >= 60) ++score.keyboards, score.keyboards_found += overlap >= 0.5;
    if (seen[number] < 50) continue;
    ++score.faces;
    score.found += overlap >= 0.5, score.well += overlap >= 0.8, score.split += pieces[number] > 1;
    if (overlap >= 0.5 && seen[number] > 1000) {
      const double cosine = std::min(1.0, std::abs(spread[plane].normal().dot(object->normal)));
      score.normal_errors.push_back(std::acos(cosine) * 180 / std::numbers::pi);
    }
  }
  return score;
}

}  // namespace scenelore::experiment
