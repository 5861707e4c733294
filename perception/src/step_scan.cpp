#include "step_scan.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>

namespace scenelore::perception {
namespace {

constexpr int kTerms = 6;             // 1, u, v, u², uv, v²
constexpr double kCoarse = 0.12;      // metres
constexpr double kMostCoarse = 700;   // cells
constexpr double kLeastShare = 0.02;  // of the information on a step that the polynomial must leave
constexpr double kAlike = 0.4;        // of two rectangles: intersection over union

using Terms = Eigen::Matrix<double, kTerms, 1>;

Terms terms_at(const HeightGrid& grid, int column, int row) {
  const double u = 2 * (column + 0.5) / grid.columns - 1, v = 2 * (row + 0.5) / grid.rows - 1;
  Terms t;
  t << 1, u, v, u * u, u * v, v * v;
  return t;
}

/// Sums over the cells of coarser ones, of what the likelihood of a step needs: Σ w q with q orthonormal under w, Σ w,
/// Σ w r.
struct Coarse {
  int columns = 0, rows = 0;
  int cells = 1;  // of the grid to a side
  std::array<std::vector<double>, kTerms + 2> sums;
  double all = 0;
};

Coarse coarse_sums(const HeightGrid& grid, const std::vector<double>& weight) {
  Eigen::Matrix<double, kTerms, kTerms> normal = Eigen::Matrix<double, kTerms, kTerms>::Zero();
  Terms right = Terms::Zero();
  grid.for_each_cell([&](int x, int y, std::size_t c) {
    const Terms t = terms_at(grid, x, y);
    normal += weight[c] * t * t.transpose();
    right += weight[c] * grid.height[c] * t;
  });
  normal.diagonal().array() += 1e-9 * normal(0, 0) + 1e-300;
  const Eigen::LLT<Eigen::Matrix<double, kTerms, kTerms>> cholesky(normal);
  const Terms fit = cholesky.solve(right);
  Coarse coarse;
  coarse.cells =
      std::max(1, static_cast<int>(std::ceil(
                      std::max(kCoarse / grid.edge, std::sqrt(static_cast<double>(grid.count.size()) / kMostCoarse)))));
  coarse.columns = (grid.columns + coarse.cells - 1) / coarse.cells,
  coarse.rows = (grid.rows + coarse.cells - 1) / coarse.cells;
  for (auto& s : coarse.sums)
    s.assign(static_cast<std::size_t>(coarse.columns) * static_cast<std::size_t>(coarse.rows), 0.0);
  grid.for_each_cell([&](int x, int y, std::size_t c) {
    const std::size_t to = static_cast<std::size_t>(y / coarse.cells) * static_cast<std::size_t>(coarse.columns) +
                           static_cast<std::size_t>(x / coarse.cells);
    const Terms t = terms_at(grid, x, y), q = cholesky.matrixL().solve(t);
    for (int k = 0; k < kTerms; ++k) coarse.sums[static_cast<std::size_t>(k)][to] += weight[c] * q[k];
    coarse.sums[kTerms][to] += weight[c];
    coarse.sums[kTerms + 1][to] += weight[c] * (grid.height[c] - fit.dot(t));
    coarse.all += weight[c];
  });
  return coarse;
}

double overlap(const CellRectangle& a, const CellRectangle& b) {
  const auto area = [](const CellRectangle& r) {
    return static_cast<double>(std::max(0, r.right - r.left)) * std::max(0, r.top - r.bottom);
  };
  const double both = area(
      {std::max(a.left, b.left), std::min(a.right, b.right), std::max(a.bottom, b.bottom), std::min(a.top, b.top)});
  return both / (area(a) + area(b) - both);
}

}  // namespace

std::vector<CellRectangle> scan_for_steps(const HeightGrid& grid, const std::vector<double>& weight, double evidence,
                                          std::size_t most) {
  const Coarse coarse = coarse_sums(grid, weight);
  const auto columns = static_cast<std::size_t>(coarse.columns);
  std::vector<std::pair<double, CellRectangle>> of_rows;  // the best of each pair of rows
  std::vector<double> evidences(columns + 1);
  for (int bottom = 0; bottom < coarse.rows; ++bottom) {
    // Of the rows at hand, by column from the left: one array a sum, so that the compiler takes several at once.
    std::array<std::vector<double>, kTerms + 2> up_to;
    for (auto& sums : up_to) sums.assign(columns + 1, 0.0);
    for (int top = bottom + 1; top <= coarse.rows; ++top) {
      for (std::size_t k = 0; k < up_to.size(); ++k) {
        double sum = 0;
        const double* row = &coarse.sums[k][static_cast<std::size_t>(top - 1) * columns];
        for (std::size_t x = 0; x < columns; ++x) sum += row[x], up_to[k][x + 1] += sum;
      }
      double best = 2 * evidence;
      CellRectangle where;
      for (std::size_t left = 0; left < columns; ++left) {
        for (std::size_t right = left + 1; right <= columns; ++right) {
          const double w = up_to[kTerms][right] - up_to[kTerms][left],
                       pull = up_to[kTerms + 1][right] - up_to[kTerms + 1][left];
          double explained = 0;
          for (std::size_t k = 0; k < kTerms; ++k) {
            const double q = up_to[k][right] - up_to[k][left];
            explained += q * q;
          }
          const double information = w - explained;
          evidences[right] = information > kLeastShare * std::min(w, coarse.all - w) ? pull * pull / information : 0;
        }
        for (std::size_t right = left + 1; right <= columns; ++right) {
          if (!(evidences[right] > best)) continue;  // nor what is no number
          best = evidences[right];
          where = {static_cast<int>(left), static_cast<int>(right), bottom, top};
        }
      }
      if (best > 2 * evidence) of_rows.emplace_back(best, where);
    }
  }
  std::stable_sort(of_rows.begin(), of_rows.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<CellRectangle> distinct;
  for (const auto& [ignored, r] : of_rows) {
    if (distinct.size() == most) break;
    if (std::all_of(distinct.begin(), distinct.end(),
                    [&r = r](const CellRectangle& d) { return overlap(d, r) < kAlike; }))
      distinct.push_back(r);
  }
  for (CellRectangle& r : distinct) {
    for (int* side : {&r.left, &r.right, &r.bottom, &r.top}) *side *= coarse.cells;
    r.right = std::min(r.right, grid.columns), r.top = std::min(r.top, grid.rows);
  }
  return distinct;
}

}  // namespace scenelore::perception
