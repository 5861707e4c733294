// A number that a point is chosen or left out by, wherever it stands in its file.
#pragma once

#include <bit>
#include <cstdint>

namespace scenelore::perception {

/// Evenly spread over all 32-bit numbers, of the coordinates alone.
[[nodiscard]] inline std::uint32_t point_hash(float x, float y, float z) {
  std::uint64_t h = std::bit_cast<std::uint32_t>(x) * 0x9e3779b97f4a7c15ULL;
  h = (h ^ (h >> 29) ^ std::bit_cast<std::uint32_t>(y)) * 0xbf58476d1ce4e5b9ULL;
  h = (h ^ (h >> 31) ^ std::bit_cast<std::uint32_t>(z)) * 0x94d049bb133111ebULL;
  return static_cast<std::uint32_t>(h >> 32);
}

}  // namespace scenelore::perception
