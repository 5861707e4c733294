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

namespace {

constexpr std::size_t kFewestSeen = 50, kFewestOfKeyboard = 60;  // points
constexpr double kNarrowest = 0.05, kThinnest = 0.03;            // metres; of what nobody looks for, and of what is looked for

/// What is known of each face.
struct FaceTruth {
  const simulator::TruthFace* face = nullptr;
  bool wanted = false, keyboard = false;
  [[nodiscard]] bool looked_for() const { return wanted && face->width >= kThinnest; }
  [[nodiscard]] bool accepted() const { return wanted || (face->points >= kFewestSeen && face->width >= kNarrowest); }
};

/// The face of an object is the one that most of its points are on.
std::vector<FaceTruth> face_truth(const simulator::SimulatedScan& scan) {
  const perception::Column& instance = *scan.points.find("instance");
  std::map<int, std::map<std::int32_t, std::size_t>> faces_of;  // of each object
  for (std::size_t i = 0; i < scan.face_of_point.size(); ++i) {
    const int object = static_cast<int>(scan.points.value(instance, i));
    if (object > 0 && scan.face_of_point[i] >= 0) ++faces_of[object][scan.face_of_point[i]];
  }
  std::vector<FaceTruth> truth(scan.faces.size());
  for (std::size_t f = 0; f < truth.size(); ++f) truth[f].face = &scan.faces[f];
  for (const simulator::TruthObject& object : scan.objects) {
    const auto& counts = faces_of[object.instance];
    if (!object.planar || counts.empty()) continue;
    const auto most = std::max_element(counts.begin(), counts.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    FaceTruth& face = truth[static_cast<std::size_t>(most->first)];
    face.wanted = face.wanted || face.face->points >= kFewestSeen;
    face.keyboard = face.keyboard || (object.object_class == "keyboard" && face.face->points >= kFewestOfKeyboard);
  }
  return truth;
}

}  // namespace

SegmentationScore score_segmentation(const simulator::SimulatedScan& scan, const perception::Cloud& cloud,
                                     const std::vector<std::int32_t>& plane_of_point) {
  const perception::Column& instance = *scan.points.find("instance");
  const std::vector<FaceTruth> truth = face_truth(scan);
  std::map<std::int32_t, Spread> spread;           // of each plane
  std::map<std::int32_t, double> size;             // of each plane, without mixed pixels
  std::map<std::pair<std::int32_t, std::int32_t>, double> both;
  for (std::size_t i = 0; i < plane_of_point.size(); ++i) {
    const std::int32_t plane = plane_of_point[i];
    if (plane < 0) continue;
    spread[plane].add(cloud.offset(i).cast<double>());
    if (scan.points.value(instance, i) > 0) size[plane] += 1;
    if (scan.face_of_point[i] >= 0) both[{plane, scan.face_of_point[i]}] += 1;
  }
  SegmentationScore score;
  score.planes = static_cast<int>(spread.size());
  std::vector<std::pair<double, std::int32_t>> best_of_face(truth.size(), {0.0, -1});
  std::map<std::int32_t, double> best_of_plane;
  std::vector<int> pieces(truth.size(), 0);
  std::map<std::int32_t, int> parts;
  for (const auto& [pair, n] : both) {
    const auto [plane, f] = pair;
    const FaceTruth& face = truth[static_cast<std::size_t>(f)];
    const auto seen = static_cast<double>(face.face->points);
    const double overlap = n / (seen + size[plane] - n);
    auto& best = best_of_face[static_cast<std::size_t>(f)];
    best = std::max(best, {overlap, plane});
    if (face.accepted()) best_of_plane[plane] = std::max(best_of_plane[plane], overlap);
    if (n > 0.1 * seen) ++pieces[static_cast<std::size_t>(f)];
    if (face.accepted() && n > 0.1 * size[plane]) ++parts[plane];
  }
  for (const auto& [plane, overlap] : best_of_plane) score.right += overlap >= 0.5;
  for (const auto& [plane, count] : parts) score.joined += count > 1;
  for (std::size_t f = 0; f < truth.size(); ++f) {
    if (!truth[f].looked_for()) continue;
    const auto [overlap, plane] = best_of_face[f];
    if (truth[f].keyboard) ++score.keyboards, score.keyboards_found += overlap >= 0.5;
    ++score.faces;
    score.found += overlap >= 0.5, score.well += overlap >= 0.8, score.split += pieces[f] > 1;
    if (overlap >= 0.5 && truth[f].face->points > 1000) {
      const double cosine = std::min(1.0, std::abs(spread[plane].normal().dot(truth[f].face->normal)));
      score.normal_errors.push_back(std::acos(cosine) * 180 / std::numbers::pi);
    }
  }
  return score;
}

std::vector<double> face_overlaps(const simulator::SimulatedScan& scan, std::span<const std::uint32_t> points,
                                  std::span<const std::int32_t> region_of_point, std::size_t count) {
  const perception::Column& instance = *scan.points.find("instance");
  const std::vector<FaceTruth> truth = face_truth(scan);
  std::vector<double> seen(truth.size(), 0), size(count, 0);
  std::map<std::pair<std::int32_t, std::int32_t>, double> both;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const std::int32_t face = scan.face_of_point[points[k]], region = region_of_point[k];
    if (face >= 0) seen[static_cast<std::size_t>(face)] += 1;
    if (region < 0 || !(scan.points.value(instance, points[k]) > 0)) continue;
    size[static_cast<std::size_t>(region)] += 1;
    if (face >= 0) both[{region, face}] += 1;
  }
  std::vector<double> best(count, 0);
  for (const auto& [pair, n] : both) {
    const auto region = static_cast<std::size_t>(pair.first), face = static_cast<std::size_t>(pair.second);
    if (truth[face].accepted()) best[region] = std::max(best[region], n / (seen[face] + size[region] - n));
  }
  return best;
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
