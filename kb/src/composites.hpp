#pragma once

#include <vector>

#include "scenelore/kb/knowledge.hpp"

namespace scenelore::kb {

/// Ids of the rows go down from here; those of Lua constraints stay above.
inline constexpr std::int64_t kFirstNeed = -1'000'000;

/// For each part with a weight: a plane of its class stands in its relation to some plane of the anchor's class; and, when one is
/// needed, the other way round. Parts of the anchor's own class need nothing.
[[nodiscard]] std::vector<ClassConstraint> composite_needs(const std::vector<Composite>& composites);

}  // namespace scenelore::kb
