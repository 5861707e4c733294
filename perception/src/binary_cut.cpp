#include "binary_cut.hpp"

#include <cmath>

namespace scenelore::perception {
namespace {

/// What flows over the sides between the cells c and c + step, of all c: bounded by the cost of a border there, 0 where
/// there is none.
struct Flows {
  Flows(std::size_t cells, std::size_t to_next) : step(to_next), bound(cells), flow(cells), ahead(cells + to_next) {}

  std::size_t step;
  std::vector<float> bound, flow;
  std::vector<float> ahead;  // extrapolated; that of cell c stands at c + step, so that none is before the first

  void update(const std::vector<float>& smooth, float stride, float momentum) {
    const std::size_t count = bound.size() - step;
    const float *here = smooth.data(), *there = here + step, *most = bound.data();
    float *of = flow.data(), *next = ahead.data() + step;
    for (std::size_t c = 0; c < count; ++c) {
      const float wanted = next[c] + stride * (here[c] - there[c]);
      const float capped = wanted < most[c] ? wanted : most[c], flowing = capped > -most[c] ? capped : -most[c];
      next[c] = flowing + momentum * (flowing - of[c]);
      of[c] = flowing;
    }
  }
};

}  // namespace

std::vector<bool> binary_cut(const HeightGrid& grid, const std::vector<double>& evidence, double border) {
  constexpr int kRounds = 80;
  constexpr float kStride = 1.0F / 8;  // over the largest eigenvalue of the grid's Laplacian
  const std::size_t cells = grid.count.size();
  Flows along(cells, 1), up(cells, static_cast<std::size_t>(grid.columns));
  grid.for_each_pair([&](std::size_t a, std::size_t b) {
    (b == a + 1 && b % up.step != 0 ? along : up).bound[a] = static_cast<float>(border);
  });
  std::vector<float> given(cells), smooth;
  for (std::size_t c = 0; c < cells; ++c) given[c] = static_cast<float>(evidence[c]);
  smooth = given;
  double t = 1;
  for (int round = 0; round < kRounds; ++round) {
    const double next = (1 + std::sqrt(1 + 4 * t * t)) / 2;
    const auto momentum = round + 1 < kRounds ? static_cast<float>((t - 1) / next) : 0.0F;
    t = next;
    along.update(smooth, kStride, momentum);
    up.update(smooth, kStride, momentum);
    const float *from_left = along.ahead.data(), *to_right = from_left + along.step, *from_below = up.ahead.data(),
                *upwards = from_below + up.step;
    for (std::size_t c = 0; c < cells; ++c)
      smooth[c] = given[c] - to_right[c] + from_left[c] - upwards[c] + from_below[c];
  }
  std::vector<bool> inside(cells, false);
  for (std::size_t c = 0; c < cells; ++c) inside[c] = grid.count[c] > 0 && smooth[c] > 0;
  return inside;
}

}  // namespace scenelore::perception
