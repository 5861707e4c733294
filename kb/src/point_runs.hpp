// The plane number of each point of a scan as a small blob (encoding `runs1` of table scan_points).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace scenelore::kb {

/// For each run of equal numbers two LEB128 varints: number + 1, length. Requires: numbers ≥ −1.
[[nodiscard]] std::vector<std::byte> encode_runs(std::span<const std::int32_t> numbers);

/// The inverse. Throws Error when the blob is cut short, holds a number that no int32 is, or does not give exactly
/// `points` numbers.
[[nodiscard]] std::vector<std::int32_t> decode_runs(std::span<const std::byte> blob, std::size_t points);

}  // namespace scenelore::kb
