#include "simulator/sensor.hpp"

#include <algorithm>
#include <cmath>
#include <thread>

namespace scenelore::simulator {

double incidence(const Hit& hit, const Ray& ray) {
  const Vector3d point = ray.origin + hit.range * ray.direction;
  return std::min(1.0, std::abs(normal_at(*hit.shape, point).dot(ray.direction)));
}

double brightness(const Hit& hit, double cosine) {
  const Reflectance r = reflectance(static_cast<Material>(hit.shape->material));
  constexpr double lobe = 0.14;  // radians, 8 degrees
  const double angle = std::acos(cosine) / lobe;
  return r.diffuse * (1 - r.gloss) * cosine + r.gloss * (1 - r.transmission) * std::exp(-angle * angle);
}

Hit first_answer(const World& world, const Ray& ray, double farthest, Random& random) {
  double nearest = 0.02;
  for (int panes = 0; panes < 8; ++panes) {
    const Hit hit = world.shapes.cast(ray, nearest, farthest);
    if (hit.shape == nullptr) return hit;
    const double through = reflectance(static_cast<Material>(hit.shape->material)).transmission;
    if (through == 0 || !random.chance(through)) return hit;
    nearest = hit.range + 1e-4;
  }
  return {};
}

std::vector<Sample> measure_lines(int lines, int threads,
                                  const std::function<void(int, std::vector<Sample>&)>& measure) {
  std::vector<std::vector<Sample>> parts(static_cast<std::size_t>(threads));
  const auto run = [&](int part) {
    for (int line = lines * part / threads; line < lines * (part + 1) / threads; ++line)
      measure(line, parts[static_cast<std::size_t>(part)]);
  };
  {
    std::vector<std::jthread> helpers;
    for (int part = 1; part < threads; ++part) helpers.emplace_back(run, part);
    run(0);
  }
  for (std::size_t part = 1; part < parts.size(); ++part)
    parts[0].insert(parts[0].end(), parts[part].begin(), parts[part].end());
  return std::move(parts[0]);
}

}  // namespace scenelore::simulator
