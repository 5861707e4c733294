#include "cell_index.hpp"

#include <algorithm>
#include <numeric>

namespace scenelore::perception {
namespace {

std::size_t hash(CellKey key) {
  key ^= key >> 31;
  key *= 0x9e3779b97f4a7c15ULL;
  return static_cast<std::size_t>(key ^ (key >> 29));
}

}  // namespace

void CellIndex::grow_table() {
  const std::size_t size = std::max<std::size_t>(1024, table_.size() * 4);
  mask_ = size - 1;
  table_.assign(size, -1);
  for (std::size_t i = 0; i < keys_.size(); ++i) {
    std::size_t at = hash(keys_[i]) & mask_;
    while (table_[at] >= 0) at = (at + 1) & mask_;
    table_[at] = static_cast<std::int32_t>(i);
  }
}

std::int32_t CellIndex::insert(CellKey key) {
  std::size_t at = hash(key) & mask_;
  while (table_[at] >= 0) {
    if (keys_[static_cast<std::size_t>(table_[at])] == key) return table_[at];
    at = (at + 1) & mask_;
  }
  const auto cell = static_cast<std::int32_t>(keys_.size());
  keys_.push_back(key);
  table_[at] = cell;
  if (keys_.size() * 2 > table_.size()) grow_table();
  return cell;
}

CellIndex::CellIndex(std::span<const CellKey> keys) : cell_of_(keys.size(), -1) {
  grow_table();
  CellKey last = kNoCell;
  std::int32_t cell = -1;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (keys[i] == kNoCell) continue;
    // Neighbouring points of a file are mostly neighbours in space: the last cell saves most of the look-ups.
    if (keys[i] != last) cell = insert(last = keys[i]);
    cell_of_[i] = cell;
  }
  // Numbers by key, so that they do not depend on the order of the items.
  std::vector<std::int32_t> order(keys_.size()), rank(keys_.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) { return keys_[a] < keys_[b]; });
  std::vector<CellKey> sorted(keys_.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    rank[static_cast<std::size_t>(order[i])] = static_cast<std::int32_t>(i);
    sorted[i] = keys_[static_cast<std::size_t>(order[i])];
  }
  keys_ = std::move(sorted);
  for (std::int32_t& entry : table_) {
    if (entry >= 0) entry = rank[static_cast<std::size_t>(entry)];
  }
  starts_.assign(keys_.size() + 1, 0);
  for (std::int32_t& c : cell_of_) {
    if (c < 0) continue;
    c = rank[static_cast<std::size_t>(c)];
    ++starts_[static_cast<std::size_t>(c) + 1];
  }
  std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
  items_.resize(starts_.back());
  std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
  for (std::size_t i = 0; i < cell_of_.size(); ++i) {
    if (cell_of_[i] >= 0) items_[next[static_cast<std::size_t>(cell_of_[i])]++] = static_cast<std::uint32_t>(i);
  }
}

std::int32_t CellIndex::find(CellKey key) const {
  if (table_.empty()) return -1;
  std::size_t at = hash(key) & mask_;
  while (table_[at] >= 0) {
    if (keys_[static_cast<std::size_t>(table_[at])] == key) return table_[at];
    at = (at + 1) & mask_;
  }
  return -1;
}

}  // namespace scenelore::perception
