#include "bench/segmentation_scores.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

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

InstanceScore score_instances(const perception::PointTable& table, const std::vector<std::int32_t>& plane_of_point) {
  // wall, floor, ceiling, table, desk, door, whiteboard, bookshelf, cabinet, sofa, counter, column, partition
  static const std::set<int> kPlanar{1, 2, 3, 4, 5, 9, 11, 12, 13, 14, 22, 28, 35};
  constexpr double kFewest = 300;
  InstanceScore score;
  score.planes = static_cast<int>(std::set<std::int32_t>(plane_of_point.begin(), plane_of_point.end()).size());
  if (std::find(plane_of_point.begin(), plane_of_point.end(), -1) != plane_of_point.end()) --score.planes;
  const perception::Column* const instance = table.find("instance");
  const perception::Column* const label = table.find("label");
  if (instance == nullptr || label == nullptr) return score;
  std::map<int, std::map<int, double>> labels;             // of each instance
  std::map<int, std::map<std::int32_t, double>> planes;    // that hold points of each instance
  std::map<std::int32_t, double> labelled;                 // points of each plane on instances
  for (std::size_t i = 0; i < table.rows; ++i) {
    const int object = static_cast<int>(table.value(*instance, i));
    if (object <= 0) continue;
    labels[object][static_cast<int>(table.value(*label, i))] += 1;
    if (plane_of_point[i] >= 0) planes[object][plane_of_point[i]] += 1, labelled[plane_of_point[i]] += 1;
  }
  const auto most = [](const auto& counts) {
    return *std::max_element(counts.begin(), counts.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  };
  for (const auto& [object, of_label] : labels) {
    double points = 0;
    for (const auto& [id, n] : of_label) points += n;
    if (points < kFewest || !kPlanar.contains(most(of_label).first)) continue;
    ++score.instances;
    if (planes[object].empty()) continue;
    const auto [plane, own] = most(planes[object]);
    const double share = std::min(own / points, own / labelled[plane]);
    score.found += share >= 0.5, score.well += share >= 0.8;
  }
  return score;
}

}  // namespace scenelore::experiment
