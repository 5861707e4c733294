// A set of small indices that gives out its least or greatest member: the work lists of propagation.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace scenelore::engine {

class IndexSet {
 public:
  void resize(int size) { words_.assign((static_cast<std::size_t>(size) + 63) / 64, 0); }
  void insert(int index) { words_[word(index)] |= bit(index); }
  bool contains(int index) const { return (words_[word(index)] & bit(index)) != 0; }
  void clear() { words_.assign(words_.size(), 0); }

  /// The least member, taken out; −1 when empty.
  int pop_min() {
    for (std::size_t w = 0; w < words_.size(); ++w)
      if (words_[w] != 0) return pop(w, std::countr_zero(words_[w]));
    return -1;
  }

  /// The greatest member, taken out; −1 when empty.
  int pop_max() {
    for (std::size_t w = words_.size(); w-- > 0;)
      if (words_[w] != 0) return pop(w, 63 - std::countl_zero(words_[w]));
    return -1;
  }

 private:
  static std::size_t word(int index) { return static_cast<std::size_t>(index) / 64; }
  static std::uint64_t bit(int index) { return std::uint64_t{1} << (static_cast<unsigned>(index) % 64); }
  int pop(std::size_t w, int position) {
    words_[w] &= ~(std::uint64_t{1} << position);
    return static_cast<int>(w * 64) + position;
  }
  std::vector<std::uint64_t> words_;
};

}  // namespace scenelore::engine
