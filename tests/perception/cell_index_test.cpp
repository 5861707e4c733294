// Cells of a small box and scattered ones are kept in different ways: a std::map is the oracle for both.
#include "cell_index.hpp"

#include <gtest/gtest.h>

#include <map>
#include <vector>

#include "planar_scenes.hpp"

namespace scenelore::perception {
namespace {

using testing::Random;

/// Keys of cells within ±half of the origin, every seventh item without one.
std::vector<CellKey> random_keys(std::size_t count, double half, double half_z, Random& random) {
  std::vector<CellKey> keys;
  for (std::size_t i = 0; i < count; ++i) {
    const auto at = [&](double most) { return static_cast<std::int64_t>(std::floor(random.uniform(-most, most + 1))); };
    keys.push_back(i % 7 == 6 ? kNoCell : cell_key(at(half), at(half), at(half_z)));
  }
  return keys;
}

void expect_as_map(const std::vector<CellKey>& keys) {
  std::map<CellKey, std::vector<std::uint32_t>> oracle;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (keys[i] != kNoCell) oracle[keys[i]].push_back(static_cast<std::uint32_t>(i));
  }
  const CellIndex index(keys);
  ASSERT_EQ(index.size(), oracle.size());
  std::size_t cell = 0;
  for (const auto& [key, items] : oracle) {
    EXPECT_EQ(index.key(cell), key);
    EXPECT_EQ(std::vector<std::uint32_t>(index.items(cell).begin(), index.items(cell).end()), items);
    for (const std::uint32_t i : items) EXPECT_EQ(index.cell_of(i), static_cast<std::int32_t>(cell));
    for (int d = 0; d < 27; ++d) {
      const CellKey near = moved(key, d / 9 - 1, d / 3 % 3 - 1, d % 3 - 1);
      const auto found = oracle.find(near);
      EXPECT_EQ(index.find(near), found == oracle.end() ? -1 : static_cast<std::int32_t>(std::distance(oracle.begin(), found)));
    }
    ++cell;
  }
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (keys[i] != kNoCell) continue;
    EXPECT_EQ(index.cell_of(i), -1);
  }
  EXPECT_EQ(index.find(kNoCell), -1);
}

TEST(CellIndex, NumbersCellsOfASmallBoxByKey) {
  Random random(1);
  expect_as_map(random_keys(2000, 20, 0, random));
  expect_as_map(random_keys(500, 3, 3, random));
}

TEST(CellIndex, NumbersScatteredCellsByKey) {
  Random random(2);
  expect_as_map(random_keys(500, static_cast<double>(kCellLimit), static_cast<double>(kCellLimit), random));
  expect_as_map(random_keys(500, 1000, 0, random));
}

TEST(CellIndex, HoldsNothingWithoutCells) {
  EXPECT_EQ(CellIndex().find(cell_key(0, 0, 0)), -1);
  for (const std::vector<CellKey>& keys : {std::vector<CellKey>(), std::vector<CellKey>(3, kNoCell)}) {
    const CellIndex index(keys);
    EXPECT_EQ(index.size(), 0U);
    EXPECT_EQ(index.find(cell_key(0, 0, 0)), -1);
  }
}

}  // namespace
}  // namespace scenelore::perception
