// Random numbers that are the same on every machine and for every number of threads: a counter (SplitMix64, Steele,
// Lea and Flood 2014) hashed from a seed and a stream number, with the distributions written out.
//
//   Random random(seed, ray_index);     // one stream a ray: no ray depends on another
//   double range = exact + 0.01 * random.normal();
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <numbers>

namespace scenelore::simulator {

class Random {
 public:
  explicit Random(std::uint64_t seed, std::uint64_t stream = 0) : state_(mix(seed) ^ mix(~stream * kGolden)) {}

  std::uint64_t next() {
    state_ += kGolden;
    return mix(state_);
  }
  /// In [0, 1).
  double uniform() { return static_cast<double>(next() >> 11) * 0x1p-53; }
  double between(double low, double high) { return low + (high - low) * uniform(); }
  /// In [low, high], both ends included.
  int integer(int low, int high) { return low + static_cast<int>(uniform() * (high - low + 1)); }
  bool chance(double probability) { return uniform() < probability; }
  int sign() { return chance(0.5) ? 1 : -1; }
  /// Standard normal, by Box and Muller (1958); the second value of the pair is not kept.
  double normal() {
    const double radius = std::sqrt(-2 * std::log(1 - uniform()));
    return radius * std::cos(2 * std::numbers::pi * uniform());
  }
  template <typename T>
  T pick(std::initializer_list<T> choices) {
    return choices.begin()[static_cast<std::size_t>(integer(0, static_cast<int>(choices.size()) - 1))];
  }

 private:
  static constexpr std::uint64_t kGolden = 0x9E3779B97F4A7C15U;
  static std::uint64_t mix(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBU;
    return z ^ (z >> 31);
  }
  std::uint64_t state_;
};

}  // namespace scenelore::simulator
