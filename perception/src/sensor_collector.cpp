#include "sensor_collector.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace scenelore::perception {
namespace {

constexpr std::size_t kUnknown = SensorPositions::kMost;  // in bytes: kMostNarrow; its number is known at the end only

/// All bits count, but zero has one sign.
std::array<std::uint64_t, 3> key_of(const Eigen::Vector3d& position) {
  std::array<std::uint64_t, 3> key{};
  for (Eigen::Index axis = 0; axis < 3; ++axis) key[static_cast<std::size_t>(axis)] = std::bit_cast<std::uint64_t>(position[axis] + 0.0);
  return key;
}

}  // namespace

std::size_t SensorCollector::Hash::operator()(const Key& key) const {
  std::uint64_t h = 0;
  for (const std::uint64_t part : key) h = (h ^ (h >> 29) ^ part) * 0x9e3779b97f4a7c15ULL;
  return static_cast<std::size_t>(h ^ (h >> 32));
}

std::optional<std::size_t> SensorCollector::number_of(const Eigen::Vector3d& position) {
  Eigen::Vector3d at = position;
  if (cell_ > 0) at = ((position / cell_).array().floor() + 0.5) * cell_;
  const auto [entry, is_new] = numbers_.try_emplace(key_of(at), found_.positions_.size());
  if (!is_new) return entry->second;
  if (found_.positions_.size() == SensorPositions::kMost) return std::nullopt;
  found_.positions_.push_back(at);
  return entry->second;
}

bool SensorCollector::add(const std::optional<Eigen::Vector3d>& position) {
  const std::optional<std::size_t> number = position ? number_of(*position) : kUnknown;
  if (!number) return false;
  put(*number);
  return true;
}

void SensorCollector::put(std::size_t number) {
  auto &narrow = found_.narrow_;
  auto &wide = found_.wide_;
  last_ = number;
  const std::size_t at = taken_++;
  if (number == 0) return;  // what the index begins with
  unknown_ = unknown_ || number == kUnknown;
  if (narrow.empty() && wide.empty()) narrow.assign(points_, 0);
  if (wide.empty() && number != kUnknown && number >= SensorPositions::kMostNarrow) widen();
  if (wide.empty()) {
    narrow[at] = static_cast<std::uint8_t>(std::min(number, SensorPositions::kMostNarrow));
  } else {
    wide[at] = static_cast<std::uint16_t>(number);
  }
}

void SensorCollector::widen() {
  found_.wide_.reserve(points_);
  for (const std::uint8_t number : found_.narrow_) {
    found_.wide_.push_back(number == SensorPositions::kMostNarrow ? static_cast<std::uint16_t>(kUnknown) : number);
  }
  found_.narrow_ = {};
}

SensorPositions SensorCollector::finish() && {
  if (!found_.known()) return {};
  if (unknown_) {
    std::replace(found_.narrow_.begin(), found_.narrow_.end(), static_cast<std::uint8_t>(SensorPositions::kMostNarrow),
                 static_cast<std::uint8_t>(found_.positions_.size()));
    std::replace(found_.wide_.begin(), found_.wide_.end(), static_cast<std::uint16_t>(kUnknown), static_cast<std::uint16_t>(found_.positions_.size()));
  }
  return std::move(found_);
}

}  // namespace scenelore::perception
