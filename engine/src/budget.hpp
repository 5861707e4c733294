// Time, nodes and interruption, shared by all searches of one call.
#pragma once

#include <chrono>
#include <cstdint>

#include "scenelore/engine/solver.hpp"

namespace scenelore::engine {

class Budget {
 public:
  explicit Budget(const Limits& limits) : limits_(limits), start_(std::chrono::steady_clock::now()) {}
  bool exhausted();
  /// The same without the limit of nodes: what comes before the first node stops for this alone.
  bool out_of_time();
  double seconds() const;

  std::uint64_t nodes = 0, backtracks = 0;

 private:
  Limits limits_;
  std::chrono::steady_clock::time_point start_;
  bool exhausted_ = false, out_of_time_ = false;
};

}  // namespace scenelore::engine
