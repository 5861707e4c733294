// What happens in a search, told to whoever listens. Without a listener it costs nothing.
#pragma once

#include <cstdint>

#include "scenelore/engine/problem.hpp"

namespace scenelore::engine {

/// Override what is of interest; every method does nothing by default.
class Observer {
 public:
  virtual ~Observer() = default;
  virtual void expanded(int /*depth*/, Literal /*decision*/, double /*lower_bound*/) {}
  /// `constraint` is the one whose propagation failed, −1 when the bound reached the incumbent.
  virtual void pruned(int /*depth*/, Literal /*decision*/, int /*constraint*/) {}
  virtual void backtracked(int /*depth*/) {}
  virtual void improved(double /*cost*/) {}
  /// A burst ends: the other branch of the node at this depth waits on the frontier under a number.
  virtual void deferred(int /*depth*/, std::uint64_t /*number*/) {}
  /// A burst begins at an open node of the frontier; the first one of a search is its root.
  virtual void entered(std::uint64_t /*number*/) {}
  virtual void bounded(double /*lower_bound*/) {}
};

}  // namespace scenelore::engine
