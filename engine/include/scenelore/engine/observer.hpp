// What happens in a search, told to whoever listens. Without a listener it costs nothing.
#pragma once

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
  virtual void bounded(double /*lower_bound*/) {}
};

}  // namespace scenelore::engine
