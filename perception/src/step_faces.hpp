// Faces that stand out from a surface by less than a single measurement scatters: a board before a wall, a door leaf in
// its frame.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "height_grid.hpp"
#include "height_plane.hpp"

namespace scenelore::perception {

/// Cells of a surface that are offset from the rest of it.
struct StepFace {
  std::vector<bool> cells;
  double step = 0;        ///< metres over the rest; negative where it lies behind
  double evidence = 0;    ///< nats, log likelihood with the step over that without
  double jump = 0;        ///< metres, of the heights along its outline
  double deviations = 0;  ///< of the error of `jump`
  double waves = 0;       ///< metres, by which both sides of the step are not flat
  double area = 0;        ///< m²
  double width = 0;       ///< metres: area over the longer side of the box around it
};

/// Finds the faces of one surface, one after the other; the cells of those found are looked at no more.
class StepFaceFinder {
 public:
  /// `scatter` (metres) is the deviation of one point; what neighbouring cells differ by beyond it is the surface's
  /// own.
  StepFaceFinder(HeightGrid grid, double scatter);

  /// The highest step of those that leave no doubt: evidence far beyond what the best of all rectangles has by chance,
  /// heights that jump by more than half the step along the outline (those of bent walls do not), and a step far higher
  /// than the waves of the surface. Faces of one height that the wall parts are told one by one. Nothing when there is no
  /// more.
  [[nodiscard]] std::optional<StepFace> next();

 private:
  [[nodiscard]] std::vector<std::vector<bool>> seeds(const HeightPlane& wall) const;
  [[nodiscard]] std::optional<HeightPlane> wall_without(const std::vector<bool>& face, std::optional<HeightPlane> wall = {}) const;
  [[nodiscard]] StepFace grown_from(const std::vector<bool>& seed, const HeightPlane& near, std::vector<std::vector<bool>>& seen) const;
  [[nodiscard]] static bool stands_out(const StepFace& face);
  void keep_main_part(StepFace& face, const std::vector<double>& evidence) const;
  void measure_outline(StepFace& face) const;
  [[nodiscard]] double waves(const StepFace& face, const std::vector<double>& off) const;
  /// Visits (column, row, number) of the cells with points up to `around` columns and rows from one.
  void for_each_around(int x, int y, int around, auto visit) const {
    for (int j = std::max(0, y - around); j <= std::min(grid_.rows - 1, y + around); ++j) {
      for (int i = std::max(0, x - around); i <= std::min(grid_.columns - 1, x + around); ++i) {
        if (const std::size_t k = grid_.at(i, j); grid_.count[k] > 0) visit(i, j, k);
      }
    }
  }
  [[nodiscard]] double place(int cell) const { return (cell + 0.5) * grid_.edge; }

  HeightGrid grid_;
  double scatter_;
  std::vector<double> weight_;  // 1/m², one over the variance of each height
  double usual_weight_ = 0;     // their median
};

}  // namespace scenelore::perception
