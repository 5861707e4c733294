// Facts by relation and plane, with planes as indices of the scene.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "scenelore/rules/rule_set.hpp"
#include "scenelore/rules/scene.hpp"

namespace scenelore::rules {

class FactIndex {
 public:
  struct Held {
    int b;
    double degree;
  };

  /// Throws Error for a fact about a plane that the scene lacks, or with a degree outside (0, 1].
  FactIndex(const Scene& scene, const Facts& facts);

  /// What stands in the relation to plane `a`, by rising b. A relation without facts gives nothing.
  [[nodiscard]] const std::vector<Held>& held(const std::string& relation, int a) const;
  /// 0 where there is no fact.
  [[nodiscard]] double degree(const std::string& relation, int a, int b) const;

 private:
  std::size_t planes_;
  std::map<std::string, std::vector<std::vector<Held>>> by_relation_;
  std::vector<Held> nothing_;
};

}  // namespace scenelore::rules
