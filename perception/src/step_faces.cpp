#include "step_faces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>

#include "binary_cut.hpp"
#include "disjoint_sets.hpp"
#include "step_scan.hpp"

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
constexpr double kFar = 2.5;         // deviations; what may be a face
constexpr std::size_t kFewestNeighbours = 6;  // pairs of such cells; chance leaves few side by side
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
  std::vector<double> weights;
  grid_.for_each_cell([&](int, int, std::size_t c) {
    weight_[c] = 1 / (scatter * scatter / grid_.count[c] + uneven);
    weights.push_back(weight_[c]);
  });
  if (!weights.empty()) usual_weight_ = middle(std::move(weights));
}

/// The highest step first: what is far off the wall is told from it most surely, and would tip the wall that lower ones are told from.
std::optional<StepFace> StepFaceFinder::next() {
  const std::optional<HeightPlane> wall = wall_without(std::vector<bool>(grid_.count.size(), false));
  if (!wall) return std::nullopt;
  std::vector<std::vector<bool>> seen;
  std::optional<StepFace> highest;
  for (const std::vector<bool>& seed : seeds(*wall)) {
    StepFace face = grown_from(seed, *wall, seen);
    if (stands_out(face) && (!highest || std::abs(face.step) > std::abs(highest->step))) highest = std::move(face);
  }
  for (std::size_t c = 0; highest && c < grid_.count.size(); ++c) {
    if (highest->cells[c]) grid_.count[c] = 0;
  }
  return highest;
}

bool StepFaceFinder::stands_out(const StepFace& face) {
  const double step = std::abs(face.step);
  return face.evidence >= kEvidence && step >= kSlightest && step >= kOverWaves * face.waves &&
         face.jump / face.step >= 0.5 && face.deviations >= kSure && face.area >= kSmallest && face.width >= kNarrowest;
}

/// Where faces may be: the rectangles that explain most, and, since several of different heights hide each other from such a scan, all cells
/// that are far over the wall or far behind it, each by itself and with those around it.
std::vector<std::vector<bool>> StepFaceFinder::seeds(const HeightPlane& wall) const {
  const std::vector<bool> none(grid_.count.size(), false);
  std::vector<std::vector<bool>> out;
  for (const CellRectangle& r : scan_for_steps(grid_, weight_, kScanned, kCandidates)) {
    std::vector<bool>& cells = out.emplace_back(none);
    for (int y = r.bottom; y < r.top; ++y) {
      for (int x = r.left; x < r.right; ++x) cells[grid_.at(x, y)] = grid_.count[grid_.at(x, y)] > 0;
    }
  }
  for (const int around : {0, 1}) {
    std::vector<bool> over = none, behind = none;
    grid_.for_each_cell([&](int x, int y, std::size_t c) {
      double w = 0, sum = 0;
      for_each_around(x, y, around, [&](int i, int j, std::size_t k) {
        w += weight_[k], sum += weight_[k] * (grid_.height[k] - wall.at(place(i), place(j)));
      });
      over[c] = sum > kFar * std::sqrt(w), behind[c] = sum < -kFar * std::sqrt(w);
    });
    for (std::vector<bool>* cells : {&over, &behind}) {
      std::size_t neighbours = 0;
      grid_.for_each_pair([&](std::size_t a, std::size_t b) { neighbours += (*cells)[a] && (*cells)[b] ? 1 : 0; });
      if (neighbours >= kFewestNeighbours) out.push_back(std::move(*cells));
    }
  }
  return out;
}

/// The plane that most of the cells outside `face` lie in, each counting for its area, by iteratively reweighted least squares with Tukey's
/// biweight, whose reach is narrowed step by step so that the first plane may be far off (graduated non-convexity, Blake & Zisserman 1987); from
/// a plane that is known to be near the last steps do. Nothing where no cell is left.
std::optional<HeightPlane> StepFaceFinder::wall_without(const std::vector<bool>& face, std::optional<HeightPlane> wall) const {
  constexpr std::array kReaches{1e9, 16.0, 8.0, 4.0, 2.5, 2.5, 2.5};  // deviations
  constexpr std::size_t kWhenNear = 3;
  for (const double reach : std::span(kReaches).subspan(wall ? kWhenNear : 0)) {
    HeightSums sums;
    grid_.for_each_cell([&](int x, int y, std::size_t c) {
      if (face[c]) return;
      const double w = std::min(weight_[c], usual_weight_);
      const double off = wall ? grid_.height[c] - wall->at(place(x), place(y)) : 0;
      if (const double trust = 1 - off * off * w / (reach * reach); trust > 0)
        sums.add(w * trust * trust, place(x), place(y), grid_.height[c]);
    });
    if (sums.w <= 0) break;
    wall = sums.fit(kWallSlope);
  }
  return wall;
}

/// Fits a plane to the face and one to the rest, cuts the cells anew by which of the two explains them, and so on until they stay. With
/// no evidence where the face is lost on the way, or becomes one that was `seen` on another way.
StepFace StepFaceFinder::grown_from(const std::vector<bool>& seed, const HeightPlane& near, std::vector<std::vector<bool>>& seen) const {
  StepFace face;
  face.cells = seed;
  std::vector<double> evidence(grid_.count.size()), off(grid_.count.size());
  for (int round = 0; round < kRounds; ++round) {
    const std::optional<HeightPlane> wall = wall_without(face.cells, near);
    if (!wall) return {};
    HeightSums own;
    grid_.for_each_cell([&](int x, int y, std::size_t c) {
      off[c] = grid_.height[c] - wall->at(place(x), place(y));
      if (face.cells[c]) own.add(weight_[c], place(x), place(y), off[c]);
    });
    if (own.w <= 0) return {};
    const HeightPlane over_wall = own.fit(kFaceSlope);
    face.step = own.mean();
    double cells = 0, information = 0;
    grid_.for_each_cell([&](int x, int y, std::size_t c) {
      const double from_face = off[c] - over_wall.at(place(x), place(y));
      constexpr double most = kFarOff * kFarOff;
      evidence[c] =
          (std::min(most, weight_[c] * off[c] * off[c]) - std::min(most, weight_[c] * from_face * from_face)) / 2;
      if (face.cells[c]) off[c] = from_face;
      cells += 1, information += weight_[c];
    });
    const std::vector<bool> before = std::move(face.cells);
    face.cells = binary_cut(grid_, evidence, kStiffness * std::abs(face.step) * std::sqrt(information / cells));
    keep_main_part(face, evidence);
    if (face.evidence < kEvidence) return {};
    if (face.cells == before) break;
    if (std::find(seen.begin(), seen.end(), face.cells) != seen.end()) return {};
    seen.push_back(face.cells);
  }
  measure_outline(face);
  face.waves = waves(face, off);
  return face;
}

/// Of several faces of one height that one with most evidence. What the wall does not part is one: a door behind what stands before it.
void StepFaceFinder::keep_main_part(StepFace& face, const std::vector<double>& evidence) const {
  const auto cells = static_cast<std::int32_t>(face.cells.size());
  DisjointSets parts(face.cells.size());
  const auto link = [&](std::int32_t first, std::int32_t end, std::int32_t stride) {
    std::int32_t before = -1;  // cell of the face, with nothing known of the wall since
    for (std::int32_t c = first; c < end; c += stride) {
      if (face.cells[c] && before >= 0) parts.join(c, before);
      if (grid_.count[c] > 0) before = face.cells[c] ? c : -1;
    }
  };
  for (std::int32_t y = 0; y < grid_.rows; ++y) link(y * grid_.columns, (y + 1) * grid_.columns, 1);
  for (std::int32_t x = 0; x < grid_.columns; ++x) link(x, cells, grid_.columns);
  std::vector<double> of_part(face.cells.size(), 0.0);
  for (std::int32_t c = 0; c < cells; ++c) of_part[parts.root(static_cast<std::uint32_t>(c))] += face.cells[c] ? evidence[c] : 0;
  const auto best = std::max_element(of_part.begin(), of_part.end());
  face.evidence = *best;
  for (std::int32_t c = 0; c < cells; ++c) face.cells[c] = face.cells[c] && parts.root(c) == best - of_part.begin();
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
    for_each_around(x, y, 1, [&](int, int, std::size_t k) {
      if (face.cells[k] == face.cells[c]) n += grid_.count[k], sum += grid_.count[k] * off[k];
    });
    excess.push_back(sum * sum / (n * n) / kMedianOfSquares - scatter_ * scatter_ / n);
  });
  return excess.empty() ? 0 : std::sqrt(std::max(0.0, middle(std::move(excess))));
}

}  // namespace scenelore::perception
