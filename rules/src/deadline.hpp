// How long all questions to one rule file about one scene may take (Budget::total).
#pragma once

#include <chrono>
#include <cstdint>

#include "rule_file.hpp"

namespace scenelore::rules {

/// Runs from when it is made. The file must live as long.
class Deadline {
 public:
  Deadline(const RuleFile& file, const Budget& budget) : file_(file), total_(budget.total) {}

  /// Throws Error that names the file and how many questions it was asked, when the time is over.
  void check(std::int64_t asked) const;

 private:
  using Clock = std::chrono::steady_clock;

  const RuleFile& file_;
  std::chrono::milliseconds total_;
  Clock::time_point start_ = Clock::now();
};

}  // namespace scenelore::rules
