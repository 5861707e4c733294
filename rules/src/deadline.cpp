#include "deadline.hpp"

#include <string>

#include "scenelore/rules/error.hpp"

namespace scenelore::rules {

void Deadline::check(std::int64_t asked) const {
  if (Clock::now() - start_ <= total_) return;
  throw Error(file_.source().shown + ": stopped after " + std::to_string(total_.count()) + " ms and " +
              std::to_string(asked) + " questions; '" + file_.name() +
              "' is too slow for this scene: give it a smaller 'within' or a cheap 'applies'");
}

}  // namespace scenelore::rules
