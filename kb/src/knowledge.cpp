#include "scenelore/kb/knowledge.hpp"

#include <algorithm>

namespace scenelore::kb {

namespace {

template <typename Predicate>
int index_of(const std::vector<ObjectClass>& classes, Predicate predicate) {
  const auto found = std::find_if(classes.begin(), classes.end(), predicate);
  return found == classes.end() ? -1 : static_cast<int>(found - classes.begin());
}

}  // namespace

int Knowledge::class_index(const std::string& name) const {
  return index_of(classes, [&](const ObjectClass& c) { return c.name == name; });
}

int Knowledge::fallback_index() const {
  return index_of(classes, [](const ObjectClass& c) { return c.fallback; });
}

std::string Knowledge::setting(const std::string& key, const std::string& otherwise) const {
  const auto found = settings.find(key);
  return found == settings.end() ? otherwise : found->second;
}

}  // namespace scenelore::kb
