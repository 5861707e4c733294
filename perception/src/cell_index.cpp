#include "cell_index.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace scenelore::perception {
namespace {

std::size_t hash(CellKey key) {
  key ^= key >> 31;
  key *= 0x9e3779b97f4a7c15ULL;
  return static_cast<std::size_t>(key ^ (key >> 29));
}

/// Places of a box for each item, up to which a table of all of them is less work than a hash of those that hold something.
constexpr std::uint64_t kPlacesPerItem = 8, kFewPlaces = 4096;

}  // namespace

CellIndex::CellIndex(std::span<const CellKey> keys) {
  Box box;  // here, where the compiler knows that nothing else changes it
  CellKey last = kNoCell;
  for (const CellKey key : keys) {
    if (key == last || key == kNoCell) continue;
    box.extend(fields_of(last = key));
  }
  if (last == kNoCell) {
    cell_of_.assign(keys.size(), -1);
    starts_.assign(1, 0);
    return;
  }
  box.close();
  box_ = box;
  if (box.size() <= kPlacesPerItem * keys.size() + kFewPlaces) {
    number_in_box(keys);
  } else {
    number_by_hash(keys);
  }
}

/// Items by place first, then cells in the order of the places, which is that of the keys.
void CellIndex::number_in_box(std::span<const CellKey> keys) {
  dense_ = true;
  const Box box = box_;
  constexpr std::size_t kAtOnce = 8;  // most places are empty
  std::vector<std::uint32_t> held((box.size() + kAtOnce - 1) / kAtOnce * kAtOnce, 0);
  cell_of_.resize(keys.size());
  CellKey last = kNoCell;
  std::int32_t place = -1;
  std::size_t cells = 0;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (keys[i] != last) {
      last = keys[i];
      place = last == kNoCell ? -1 : static_cast<std::int32_t>(box.place(fields_of(last)));
    }
    cell_of_[i] = place;
    if (place >= 0 && held[static_cast<std::size_t>(place)]++ == 0) ++cells;
  }
  table_.assign(held.size(), -1);
  keys_.resize(cells);
  starts_.resize(cells + 1);
  std::uint32_t items = 0;
  std::size_t cell = 0;
  for (std::size_t first = 0; first < held.size(); first += kAtOnce) {
    std::uint32_t any = 0;
    for (std::size_t p = first; p < first + kAtOnce; ++p) any |= held[p];
    if (any == 0) continue;
    for (std::size_t p = first; p < first + kAtOnce; ++p) {
      if (held[p] == 0) continue;
      table_[p] = static_cast<std::int32_t>(cell);
      starts_[cell++] = items;
      items += std::exchange(held[p], items);  // from here on the place of the cell's next item
    }
  }
  starts_[cell] = items;
  items_.resize(items);
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (cell_of_[i] < 0) continue;
    const auto p = static_cast<std::size_t>(cell_of_[i]);
    cell_of_[i] = table_[p];
    keys_[static_cast<std::size_t>(cell_of_[i])] = keys[i];
    items_[held[p]++] = static_cast<std::uint32_t>(i);
  }
}

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

void CellIndex::number_by_hash(std::span<const CellKey> keys) {
  grow_table();
  cell_of_.assign(keys.size(), -1);
  CellKey last = kNoCell;
  std::int32_t cell = -1;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (keys[i] == kNoCell) continue;
    // Neighbouring points of a file are mostly neighbours in space: the last cell saves most of the look-ups.
    if (keys[i] != last) cell = insert(last = keys[i]);
    cell_of_[i] = cell;
  }
  // Numbers by key, so that they do not depend on the order of the items.
  std::vector<std::pair<CellKey, std::int32_t>> order(keys_.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = {keys_[i], static_cast<std::int32_t>(i)};
  std::sort(order.begin(), order.end());
  std::vector<std::int32_t> rank(keys_.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    rank[static_cast<std::size_t>(order[i].second)] = static_cast<std::int32_t>(i);
    keys_[i] = order[i].first;
  }
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

std::int32_t CellIndex::find_by_hash(CellKey key) const {
  std::size_t at = hash(key) & mask_;
  while (table_[at] >= 0) {
    if (keys_[static_cast<std::size_t>(table_[at])] == key) return table_[at];
    at = (at + 1) & mask_;
  }
  return -1;
}

}  // namespace scenelore::perception
