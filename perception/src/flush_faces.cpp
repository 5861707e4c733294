#include "flush_faces.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "step_faces.hpp"

namespace scenelore::perception {
namespace {

constexpr double kSmallestWall = 0.5;  // m²
constexpr std::size_t kFewest = 200;   // points
constexpr double kWanted = 8;          // points in a cell
constexpr double kFinest = 0.04;       // metres
constexpr double kMostCells = 6000;
constexpr int kMostFaces = 8;       // of one wall
constexpr double kReach = 4;        // deviations of a plane within which another one takes points from it
constexpr double kParallel = 0.98;  // cosine of 11 degrees
constexpr double kSteep = 0.7;      // cosine to up; flatter ones have no upright sides
constexpr double kPartOf = 0.7;     // of the points of a plane

/// A plane from its front, with the points of other planes that lie within its scatter: where two planes overlap, each
/// has only the points nearer to it, whose means say nothing.
class Front {
 public:
  Front(const Cloud& cloud, const PlaneFit& plane, const std::vector<std::uint32_t>& own, const Eigen::Vector3d& up);

  void add_guests(const PlaneFit& other, const std::vector<std::uint32_t>& points);
  [[nodiscard]] HeightGrid grid(std::span<const float> weight) const;

  /// Of the plane and guests, and the cell of each.
  [[nodiscard]] const std::vector<std::uint32_t>& points() const { return points_; }
  [[nodiscard]] std::size_t cell_of(std::size_t k) const { return cell_of_[k]; }

 private:
  /// Along the plane and over it, metres.
  [[nodiscard]] Eigen::Vector3d at(std::uint32_t i) const {
    const Eigen::Vector3d d = cloud_.offset(i).cast<double>() - plane_.centroid;
    return {u_.dot(d), v_.dot(d), plane_.normal.dot(d)};
  }
  void add(std::uint32_t i, const Eigen::Vector3d& place);
  void make_room(std::size_t points) { points_.reserve(points), cell_of_.reserve(points), height_.reserve(points); }

  const Cloud& cloud_;
  const PlaneFit& plane_;
  Eigen::Vector3d u_, v_;
  HeightGrid empty_;
  Eigen::Vector2d corner_ = Eigen::Vector2d::Constant(1e9);
  std::vector<std::uint32_t> points_, cell_of_;
  std::vector<double> height_;
};

Front::Front(const Cloud& cloud, const PlaneFit& plane, const std::vector<std::uint32_t>& own,
             const Eigen::Vector3d& up)
    : cloud_(cloud), plane_(plane) {
  const double along_up = plane.normal.dot(up);
  v_ = std::abs(along_up) > kSteep ? Eigen::Vector3d(plane.axes.col(2)) : (up - along_up * plane.normal).normalized();
  u_ = v_.cross(plane.normal);
  Eigen::Vector2d high = -corner_;
  for (const std::uint32_t i : own) {
    const Eigen::Vector2d place = at(i).head<2>();
    corner_ = corner_.cwiseMin(place), high = high.cwiseMax(place);
  }
  const Eigen::Vector2d size = high - corner_;
  empty_.edge = std::max({kFinest, std::sqrt(kWanted * plane.spread_area() / static_cast<double>(own.size())),
                          std::sqrt(size.x() * size.y() / kMostCells)});
  empty_.columns = 1 + static_cast<int>(size.x() / empty_.edge),
  empty_.rows = 1 + static_cast<int>(size.y() / empty_.edge);
  make_room(own.size());
  for (const std::uint32_t i : own) add(i, at(i));
}

void Front::add(std::uint32_t i, const Eigen::Vector3d& place) {
  const double x = std::floor((place.x() - corner_.x()) / empty_.edge),
               y = std::floor((place.y() - corner_.y()) / empty_.edge);
  if (x < 0 || y < 0 || x >= empty_.columns || y >= empty_.rows) return;
  points_.push_back(i);
  cell_of_.push_back(static_cast<std::uint32_t>(empty_.at(static_cast<int>(x), static_cast<int>(y))));
  height_.push_back(place.z());
}

void Front::add_guests(const PlaneFit& other, const std::vector<std::uint32_t>& points) {
  const double c = std::abs(other.normal.dot(plane_.normal)), reach = kReach * plane_.rmse();
  if (c < kParallel) return;
  const double leaning = std::sqrt(1 - c * c) * 2 * std::sqrt(other.variances[2]);
  if (std::abs(plane_.normal.dot(other.centroid - plane_.centroid)) > reach + leaning) return;
  const auto guest = [&](std::uint32_t i) { return std::abs(at(i).z()) < reach; };
  make_room(points_.size() + static_cast<std::size_t>(std::count_if(points.begin(), points.end(), guest)));
  for (const std::uint32_t i : points) {
    if (guest(i)) add(i, at(i));
  }
}

HeightGrid Front::grid(std::span<const float> weight) const {
  HeightGrid grid = empty_;
  const auto cells = static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows);
  grid.count.assign(cells, 0.0), grid.height.assign(cells, 0.0);
  std::vector<double> sum(cells, 0.0), squares(cells, 0.0);
  for (std::size_t k = 0; k < points_.size(); ++k) {
    const double w = weight[points_[k]];
    sum[cell_of_[k]] += w, squares[cell_of_[k]] += w * w, grid.height[cell_of_[k]] += w * height_[k];
  }
  for (std::size_t c = 0; c < cells; ++c) {
    // As many points of one weight would scatter as little (Kish 1965, effective sample size).
    if (sum[c] > 0) grid.height[c] /= sum[c], grid.count[c] = sum[c] * sum[c] / squares[c];
  }
  return grid;
}

/// The planes while they are parted.
class Parting {
 public:
  Parting(const Cloud& cloud, std::span<const float> weight, const Eigen::Vector3d& up, Regions& regions)
      : cloud_(cloud), weight_(weight), up_(up), regions_(regions), before_(regions.planes.size()) {
    points_ = points_of_regions(regions.of_point, before_);
  }

  void run();

 private:
  void part(std::size_t r);
  void take_out(const Front& front, const StepFace& face, std::size_t wall);
  [[nodiscard]] bool is_old(std::int32_t r) const { return r >= 0 && static_cast<std::size_t>(r) < before_; }

  const Cloud& cloud_;
  std::span<const float> weight_;  // by point of the cloud
  Eigen::Vector3d up_;
  Regions& regions_;
  std::size_t before_;  // regions
  std::vector<std::vector<std::uint32_t>> points_;
};

/// A region of its own for the points of a face; planes that it holds nearly as a whole are part of it.
void Parting::take_out(const Front& front, const StepFace& face, std::size_t wall) {
  const auto number = static_cast<std::int32_t>(regions_.planes.size());
  std::vector<std::vector<std::uint32_t>> held(before_);
  for (std::size_t k = 0; k < front.points().size(); ++k) {
    const std::uint32_t i = front.points()[k];
    if (const std::int32_t r = regions_.of_point[i]; face.cells[front.cell_of(k)] && is_old(r))
      held[static_cast<std::size_t>(r)].push_back(i);
  }
  for (std::size_t r = 0; r < before_; ++r) {
    if (r != wall && static_cast<double>(held[r].size()) < kPartOf * static_cast<double>(points_[r].size())) continue;
    for (const std::uint32_t i : held[r]) regions_.of_point[i] = number;
  }
  regions_.planes.emplace_back();
}

void Parting::part(std::size_t r) {
  const PlaneFit plane = regions_.planes[r];
  if (points_[r].size() < kFewest || plane.spread_area() < kSmallestWall) return;
  Front front(cloud_, plane, points_[r], up_);
  for (std::size_t q = 0; q < before_; ++q) {
    if (q != r && !points_[q].empty()) front.add_guests(regions_.planes[q], points_[q]);
  }
  StepFaceFinder finder(front.grid(weight_), plane.rmse());
  int faces = 0;
  for (std::optional<StepFace> face = finder.next(); face && faces < kMostFaces; face = finder.next(), ++faces)
    take_out(front, *face, r);
  for (std::size_t q = 0; q < before_ && faces > 0; ++q) {
    std::erase_if(points_[q], [&](std::uint32_t i) { return regions_.of_point[i] != static_cast<std::int32_t>(q); });
  }
}

/// Those with most points first: what lies on a wall is looked for from the wall.
void Parting::run() {
  std::vector<std::size_t> order(before_);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return points_[a].size() > points_[b].size(); });
  for (const std::size_t r : order) part(r);
  if (regions_.planes.size() > before_) refit(cloud_, regions_);
}

}  // namespace

void part_flush_faces(const Cloud& cloud, std::span<const float> weight, const Eigen::Vector3d& up, Regions& regions) {
  Parting(cloud, weight, up, regions).run();
}

}  // namespace scenelore::perception
