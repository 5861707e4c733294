// From the caller's costs (double) to whole multiples of one power of two, and back.
#pragma once

#include "cost.hpp"
#include "scenelore/engine/problem.hpp"

namespace scenelore::engine {

/// Each cost of the problem is rounded once, to the nearest multiple of 1 / units. `units` is 2^40 unless the finite
/// costs add up to 2^8 or more; then it is the largest power of two with which their sum stays below 2^48.
/// The search is exact for the rounded costs, so an answer is optimal for the given ones within
/// (number of costs that it pays) / (2 · units): below 1e-9 for a thousand costs
/// and a sum of 1e5.
class Scale {
 public:
  explicit Scale(const Problem& problem);
  /// To the nearest, halves up; `cost` ≥ 0. kTop for more than all finite costs together.
  Cost whole(double cost) const {
    const double scaled = cost * units_;
    if (!(scaled < static_cast<double>(kTop / 16))) return kTop;
    const auto below = static_cast<Cost>(scaled);
    return below + (scaled - static_cast<double>(below) >= 0.5 ? 1 : 0);
  }
  double real(Cost cost) const;
  /// A cost of a whole assignment that was added up in real numbers and then made whole differs from the sum of whole
  /// costs by less than this.
  Cost slack() const { return slack_; }

 private:
  double units_;
  Cost slack_;
};

}  // namespace scenelore::engine
