// What lies between two pieces of one plane.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "cell_index.hpp"
#include "seen_past.hpp"

namespace scenelore::perception {

/// Metres, edge of the cells in which gaps are looked for: four points a cell on this area (m²), between 3 and 8 cm.
[[nodiscard]] double gap_cell(double area, double points);

/// The held cells of a view, piece by piece.
using PieceCells = std::vector<std::vector<std::size_t>>;

/// Place of a cell of the view that has this point.
[[nodiscard]] CellKey key_of(const PlaneView& view, const Eigen::Vector2d& p);

[[nodiscard]] CellIndex index_of(const PlaneView& view, const std::vector<Eigen::Vector2d>& places);

/// The gaps between pieces of a view; refers to both.
class Gap {
 public:
  Gap(const PlaneView& view, const PieceCells& pieces) : view_(view), pieces_(pieces), empty_(index_of(view, view.empty)) {}

  /// Metres between the middles of the nearest cells.
  [[nodiscard]] double width(std::size_t a, std::size_t b) const;
  /// Whether most of the ways across that are about as short as the shortest one were looked through.
  [[nodiscard]] bool seen_through(std::size_t a, std::size_t b) const;

 private:
  /// Metres to the nearest cell of a piece, and that cell.
  [[nodiscard]] std::pair<double, std::size_t> nearest(std::size_t cell, std::size_t piece) const;

  const PlaneView& view_;
  const PieceCells& pieces_;
  CellIndex empty_;
};

}  // namespace scenelore::perception
