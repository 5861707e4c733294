#include "step_faces.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "binary_cut.hpp"
#include "height_plane.hpp"

namespace scenelore::perception {
namespace {

constexpr std::size_t kCandidates = 4;
constexpr int kRounds = 3;             // of fitting both planes and cutting anew
constexpr double kScanned = 16;        // nats of a rectangle on coarse cells, which cut off part of a face
constexpr double kEvidence = 40;       // nats of a face; a wall has 10⁵ to 10⁶ rectangles, 14 nats
constexpr double kSlightest = 0.0025;  // metres of a step
constexpr double kSure = 6;            // deviations of the jump along an outline
constexpr double kOverWaves = 6;       // a step over the waves of its surface
constexpr double kSmallest = 0.03;     // m²
constexpr double kNarrowest = 0.1;     // metres
constexpr double kWallSlope = 0.1,
                 kFaceSlope = 0.01;  // deviations; what hangs on a wall hangs along it, to half a degree
constexpr double kFarOff = 3;        // deviations; a height further off tells no more than this
constexpr double kStiffness = 1.2;   // nats of a cell's border for each deviation that the step is of a cell's height
constexpr double kBand = 0.12;       // metres on either side of an outline
constexpr double kMedianOfSquares = 0.455;  // of a Gaussian's, in variances

double middle(std::vector<double> values) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// m², how much cells differ beyond what the scatter of points makes them: the median over neighbours, which steps
/// hardly move.
double unevenness(const HeightGrid& grid, double scatter) {
  std::vector<double> excess;
  grid.for_each_pair([&](std::size_t a, std::size_t b) {
    const double d = grid.height[a] - grid.height[b];
    excess.push_back(d * d / kMedianOfSquares - scatter * scatter * (1 / grid.count[a] + 1 / grid.count[b]));
  });
  return excess.empty() ? 0 : std::max(0.0, middle(std::move(excess)) / 2);
}

}  // namespace

StepFaceFinder::StepFaceFinder(HeightGrid grid, double scatter)
    : grid_(std::move(grid)), scatter_(scatter), weight_(grid_.count.size(), 0.0) {
  const double uneven = unevenness(grid_, scatter);
  grid_.for_each_cell([&](int, int, std::size_t c) { weight_[c] = 1 / (scatter * scatter / grid_.count[c] + uneven); });
}

std::optional<StepFace> StepFaceFinder::next() {
  for (const CellRectangle& seed : scan_for_steps(grid_, weight_, kScanned, kCandidates)) {
    StepFace face = grown_from(seed);
    const double step = std::abs(face.step);
    if (face.evidence < kEvidence || step < kSlightest || step < kOverWaves * face.waves) continue;
    if (face.jump / face.step < 0.5 || face.deviations < kSure || face.area < kSmallest || face.width < kNarrowest)
      continue;
    for (std::size_t c = 0; c < face.cells.size(); ++c) {
      if (face.cells[c]) grid_.count[c] = 0;
    }
    return face;
  }
  return std::nullopt;
}

/// Fits a plane to the face and one to the rest, cuts the cells anew by which of the two explains them, and so on. With
/// no evidence where the face is lost on the way.
StepFace StepFaceFinder::grown_from(const CellRectangle& seed) const {
  StepFace face;
  face.cells.assign(grid_.count.size(), false);
  for (int y = seed.bottom; y < seed.top; ++y) {
    for (int x = seed.left; x < seed.right; ++x) face.cells[grid_.at(x, y)] = grid_.count[grid_.at(x, y)] > 0;
  }
  std::vector<double> evidence(grid_.count.size()), off(grid_.count.size());
  for (int round = 0; round < kRounds; ++round) {
    HeightSums rest, own;
    grid_.for_each_cell([&](int x, int y, std::size_t c) {
      if (!face.cells[c]) rest.add(weight_[c], place(x), place(y), grid_.height[c]);
    });
    if (rest.w <= 0) return {};
    const HeightPlane wall = rest.fit(kWallSlope);
    grid_.for_each_cell([&](int x, int y, std::size_t c) {
      off[c] = grid_.height[c] - wall.at(place(x), place(y));
      if (face.cells[c]) own.add(weight_[c], place(x), place(y), off[c]);
    });
    if (own.w <= 0) return {};
    const HeightPlane over_wall = own.fit(kFaceSlope);
    face.step = own.mean();
    double cells = 0;
    grid_.for_each_cell([&](int x, int y, std::size_t c) {
      const double from_face = off[c] - over_wall.at(place(x), place(y));
      constexpr double most = kFarOff * kFarOff;
      evidence[c] =
          (std::min(most, weight_[c] * off[c] * off[c]) - std::min(most, weight_[c] * from_face * from_face)) / 2;
      if (face.cells[c]) off[c] = from_face;
      cells += 1;
    });
    const double typical = std::sqrt((own.w + rest.w) / cells);
    face.cells = binary_cut(grid_, evidence, kStiffness * std::abs(face.step) * typical);
    face.evidence = 0;
    for (std::size_t c = 0; c < face.cells.size(); ++c) {
      if (face.cells[c]) face.evidence += evidence[c];
    }
    if (face.evidence < kEvidence) return {};
  }
  measure_outline(face);
  face.waves = waves(face, off);
  return face;
}

/// At each side of a cell that is the face's end: the heights up to 12 cm before it, along the row or column, over
/// those behind it.
void StepFaceFinder::measure_outline(StepFace& face) const {
  int left = grid_.columns, right = -1, bottom = grid_.rows, top = -1;
  double cells = 0, information = 0, sum = 0;
  const int reach = std::max(1, static_cast<int>(std::lround(kBand / grid_.edge)));
  struct Mean {
    double w = 0, h = 0;
  };
  grid_.for_each_cell([&](int x, int y, std::size_t c) {
    if (!face.cells[c]) return;
    cells += 1;
    left = std::min(left, x), right = std::max(right, x), bottom = std::min(bottom, y), top = std::max(top, y);
    for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
      Mean inside, outside;
      for (int k = 1 - reach; k <= reach; ++k) {
        const int i = x + k * dx, j = y + k * dy;
        if (i < 0 || j < 0 || i >= grid_.columns || j >= grid_.rows) continue;
        const std::size_t n = grid_.at(i, j);
        if (grid_.count[n] <= 0) continue;
        if (k == 1 && face.cells[n]) break;
        if (face.cells[n] == (k > 0)) continue;
        Mean& side = k > 0 ? outside : inside;
        side.w += weight_[n], side.h += weight_[n] * grid_.height[n];
      }
      if (inside.w <= 0 || outside.w <= 0) continue;
      const double known = inside.w * outside.w / (inside.w + outside.w);
      information += known, sum += known * (inside.h / inside.w - outside.h / outside.w);
    }
  });
  if (information > 0) face.jump = sum / information, face.deviations = std::abs(sum) / std::sqrt(information);
  face.area = cells * grid_.edge * grid_.edge;
  if (cells > 0) face.width = face.area / ((1 + std::max(right - left, top - bottom)) * grid_.edge);
}

/// Deviation of the heights over 3 × 3 cells from their plane (`off`), beyond that of so many points; the median, which
/// other faces hardly move.
double StepFaceFinder::waves(const StepFace& face, const std::vector<double>& off) const {
  std::vector<double> excess;
  grid_.for_each_cell([&](int x, int y, std::size_t c) {
    double n = 0, sum = 0;
    for (int j = std::max(0, y - 1); j <= std::min(grid_.rows - 1, y + 1); ++j) {
      for (int i = std::max(0, x - 1); i <= std::min(grid_.columns - 1, x + 1); ++i) {
        const std::size_t k = grid_.at(i, j);
        if (grid_.count[k] > 0 && face.cells[k] == face.cells[c]) n += grid_.count[k], sum += grid_.count[k] * off[k];
      }
    }
    excess.push_back(sum * sum / (n * n) / kMedianOfSquares - scatter_ * scatter_ / n);
  });
  return excess.empty() ? 0 : std::sqrt(std::max(0.0, middle(std::move(excess))));
}

}  // namespace scenelore::perception
