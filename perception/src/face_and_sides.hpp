// A face that is seen at a slant, and the sides of the thing that it is the face of.
//
// Noise runs along the ray. A face seen at a slant is sharp across, however noisy ranges are, and what belongs to the side of the thing, its front
// edge above all, which the sensor sees more squarely than the face, lies evenly behind it, as far as the plane reaches; feet of what stands on it
// lie before it. Near the front most points may be of the edge, further behind nearly none.
#pragma once

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <vector>

#include "scenelore/perception/cloud.hpp"
#include "scenelore/perception/plane_fit.hpp"

namespace scenelore::perception {

/// Metres; directions of rays are not exact either.
inline constexpr double kFinestAcross = 0.001;

/// The points of a region as a mixture, by how far behind the front of the region a point lies, of a normal distribution across the face and of even
/// ones behind and before it, each seen through the noise of the point (expectation maximisation; Banfield & Raftery 1993, section 2.3, have
/// one even background).
class FaceAndSides {
 public:
  /// `start`: a first guess of the face, near the region's `plane`. `noise`: metres along the ray; the face scatters as that explains where it is
  /// seen from, times a scale that is found, `least_scale` at the least.
  FaceAndSides(const Cloud& cloud, const PlaneFit& plane, const PlaneEquation& start, double noise, double least_scale,
               const std::vector<std::uint32_t>& members);

  /// Points that it tells of: all members, or none where it is not known of every one from where it was measured.
  [[nodiscard]] std::size_t size() const { return points_.size(); }
  /// How likely the k-th member is of the face.
  [[nodiscard]] double of_face(std::size_t k) const { return parts(points_[k])[kFace]; }
  /// Whether the k-th member lies within six deviations of ranges behind the front of the region.
  [[nodiscard]] bool at_front(std::size_t k) const { return points_[k].step < kFront; }
  /// Of the points, those that are of the face.
  [[nodiscard]] double share() const { return share_; }

 private:
  /// Of the face, of what lies on its far side as the sensor sees it, or of what lies before it.
  enum Part : std::size_t { kFace, kBehind, kBefore, kParts };
  using Shares = std::array<double, kParts>;
  static constexpr std::size_t kSteps = 12;  // of one deviation of ranges each; what is further behind the front is one more
  static constexpr std::size_t kFront = 6;   // steps

  /// A point in the frame of the region's plane.
  struct Seen {
    double u = 0, v = 0, d = 0;  ///< metres; d across the plane
    double towards = 1;          ///< the sign of d on the sensor's side
    double sigma = 0;            ///< of d, by noise
    std::size_t step = 0;        ///< how far behind the front
  };

  void see(const Cloud& cloud, const PlaneFit& plane, double noise, const std::vector<std::uint32_t>& members);
  [[nodiscard]] std::vector<Seen> some() const;
  [[nodiscard]] double before(const Seen& s) const;
  [[nodiscard]] Shares parts(const Seen& s) const;
  double improve(const std::vector<Seen>& points, double least_scale);
  void share_out(const std::array<Shares, kSteps + 1>& held, double points);

  std::vector<Seen> points_;
  Eigen::Vector3d face_ = Eigen::Vector3d::Zero();  // d = face · (1, u, v)
  double scale_ = 1;                                // deviation of the face's points, of their noise
  double behind_ = 0, before_ = 0;                  // how far the region reaches, metres
  double share_ = 0;
  std::array<Shares, kSteps + 1> shares_{};
};

}  // namespace scenelore::perception
