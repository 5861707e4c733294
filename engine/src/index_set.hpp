// A set of small indices that gives out its least or greatest member: the work lists of propagation.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace scenelore::engine {

class IndexSet {
 public:
  void resize(int size) {
    words_.assign((static_cast<std::size_t>(size) + 63) / 64, 0);
    begin_ = words_.size(), end_ = 0;
  }
  void insert(int index) {
    const std::size_t w = word(index);
    words_[w] |= bit(index);
    begin_ = std::min(begin_, w);
    end_ = std::max(end_, w + 1);
  }
  bool contains(int index) const { return (words_[word(index)] & bit(index)) != 0; }
  void clear() {
    for (; begin_ < end_; ++begin_) words_[begin_] = 0;
    begin_ = words_.size(), end_ = 0;
  }

  /// The least member, taken out; −1 when empty.
  int pop_min() {
    for (; begin_ < end_; ++begin_)
      if (words_[begin_] != 0) return pop(begin_, std::countr_zero(words_[begin_]));
    return nothing();
  }

  /// The greatest member, taken out; −1 when empty.
  int pop_max() {
    for (; begin_ < end_; --end_)
      if (words_[end_ - 1] != 0) return pop(end_ - 1, 63 - std::countl_zero(words_[end_ - 1]));
    return nothing();
  }

 private:
  static std::size_t word(int index) { return static_cast<std::size_t>(index) / 64; }
  static std::uint64_t bit(int index) { return std::uint64_t{1} << (static_cast<unsigned>(index) % 64); }
  int pop(std::size_t w, int position) {
    words_[w] &= ~(std::uint64_t{1} << position);
    return static_cast<int>(w * 64) + position;
  }
  int nothing() {
    begin_ = words_.size(), end_ = 0;
    return -1;
  }
  std::vector<std::uint64_t> words_;
  std::size_t begin_ = 0, end_ = 0;  ///< words before begin_ and from end_ on are 0
};

}  // namespace scenelore::engine
