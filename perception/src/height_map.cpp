#include "height_map.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "outline_cut.hpp"

namespace scenelore::perception {
namespace {

constexpr double kFinest = 0.015, kCoarsest = 0.04;  // metres
constexpr double kWantedSamples = 5;
constexpr double kMostSlope = 0.176;                 // 10 degrees: keyboards stand at up to 6
constexpr double kSlopeAsRule = 0.07;                // 4 degrees
constexpr double kUneven = 0.002;                    // metres: keys, bent covers
constexpr double kSeedReach = 0.06;                  // metres around a seed: half a keyboard's depth
constexpr std::size_t kMostSeeds = 60;

CellKey key_at(const Eigen::Vector2f& p, double edge) {
  return cell_key(static_cast<std::int64_t>(std::floor(p.x() / edge)), static_cast<std::int64_t>(std::floor(p.y() / edge)), 0);
}

/// Over 3×3 cells: number and mean height of their samples.
struct WideCell {
  double n = 0, height = 0;
};

/// What does not average out: warped tops, distortion of the camera. Things lie on one side only, so the places below the
/// middle tell how far the means over 3×3 cells scatter beyond what the noise of their points explains.
double waviness(const std::vector<WideCell>& wide, double noise) {
  std::vector<double> means;
  double noise_squares = 0;
  for (const WideCell& m : wide) {
    if (m.n < 15) continue;
    means.push_back(m.height);
    noise_squares += noise * noise / m.n;
  }
  if (means.size() < 20) return 0;
  const auto upper = means.begin() + static_cast<std::ptrdiff_t>(means.size() * 2 / 5), lower = means.begin() + static_cast<std::ptrdiff_t>(means.size() / 10);
  std::nth_element(means.begin(), upper, means.end());
  std::nth_element(means.begin(), lower, upper);
  const double scatter = *upper - *lower;  // one deviation of a Gaussian
  return std::sqrt(std::max(0.0, scatter * scatter - noise_squares / static_cast<double>(means.size())));
}

/// Finds the planes in one connected set of raised cells.
class Extractor {
 public:
  Extractor(const HeightMap& map, double noise) : map_(map), noise_(noise), left_(map.cell.size(), 0) {}

  void extract(const std::vector<std::size_t>& patch, double fewest_points, std::vector<FlatThing>& out);

 private:
  struct Grown {
    FlatThing thing;
    double points = 0;
    double score = 0;  // points, each worth the less the further off it lies (MSAC, Torr & Zisserman 2000)
  };
  FlatThing fit(const std::vector<std::size_t>& cells) const;
  double distance(const FlatThing& plane, std::size_t c) const;
  Grown grow(const FlatThing& plane, std::size_t seed);
  Grown best_from(const std::vector<std::size_t>& seeds);

  const HeightMap& map_;
  double noise_;
  std::vector<int> left_;  // 1 = of the present patch and not yet explained, 2 = in the thing that grows
};

/// Least squares weighted by the number of points; few cells hardly tell a slope, which then stays near zero.
FlatThing Extractor::fit(const std::vector<std::size_t>& cells) const {
  FlatThing plane;
  double n = 0;
  for (const std::size_t c : cells) {
    n += map_.cell[c].n;
    plane.centre += map_.cell[c].n * map_.cell[c].at;
    plane.level += map_.cell[c].n * map_.cell[c].height;
  }
  plane.centre /= n;
  plane.level /= n;
  Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
  Eigen::Vector2d right = Eigen::Vector2d::Zero();
  for (const std::size_t c : cells) {
    const HeightMap::Cell& cell = map_.cell[c];
    const Eigen::Vector2d d = cell.at - plane.centre;
    normal += cell.n * d * d.transpose();
    right += cell.n * (cell.height - plane.level) * d;
  }
  const double scatter = std::max(noise_, 0.003);
  normal += Eigen::Matrix2d::Identity() * (scatter * scatter / (kSlopeAsRule * kSlopeAsRule));
  plane.slope = normal.ldlt().solve(right);
  if (plane.slope.norm() > kMostSlope) plane.slope *= kMostSlope / plane.slope.norm();
  return plane;
}

/// Of a cell's mean height, in units of what is allowed.
double Extractor::distance(const FlatThing& plane, std::size_t c) const {
  const HeightMap::Cell& cell = map_.cell[c];
  return std::abs(cell.height - plane.height_at(cell.at)) / (kUneven + 2.5 * noise_ / std::sqrt(cell.n));
}

Extractor::Grown Extractor::grow(const FlatThing& plane, std::size_t seed) {
  Grown grown{.thing = plane};
  if (distance(plane, seed) > 1) return grown;
  std::vector<std::size_t>& members = grown.thing.cells;
  members.assign(1, seed);
  left_[seed] = 2;
  for (std::size_t next = 0; next < members.size(); ++next) {
    const double off = distance(plane, members[next]);
    grown.points += map_.cell[members[next]].n;
    grown.score += map_.cell[members[next]].n * (1 - off * off);
    map_.for_each_neighbour(members[next], [&](std::size_t n) {
      if (left_[n] != 1 || distance(plane, n) > 1) return;
      left_[n] = 2;
      members.push_back(n);
    });
  }
  for (const std::size_t c : members) left_[c] = 1;
  return grown;
}

Extractor::Grown Extractor::best_from(const std::vector<std::size_t>& seeds) {
  Grown best;
  const std::size_t step = 1 + seeds.size() / kMostSeeds;
  for (std::size_t k = 0; k < seeds.size(); k += step) {
    const std::size_t seed = seeds[k];
    std::vector<std::size_t> around;
    for (const std::size_t c : seeds) {
      if ((map_.cell[c].at - map_.cell[seed].at).norm() < kSeedReach) around.push_back(c);
    }
    Grown grown = grow(fit(around), seed);
    for (int round = 0; round < 3 && !grown.thing.cells.empty(); ++round) {
      Grown again = grow(fit(grown.thing.cells), seed);
      if (again.score <= grown.score) break;
      grown = std::move(again);
    }
    if (grown.score > best.score) best = std::move(grown);
  }
  return best;
}

void Extractor::extract(const std::vector<std::size_t>& patch, double fewest_points, std::vector<FlatThing>& out) {
  for (const std::size_t c : patch) left_[c] = 1;
  std::vector<std::size_t> remaining = patch;
  while (true) {
    double points = 0;
    for (const std::size_t c : remaining) points += map_.cell[c].n;
    if (points < fewest_points) break;
    Grown best = best_from(remaining);
    if (best.points < fewest_points) break;
    for (const std::size_t c : best.thing.cells) left_[c] = 0;
    std::erase_if(remaining, [&](std::size_t c) { return left_[c] == 0; });
    std::vector<Eigen::Vector2d> places;
    for (const std::size_t c : best.thing.cells) places.push_back(map_.cell[c].at);
    for (const std::vector<std::size_t>& part : cut_outline(places, map_.edge)) {
      std::vector<std::size_t> cells;
      double held = 0;
      for (const std::size_t k : part) {
        cells.push_back(best.thing.cells[k]);
        held += map_.cell[cells.back()].n;
      }
      if (held < fewest_points) continue;
      FlatThing thing = fit(cells);
      thing.cells = std::move(cells);
      out.push_back(std::move(thing));
    }
  }
  for (const std::size_t c : remaining) left_[c] = 0;
}

CellIndex cells_of(const std::vector<Sample>& samples, double edge, const std::vector<bool>& left_out) {
  std::vector<CellKey> keys;
  keys.reserve(samples.size());
  for (std::size_t k = 0; k < samples.size(); ++k) keys.push_back(!left_out.empty() && left_out[k] ? kNoCell : key_at(samples[k].at, edge));
  return CellIndex(keys);
}

}  // namespace

double fitting_edge(const std::vector<Sample>& samples) {
  const CellIndex cells = cells_of(samples, kCoarsest, {});
  std::vector<std::size_t> counts;
  for (std::size_t c = 0; c < cells.size(); ++c) counts.push_back(cells.items(c).size());
  if (counts.empty()) return kCoarsest;
  const auto at = counts.begin() + static_cast<std::ptrdiff_t>(counts.size() / 3);
  std::nth_element(counts.begin(), at, counts.end());
  return std::clamp(kCoarsest * std::sqrt(kWantedSamples / static_cast<double>(*at)), kFinest, kCoarsest);
}

HeightMap make_height_map(const std::vector<Sample>& samples, double edge, double noise, const std::vector<bool>& left_out) {
  HeightMap map;
  map.edge = edge;
  map.cells = cells_of(samples, edge, left_out);
  map.cell.resize(map.cells.size());
  for (std::size_t c = 0; c < map.cells.size(); ++c) {
    HeightMap::Cell& cell = map.cell[c];
    for (const std::uint32_t k : map.cells.items(c)) cell.height += samples[k].height, cell.at += samples[k].at.cast<double>();
    cell.n = static_cast<double>(map.cells.items(c).size());
    cell.height /= cell.n, cell.at /= cell.n;
  }
  std::vector<WideCell> wide(map.cell.size());
  for (std::size_t c = 0; c < wide.size(); ++c) {
    wide[c].n = map.cell[c].n;
    double sum = map.cell[c].n * map.cell[c].height;
    map.for_each_neighbour(c, [&](std::size_t n) { wide[c].n += map.cell[n].n, sum += map.cell[n].n * map.cell[n].height; });
    wide[c].height = sum / wide[c].n;
  }
  map.lowest = std::max(kLowest, 3 * waviness(wide, noise));
  // A cell counts as raised when the mean of its points and of those around it is.
  for (std::size_t c = 0; c < wide.size(); ++c) {
    const double limit = std::max(map.lowest, kCertain * noise / std::sqrt(wide[c].n));
    HeightMap::Cell& cell = map.cell[c];
    cell.raised = wide[c].n >= 5 && wide[c].height > 0.6 * limit && cell.height > std::max(map.lowest, 2 * noise / std::sqrt(cell.n));
  }
  return map;
}

std::vector<FlatThing> flat_things(const HeightMap& map, double noise, double fewest_points) {
  std::vector<FlatThing> things;
  std::vector<bool> seen(map.cell.size(), false);
  Extractor extractor(map, noise);
  for (std::size_t first = 0; first < map.cell.size(); ++first) {
    if (!map.cell[first].raised || seen[first]) continue;
    std::vector<std::size_t> patch{first};
    seen[first] = true;
    for (std::size_t next = 0; next < patch.size(); ++next) {
      map.for_each_neighbour(patch[next], [&](std::size_t n) {
        if (!map.cell[n].raised || seen[n]) return;
        seen[n] = true;
        patch.push_back(n);
      });
    }
    extractor.extract(patch, fewest_points, things);
  }
  const auto points = [&](const FlatThing& thing) {
    double sum = 0;
    for (const std::size_t c : thing.cells) sum += map.cell[c].n;
    return sum;
  };
  std::stable_sort(things.begin(), things.end(), [&](const FlatThing& a, const FlatThing& b) { return points(a) > points(b); });
  return things;
}

}  // namespace scenelore::perception
