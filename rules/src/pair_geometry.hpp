// Geometry between the planes of a scene, each answer computed once: what `geometry` offers to Lua.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "known_ranges.hpp"
#include "plane_shape.hpp"
#include "scenelore/rules/rule_set.hpp"

namespace scenelore::rules {

/// Indices are those of the planes given. Answers are cached: threads may ask at the same time, once all shapes are prepared, as long as no two
/// of them ask about pairs with the same smaller index.
class PairGeometry {
 public:
  /// The planes must live as long as they are asked about; a shape is prepared when it is first needed.
  explicit PairGeometry(const std::vector<perception::Plane>& planes) : planes_(&planes) { grow(); }

  [[nodiscard]] int size() const { return static_cast<int>(planes_->size()); }
  /// Prepares all shapes that are not prepared yet.
  void prepare(int threads) const;
  [[nodiscard]] const PlaneShape& shape(int i) const;

  /// Degrees between the two planes, 0 (parallel) to 90; the side a normal points to does not matter.
  [[nodiscard]] double angle(int a, int b);
  /// Metres, smallest distance of the hulls; see hull_gap.
  [[nodiscard]] double gap(int a, int b, const Limits& limits = {});
  /// See footprint_share.
  [[nodiscard]] double footprint_overlap(int a, int b, double reach, const Limits& limits = {});
  /// Metres from the top of b up to the lowest point of a; negative when b reaches above a's lower edge.
  [[nodiscard]] double vertical_gap(int a, int b) const;
  /// Metres from a's centroid to the endless plane of b, ≥ 0.
  [[nodiscard]] double plane_distance(int a, int b) const;
  /// The same with a sign: positive on the side to which b's normal points.
  [[nodiscard]] double side(int a, int b) const;
  /// Metres between the centroids.
  [[nodiscard]] double centroid_distance(int a, int b) const;

  /// The answers that took long (gap, footprint_overlap), sorted, as bytes for a later run over the same planes.
  [[nodiscard]] std::string answers() const;
  /// Takes such bytes over; what cannot be read is left out.
  void remember(std::string_view answers);
  /// Whether more is known than was remembered.
  [[nodiscard]] bool has_news() const;

 private:
  /// Of the pairs of which one plane has the smaller index.
  struct Known {
    KnownRanges ranges;
    std::vector<double> angles;  ///< by how much greater the other index is: several relations ask for each
    bool has_news = false;
  };

  template <typename Compute>
  double known_or(const KnownRanges::Key& key, const Limits& limits, Compute compute);
  /// To the number of planes: those of a test file come one by one.
  void grow();

  const std::vector<perception::Plane>* planes_;
  mutable std::vector<std::unique_ptr<PlaneShape>> shapes_;
  std::vector<Known> known_;  // by the smaller index
};

/// Boxes around the planes' outlines.
[[nodiscard]] std::vector<Box3> boxes_of(const std::vector<perception::Plane>& planes);

using Pairs = std::vector<std::pair<int, int>>;  ///< i < j, rising

/// Pairs whose boxes are at most `within` metres apart, and at most `within_plan` seen from above; infinite = no limit. One list
/// for each of `reaches`, all in one go.
[[nodiscard]] std::vector<Pairs> pairs_in_reach(const std::vector<Box3>& boxes, std::span<const Reach> reaches);
[[nodiscard]] Pairs pairs_in_reach(const std::vector<Box3>& boxes, double within, double within_plan);

/// Whether one pair is within reach in that sense.
[[nodiscard]] bool in_reach(const Box3& a, const Box3& b, double within, double within_plan);

}  // namespace scenelore::rules
