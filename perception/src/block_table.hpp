// Where the voxels are: blocks of 8×8×8 voxels in a small hash, in each a dense table of voxel numbers.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace scenelore::perception {

inline constexpr std::uint32_t kNoVoxel = ~std::uint32_t{0};

/// Place of a voxel in its grid. Fields lie in [8, 2^21 − 8): a block beyond the last one can still be asked for.
struct VoxelPlace {
  std::uint32_t x = 0, y = 0, z = 0;
};
inline constexpr std::uint32_t kPlaceLimit = (1U << 21) - 8;
inline constexpr std::uint32_t kPlaceOrigin = 1U << 20;  ///< the voxel that begins at coordinate 0

/// Scans are coherent, so a caller that keeps the last block's number hardly ever asks the hash; inside of a block
/// everything is index arithmetic.
class BlockTable {
 public:
  static constexpr std::uint32_t kShift = 3, kEdge = 1U << kShift, kCells = kEdge * kEdge * kEdge;
  using Cells = std::array<std::uint32_t, kCells>;  ///< kNoVoxel = empty

  [[nodiscard]] static std::uint64_t block_key(VoxelPlace p) {
    return (std::uint64_t{p.x >> kShift} << 36) | (std::uint64_t{p.y >> kShift} << 18) | (p.z >> kShift);
  }
  [[nodiscard]] static std::uint32_t cell(VoxelPlace p) {
    return ((p.x & (kEdge - 1)) << (2 * kShift)) | ((p.y & (kEdge - 1)) << kShift) | (p.z & (kEdge - 1));
  }
  [[nodiscard]] static VoxelPlace place(std::uint64_t block_key, std::uint32_t cell) {
    constexpr std::uint64_t mask = (1U << 18) - 1;
    return {(static_cast<std::uint32_t>(block_key >> 36) << kShift) | (cell >> (2 * kShift)),
            (static_cast<std::uint32_t>((block_key >> 18) & mask) << kShift) | ((cell >> kShift) & (kEdge - 1)),
            (static_cast<std::uint32_t>(block_key & mask) << kShift) | (cell & (kEdge - 1))};
  }
  /// Key of the block (dx, dy, dz) further.
  [[nodiscard]] static std::uint64_t moved(std::uint64_t key, int dx, int dy, int dz) {
    return key + (static_cast<std::uint64_t>(static_cast<std::int64_t>(dx)) << 36) +
           (static_cast<std::uint64_t>(static_cast<std::int64_t>(dy)) << 18) + static_cast<std::uint64_t>(static_cast<std::int64_t>(dz));
  }

  [[nodiscard]] std::size_t size() const { return keys_.size(); }
  [[nodiscard]] std::uint64_t key(std::size_t block) const { return keys_[block]; }
  [[nodiscard]] Cells& cells(std::size_t block) { return cells_[block]; }
  [[nodiscard]] const Cells& cells(std::size_t block) const { return cells_[block]; }
  /// Number of the block, which is made (empty) when it is not there yet.
  std::uint32_t insert(std::uint64_t key);
  void reserve(std::size_t blocks) { keys_.reserve(blocks), cells_.reserve(blocks); }
  /// −1 = not there.
  [[nodiscard]] std::int64_t find(std::uint64_t key) const;
  /// Voxel at a place, kNoVoxel = none.
  [[nodiscard]] std::uint32_t voxel(VoxelPlace p) const {
    const std::int64_t block = find(block_key(p));
    return block < 0 ? kNoVoxel : cells_[static_cast<std::size_t>(block)][cell(p)];
  }

 private:
  void grow_hash();

  std::vector<std::uint64_t> keys_;
  std::vector<Cells> cells_;
  std::vector<std::int32_t> hash_;  ///< open addressing; −1 = free
  std::size_t mask_ = 0;
};

/// Looks up places of points in the order of a scan.
class VoxelFinder {
 public:
  explicit VoxelFinder(const BlockTable& table) : table_(table) {}

  /// kNoVoxel = none.
  [[nodiscard]] std::uint32_t find(VoxelPlace p) {
    const std::uint64_t key = BlockTable::block_key(p);
    if (key != key_) {
      key_ = key;
      const std::int64_t block = table_.find(key);
      cells_ = block < 0 ? nullptr : &table_.cells(static_cast<std::size_t>(block));
    }
    return cells_ == nullptr ? kNoVoxel : (*cells_)[BlockTable::cell(p)];
  }

 private:
  const BlockTable& table_;
  std::uint64_t key_ = ~std::uint64_t{0};
  const BlockTable::Cells* cells_ = nullptr;
};

}  // namespace scenelore::perception
