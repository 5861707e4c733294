#include "block_table.hpp"

#include <algorithm>

namespace scenelore::perception {
namespace {

std::size_t hash_of(std::uint64_t key) {
  key *= 0x9e3779b97f4a7c15ULL;
  return static_cast<std::size_t>(key >> 32);
}

}  // namespace

void BlockTable::grow_hash() {
  const std::size_t size = std::max<std::size_t>(1024, hash_.size() * 4);
  mask_ = size - 1;
  hash_.assign(size, -1);
  for (std::size_t b = 0; b < keys_.size(); ++b) {
    std::size_t at = hash_of(keys_[b]) & mask_;
    while (hash_[at] >= 0) at = (at + 1) & mask_;
    hash_[at] = static_cast<std::int32_t>(b);
  }
}

std::uint32_t BlockTable::insert(std::uint64_t key) {
  if (keys_.size() * 2 >= hash_.size()) grow_hash();
  std::size_t at = hash_of(key) & mask_;
  while (hash_[at] >= 0) {
    if (keys_[static_cast<std::size_t>(hash_[at])] == key) return static_cast<std::uint32_t>(hash_[at]);
    at = (at + 1) & mask_;
  }
  const auto block = static_cast<std::uint32_t>(keys_.size());
  hash_[at] = static_cast<std::int32_t>(block);
  keys_.push_back(key);
  cells_.emplace_back().fill(kNoVoxel);
  return block;
}

std::int64_t BlockTable::find(std::uint64_t key) const {
  if (hash_.empty()) return -1;
  std::size_t at = hash_of(key) & mask_;
  while (hash_[at] >= 0) {
    if (keys_[static_cast<std::size_t>(hash_[at])] == key) return hash_[at];
    at = (at + 1) & mask_;
  }
  return -1;
}

}  // namespace scenelore::perception
