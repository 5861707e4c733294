// What is known of the answers to questions about pairs of planes: in which range each lies.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace scenelore::rules {

/// A table of open addressing, since most of a scene's questions are asked once or twice: a block of memory for each would take longer.
class KnownRanges {
 public:
  struct Key {
    int a, b;      ///< planes, ≥ 0
    double reach;  ///< −1 stands for `gap`
    bool operator==(const Key&) const = default;
  };
  /// Where an answer lies; it is exact where the two are the same.
  struct Range {
    double low = 0, high = std::numeric_limits<double>::infinity();
  };

  /// Of a question, anything at first. Stays where it is until the next call.
  [[nodiscard]] Range& of(const Key& key) {
    if (2 * (used_ + 1) > slots_.size()) grow();
    Slot& slot = find(key);
    if (slot.key.a < 0) {
      slot.key = key;
      ++used_;
    }
    return slot.range;
  }
  [[nodiscard]] std::size_t size() const { return used_; }
  template <typename Visit>
  void for_each(Visit visit) const {  ///< in an order that means nothing
    for (const Slot& slot : slots_) {
      if (slot.key.a >= 0) visit(slot.key, slot.range);
    }
  }

 private:
  struct Slot {
    Key key{-1, -1, 0};  // a < 0: free
    Range range{};
  };

  /// The key's slot, or the free one that it would take.
  [[nodiscard]] Slot& find(const Key& key) {
    std::uint64_t hash = (static_cast<std::uint64_t>(key.a) << 32) ^ static_cast<std::uint64_t>(key.b) ^ (std::bit_cast<std::uint64_t>(key.reach) >> 7);
    hash *= 0x9e3779b97f4a7c15u;
    std::size_t at = (hash >> 32) & (slots_.size() - 1);
    while (slots_[at].key.a >= 0 && !(slots_[at].key == key)) at = (at + 1) & (slots_.size() - 1);
    return slots_[at];
  }
  void grow() {
    constexpr std::size_t kAtFirst = 32;
    const std::vector<Slot> before = std::exchange(slots_, std::vector<Slot>(slots_.empty() ? kAtFirst : 2 * slots_.size()));
    for (const Slot& slot : before) {
      if (slot.key.a >= 0) find(slot.key) = slot;
    }
  }

  std::vector<Slot> slots_;  // a power of two of them, at most half of them taken
  std::size_t used_ = 0;
};

}  // namespace scenelore::rules
