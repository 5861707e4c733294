// Items sorted into cells by an integer key: the one data structure behind voxels, patches and thinning.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace scenelore::perception {

using CellKey = std::uint64_t;
inline constexpr CellKey kNoCell = ~CellKey{0};  ///< items with this key belong to no cell

/// 21 bits an axis. Coordinates beyond ±2^20 belong to no cell.
inline constexpr std::int64_t kCellLimit = (std::int64_t{1} << 20) - 4;
[[nodiscard]] inline CellKey cell_key(std::int64_t x, std::int64_t y, std::int64_t z) {
  constexpr std::int64_t shift = std::int64_t{1} << 20;
  return static_cast<CellKey>(((x + shift) << 42) | ((y + shift) << 21) | (z + shift));
}
/// Key of the cell (dx, dy, dz) further: the fields never carry into one another within kCellLimit.
[[nodiscard]] inline CellKey moved(CellKey key, int dx, int dy, int dz) {
  return key + (static_cast<CellKey>(static_cast<std::int64_t>(dx)) << 42) + (static_cast<CellKey>(static_cast<std::int64_t>(dy)) << 21) +
         static_cast<CellKey>(static_cast<std::int64_t>(dz));
}
struct CellCoordinates {
  std::int64_t x, y, z;
};
[[nodiscard]] inline CellCoordinates coordinates(CellKey key) {
  constexpr CellKey mask = (CellKey{1} << 21) - 1;
  constexpr std::int64_t shift = std::int64_t{1} << 20;
  return {static_cast<std::int64_t>(key >> 42) - shift, static_cast<std::int64_t>((key >> 21) & mask) - shift,
          static_cast<std::int64_t>(key & mask) - shift};
}

/// Cells are numbered by rising key, items of a cell keep their order. Linear in the number of items: cells whose box is not
/// much larger than what it holds (those of a plane, of the directions of a view) are a table of the box, others a hash and sorted.
class CellIndex {
 public:
  CellIndex() = default;
  explicit CellIndex(std::span<const CellKey> keys);

  [[nodiscard]] std::size_t size() const { return keys_.size(); }
  [[nodiscard]] CellKey key(std::size_t cell) const { return keys_[cell]; }
  [[nodiscard]] std::span<const std::uint32_t> items(std::size_t cell) const {
    return std::span(items_).subspan(starts_[cell], starts_[cell + 1] - starts_[cell]);
  }
  /// Cell of a key, −1 when it holds nothing.
  [[nodiscard]] std::int32_t find(CellKey key) const {
    if (table_.empty()) return -1;
    if (!dense_) return find_by_hash(key);
    const Fields f = fields_of(key);
    return box_.holds(f) ? table_[box_.place(f)] : -1;
  }
  /// Cell of an item, −1 for items without one.
  [[nodiscard]] std::int32_t cell_of(std::size_t item) const { return cell_of_[item]; }

 private:
  using Fields = std::array<std::uint32_t, 3>;  ///< of a key, as they stand in it

  static Fields fields_of(CellKey key) {
    constexpr CellKey mask = (CellKey{1} << 21) - 1;
    return {static_cast<std::uint32_t>(key >> 42), static_cast<std::uint32_t>((key >> 21) & mask), static_cast<std::uint32_t>(key & mask)};
  }

  /// The smallest box around all cells; its places in the order of their keys.
  struct Box {
    Fields low{~0U, ~0U, ~0U}, high{};
    std::array<std::uint64_t, 3> extent{};                  ///< with these, once all cells are in it:
    std::uint64_t step_x = 0, step_y = 0, first_place = 0;  ///< place = step_x · x + step_y · y + z − first_place

    void extend(const Fields& f) {
      for (std::size_t axis = 0; axis < 3; ++axis) low[axis] = std::min(low[axis], f[axis]), high[axis] = std::max(high[axis], f[axis]);
    }
    void close() {
      for (std::size_t axis = 0; axis < 3; ++axis) extent[axis] = std::uint64_t{high[axis]} - low[axis] + 1;
      step_y = extent[2], step_x = extent[1] * extent[2];
      first_place = step_x * low[0] + step_y * low[1] + low[2];
    }
    /// Number of places; 2^60 or so for boxes that nobody would want a table of.
    [[nodiscard]] std::uint64_t size() const { return std::min(extent[0] * extent[1], std::uint64_t{1} << 39) * extent[2]; }
    [[nodiscard]] bool holds(const Fields& f) const {
      return f[0] - low[0] < extent[0] && f[1] - low[1] < extent[1] && f[2] - low[2] < extent[2];  // below `low` wraps around
    }
    [[nodiscard]] std::size_t place(const Fields& f) const { return step_x * f[0] + step_y * f[1] + f[2] - first_place; }
  };

  void number_in_box(std::span<const CellKey> keys);
  void number_by_hash(std::span<const CellKey> keys);
  void grow_table();
  std::int32_t insert(CellKey key);
  [[nodiscard]] std::int32_t find_by_hash(CellKey key) const;

  std::vector<CellKey> keys_;
  std::vector<std::uint32_t> starts_, items_;
  std::vector<std::int32_t> cell_of_;
  std::vector<std::int32_t> table_;  ///< cells by place in the box, or by hash (open addressing); −1 = nothing
  std::size_t mask_ = 0;
  Box box_;
  bool dense_ = false;
};

}  // namespace scenelore::perception
