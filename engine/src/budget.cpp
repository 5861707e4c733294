#include "budget.hpp"

#include <limits>

namespace scenelore::engine {

bool Budget::exhausted() {
  if (!exhausted_) exhausted_ = nodes >= limits_.nodes || out_of_time();
  return exhausted_;
}

bool Budget::out_of_time() {
  if (out_of_time_) return true;
  out_of_time_ = (limits_.interrupt != nullptr && limits_.interrupt->load(std::memory_order_relaxed)) ||
                 (limits_.seconds < std::numeric_limits<double>::infinity() && seconds() >= limits_.seconds);
  return out_of_time_;
}

double Budget::seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

}  // namespace scenelore::engine
