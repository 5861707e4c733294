// Items sorted into cells by an integer key: the one data structure behind voxels, patches and thinning.
#pragma once

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

/// Cells are numbered by rising key, items of a cell keep their order. Linear in the number of items, plus sorting the cells.
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
  [[nodiscard]] std::int32_t find(CellKey key) const;
  /// Cell of an item, −1 for items without one.
  [[nodiscard]] std::int32_t cell_of(std::size_t item) const { return cell_of_[item]; }

 private:
  void grow_table();
  std::int32_t insert(CellKey key);

  std::vector<CellKey> keys_;
  std::vector<std::uint32_t> starts_, items_;
  std::vector<std::int32_t> cell_of_;
  std::vector<std::int32_t> table_;  ///< open addressing; −1 = free
  std::size_t mask_ = 0;
};

}  // namespace scenelore::perception
