// How long all questions to one rule file about one scene may take (Budget::total).
#pragma once

#include <chrono>
#include <cstdint>

#include "rule_file.hpp"

namespace scenelore::rules {

/// Runs from when it is made; `spent` is the time that was used up before, in other threads perhaps. The file must live as long.
class Deadline {
 public:
  Deadline(const RuleFile& file, const Budget& budget, std::chrono::nanoseconds spent = {})
      : file_(file), total_(budget.total), start_(Clock::now() - spent) {}

  /// Throws Error that names the file and how many questions it was asked, when the time is over.
  void check(std::int64_t asked) const;

 private:
  using Clock = std::chrono::steady_clock;

  const RuleFile& file_;
  std::chrono::milliseconds total_;
  Clock::time_point start_;
};

}  // namespace scenelore::rules
