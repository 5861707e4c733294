#include "scenelore/kb/knowledge.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

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

double ProbabilityScale::operator()(double probability) const {
  if (probability <= 0 || probability >= 1 || (slope == 1 && offset == 0)) return probability;
  return 1 / (1 + std::exp(-slope * std::log(probability / (1 - probability)) - offset));
}

ProbabilityScale Knowledge::probability_scale() const {
  return {std::strtod(setting("probability_slope", "1").c_str(), nullptr), std::strtod(setting("probability_offset", "0").c_str(), nullptr)};
}

std::string Knowledge::setting(const std::string& key, const std::string& otherwise) const {
  const auto found = settings.find(key);
  return found == settings.end() ? otherwise : found->second;
}

}  // namespace scenelore::kb
