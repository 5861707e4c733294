// A camera that measures depth by structured light, after the Kinect v1: 640×480 pixels, 57°×43°.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "simulator/sensor.hpp"

namespace scenelore::simulator {
namespace {

constexpr double kFocal = 589.4, kBaseline = 0.075;  // pixels of a 640-pixel line; metres
constexpr double kNearest = 0.5, kFarthest = 8;      // metres of depth
constexpr double kStep = 0.125;   // pixels; the disparity's resolution (Khoshelham and Elberink 2012)
constexpr double kBend = 0.015;   // of the depth, standard deviation of each term of the error at 3 m
constexpr double kReference = 3;  // metres; the depth at which the noise is what the option says

struct Pixel {
  double disparity = 0;  ///< pixels; 0 = hole
  int object = -1, face = -1;
};

class Frame {
 public:
  Frame(const World& world, const SensorPose& pose, double scale)
      : world_(world),
        pose_(pose),
        width_(std::max(1, static_cast<int>(640 / scale))),
        height_(std::max(1, static_cast<int>(480 / scale))),
        focal_(kFocal * width_ / 640),
        turn_(Eigen::AngleAxisd(pose.heading, Vector3d::UnitZ()) * Eigen::AngleAxisd(pose.pitch, Vector3d::UnitY())) {
    if (!world.bends) return;
    Random random(world.seed, 5000);
    for (double& c : bend_) c = kBend * random.normal();
  }

  [[nodiscard]] std::vector<Sample> take();

 private:
  // x forwards, y left, z up in the camera; depth is measured along x.
  [[nodiscard]] Vector3d direction(int column, int row) const {
    return {1, (0.5 * width_ - column - 0.5) / focal_, (0.5 * height_ - row - 0.5) / focal_};
  }
  [[nodiscard]] Random stream(int column, int row, std::uint64_t what) const {
    return Random(world_.seed, (static_cast<std::uint64_t>(pose_.number) << 48) + (what << 40) +
                                   static_cast<std::uint64_t>(row) * 1'000'003U + static_cast<std::uint64_t>(column));
  }
  [[nodiscard]] double bent(double depth, int column, int row) const;
  [[nodiscard]] Pixel look(int column, int row) const;
  [[nodiscard]] Pixel match(int column, int row) const;
  [[nodiscard]] const Pixel& exact(int column, int row) const {
    return pixels_[static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(column)];
  }

  const World& world_;
  SensorPose pose_;
  int width_, height_;
  double focal_;
  Eigen::Matrix3d turn_;
  std::array<double, 6> bend_{};
  std::vector<Pixel> pixels_;
};

// Cameras as they come from the factory are off by a share of the depth that changes smoothly over the picture and grows
// with depth (Teichman, Miller and Thrun 2013, Unsupervised intrinsic calibration of depth sensors via SLAM).
double Frame::bent(double depth, int column, int row) const {
  const double u = (2.0 * column + 1) / width_ - 1, v = (2.0 * row + 1) / height_ - 1;
  const std::array<double, 6> terms{1, u, v, u * u, u * v, v * v};
  double share = 0;
  for (std::size_t i = 0; i < terms.size(); ++i) share += bend_[i] * terms[i];
  return depth * (1 + share * depth / kReference);
}

// The exact disparity of the pixel, or a hole: nothing in range, too little light comes back, or the projector beside
// the camera does not light what the camera sees.
Pixel Frame::look(int column, int row) const {
  Random random = stream(column, row, 0);
  const Vector3d along = direction(column, row);
  const Ray ray{pose_.position, (turn_ * along).normalized()};
  const Hit hit = first_answer(world_, ray, kFarthest * 1.5, random);
  if (hit.shape == nullptr) return {};
  const double straight = (hit.range + world_.bias[static_cast<std::size_t>(hit.shape->surface)]) / along.norm();
  const double depth = bent(straight, column, row);
  const double cosine = incidence(hit, ray), strength = brightness(hit, cosine) * 16 / (hit.range * hit.range);
  if (depth < kNearest || depth > kFarthest || !random.chance(strength / (strength + 0.02)) ||
      cosine < random.between(0.08, 0.2))
    return {};
  const Vector3d point = ray.origin + hit.range * ray.direction,
                 projector = pose_.position + turn_ * Vector3d(0, kBaseline, 0);
  const Vector3d way = projector - point;
  const double distance = way.norm();
  const bool shaded = world_.shapes.cast({point, way / distance}, 2e-3, distance).shape != nullptr;
  return shaded ? Pixel{} : Pixel{kFocal * kBaseline / depth, hit.shape->surface, hit.shape->face};
}

// Matching looks at a window of pixels: what lies in it is averaged, and near an edge either side may win, the nearer
// one more often. A window that is mostly holes matches nothing.
Pixel Frame::match(int column, int row) const {
  Random random = stream(column, row, 1);
  const Pixel& middle = exact(column, row);
  const int reach = 2;
  const int other_column = std::clamp(column + random.integer(-reach, reach), 0, width_ - 1),
            other_row = std::clamp(row + random.integer(-reach, reach), 0, height_ - 1);
  const Pixel& other = exact(other_column, other_row);
  // The front grows over the rear, and into holes, by a pixel or two.
  Pixel base = other.disparity > middle.disparity + 0.5 && random.chance(0.7) ? other : middle;
  if (base.disparity == 0) return {};
  double sum = 0;
  int like = 0, all = 0;
  for (int r = std::max(0, row - reach); r <= std::min(height_ - 1, row + reach); ++r) {
    for (int c = std::max(0, column - reach); c <= std::min(width_ - 1, column + reach); ++c) {
      ++all;
      if (exact(c, r).disparity == 0 || std::abs(exact(c, r).disparity - base.disparity) > 0.5) continue;
      sum += exact(c, r).disparity;
      ++like;
    }
  }
  if (like * 4 < all) return {};
  const double at_reference = world_.noise * kFocal * kBaseline / (kReference * kReference);
  const double noisy = sum / like + at_reference * random.normal();
  // Away from edges a filled hole belongs to what surrounds it; at edges what grew over is a mixed pixel.
  const bool surrounded = like * 4 >= all * 3;
  const double disparity = std::round(noisy / kStep) * kStep;
  if (base.object != middle.object && !surrounded) return {disparity, -1, -1};
  return {disparity, base.object, base.face};
}

std::vector<Sample> Frame::take() {
  pixels_.resize(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
  // Rows are independent: each thread writes its own.
  (void)measure_lines(height_, world_.threads, [&](int row, std::vector<Sample>&) {
    for (int column = 0; column < width_; ++column) {
      pixels_[static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(column)] =
          look(column, row);
    }
  });
  return measure_lines(height_, world_.threads, [&](int row, std::vector<Sample>& samples) {
    for (int column = 0; column < width_; ++column) {
      const Pixel pixel = match(column, row);
      if (pixel.disparity <= 0) continue;
      const double depth = kFocal * kBaseline / pixel.disparity;
      samples.push_back({pose_.position + turn_ * (depth * direction(column, row)), pixel.object, pixel.face});
    }
  });
}

}  // namespace

std::vector<Sample> scan_depth_camera(const World& world, const SensorPose& pose, double scale) {
  return Frame(world, pose, scale).take();
}

}  // namespace scenelore::simulator
