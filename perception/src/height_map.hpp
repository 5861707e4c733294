// What rises over a support, cell by cell, and the flat things that the raised cells are parts of.
#pragma once

#include <vector>

#include "cell_index.hpp"
#include "support.hpp"

namespace scenelore::perception {

inline constexpr double kLowest = 0.009;   ///< metres; papers and warped boards stay with their support
inline constexpr double kHighest = 0.08;   ///< metres above the support
inline constexpr double kCertain = 4.5;    ///< deviations of a mean

/// Heights of samples by square cells.
struct HeightMap {
  double edge = 0;  ///< metres
  CellIndex cells;  ///< items are samples
  struct Cell {
    double n = 0, height = 0;  ///< mean height of its samples
    Eigen::Vector2d at = Eigen::Vector2d::Zero();  ///< their mean place
    bool raised = false;
  };
  std::vector<Cell> cell;
  double lowest = kLowest;  ///< metres, what counts as raised on this support

  /// Up to 8 neighbours that hold samples.
  void for_each_neighbour(std::size_t c, auto visit) const {
    for (int d = 0; d < 9; ++d) {
      if (d == 4) continue;
      const std::int32_t n = cells.find(moved(cells.key(c), d / 3 - 1, d % 3 - 1, 0));
      if (n >= 0) visit(static_cast<std::size_t>(n));
    }
  }
};

/// Edge that lets the cells of a surface as dense as the sparser parts of these samples hold five points: 1.5 to 4 cm.
[[nodiscard]] double fitting_edge(const std::vector<Sample>& samples);

/// `left_out`: by sample, those that are in no cell; empty = none.
[[nodiscard]] HeightMap make_height_map(const std::vector<Sample>& samples, double edge, double noise, const std::vector<bool>& left_out = {});

/// A flat thing on a support: h = level + slope · (at − centre).
struct FlatThing {
  std::vector<std::size_t> cells;
  Eigen::Vector2d centre = Eigen::Vector2d::Zero(), slope = Eigen::Vector2d::Zero();
  double level = 0;

  [[nodiscard]] double height_at(const Eigen::Vector2d& p) const { return level + slope.dot(p - centre); }
};

/// The flat things that make up the raised cells, most points first: connected cells that one plane of at most 10 degrees
/// explains, cut where their outline is that of two things side by side. Cells that fit none are left out.
[[nodiscard]] std::vector<FlatThing> flat_things(const HeightMap& map, double noise, double fewest_points);

}  // namespace scenelore::perception
