// A line scanner on a tilt unit, after the Hokuyo UTM-30LX: 270 degrees a line, range 0.1 to 30 m.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "simulator/sensor.hpp"

namespace scenelore::simulator {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kFirstTilt = -60 * kDegree, kLastTilt = 75 * kDegree;  // upwards, downwards
constexpr double kNearest = 0.1, kFarthest = 30;                        // metres
constexpr double kFootprint =
    0.0045;  // half the beam's angle, radians; the data sheet's spot is 0.4 m wide at 30 m, its bright part less
constexpr double kPulse = 1.5;   // metres; echoes closer than this run into one another
constexpr double kMixing = 0.6;  // how often such echoes are measured as one, between the two

struct Reading {
  double range = kMiss;
  int object = -1, face = -1;
};

// A white wall at 30 m answers with strength 1, which is still enough; a tenth of it is not.
bool lost(double strength, Random& random) {
  constexpr double half_lost = 0.25;
  return !random.chance(0.998 * strength * strength / (strength * strength + half_lost * half_lost));
}

// Data sheet: repeatability below 1 cm up to 10 m and below 3 cm beyond. Slanted and weak footprints scatter more.
double spread(const World& world, const Hit& hit, double cosine, double strength) {
  const double slant = 0.15 * std::sqrt(1 - cosine * cosine) / std::max(cosine, 0.05);
  return world.noise * std::max(1.0, hit.range / 10) * std::sqrt(1 + slant * slant + 0.05 / std::max(strength, 0.02));
}

Ray beside(const Ray& ray, Random& random) {
  const Vector3d side = ray.direction.unitOrthogonal(), other = ray.direction.cross(side);
  const double angle = random.between(0, 2 * std::numbers::pi), off = kFootprint * std::sqrt(random.uniform());
  return {ray.origin, (ray.direction + off * (std::cos(angle) * side + std::sin(angle) * other)).normalized()};
}

Reading measure(const World& world, const Ray& ray, Random& random) {
  const Hit hit = first_answer(world, ray, kFarthest, random);
  if (hit.shape == nullptr || hit.range < kNearest) return {};
  const double cosine = incidence(hit, ray), strength = brightness(hit, cosine) * 900 / (hit.range * hit.range);
  if (lost(strength, random)) return {};
  const double error = spread(world, hit, cosine, strength) * random.normal();
  // A second ray within the footprint tells whether the beam straddles an edge; then the echoes may mix.
  if (random.chance(kMixing)) {
    const Hit other = world.shapes.cast(beside(ray, random), 0.02, hit.range + kPulse);
    const double gap = other.shape == nullptr ? 0 : std::abs(other.range - hit.range), share = random.uniform();
    if (gap > 0.05 && gap < kPulse && other.shape->surface != hit.shape->surface) {
      return {share * hit.range + (1 - share) * other.range + error, -1, -1};
    }
  }
  return {hit.range + world.bias[static_cast<std::size_t>(hit.shape->surface)] + error, hit.shape->surface,
          hit.shape->face};
}

}  // namespace

std::vector<Sample> scan_lidar(const World& world, const SensorPose& pose, double scale) {
  const double step = 0.25 * kDegree * scale, tilt_step = 0.3 * kDegree * scale;
  const int steps = static_cast<int>(270 * kDegree / step) + 1,
            lines = static_cast<int>((kLastTilt - kFirstTilt) / tilt_step) + 1;
  const Eigen::AngleAxisd heading(pose.heading, Vector3d::UnitZ());
  return measure_lines(lines, world.threads, [&](int line, std::vector<Sample>& samples) {
    const Eigen::Matrix3d turn =
        (heading * Eigen::AngleAxisd(kFirstTilt + line * tilt_step, Vector3d::UnitY())).toRotationMatrix();
    for (int i = 0; i < steps; ++i) {
      Random random(world.seed, (static_cast<std::uint64_t>(pose.number) << 48) +
                                    (static_cast<std::uint64_t>(line) << 24) + static_cast<std::uint64_t>(i));
      const double angle = -135 * kDegree + i * step;
      const Ray ray{pose.position, turn * Vector3d(std::cos(angle), std::sin(angle), 0)};
      const Reading reading = measure(world, ray, random);
      if (reading.range == kMiss || reading.range < kNearest) continue;
      samples.push_back({ray.origin + reading.range * ray.direction, reading.object, reading.face});
    }
  });
}

}  // namespace scenelore::simulator
