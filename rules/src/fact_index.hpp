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

  /// All facts of one relation, for those who ask about many pairs.
  class Relation {
   public:
    /// What stands in the relation to plane `a`, by rising b.
    [[nodiscard]] const std::vector<Held>& held(int a) const {
      static const std::vector<Held> nothing;
      return by_plane_ == nullptr ? nothing : (*by_plane_)[static_cast<std::size_t>(a)];
    }
    /// 0 where there is no fact.
    [[nodiscard]] double degree(int a, int b) const;

   private:
    friend class FactIndex;
    const std::vector<std::vector<Held>>* by_plane_ = nullptr;
  };

  /// Degrees for one who asks about each plane's partners in rising order, as a sorted list of pairs does: no search.
  class Rising {
   public:
    Rising(const Relation& relation, int planes) : relation_(relation), next_(static_cast<std::size_t>(planes)) {}
    /// As Relation::degree; for one `a`, b must not fall from call to call.
    [[nodiscard]] double degree(int a, int b) {
      const std::vector<Held>& list = relation_.held(a);
      std::size_t& at = next_[static_cast<std::size_t>(a)];
      while (at < list.size() && list[at].b < b) ++at;
      return at < list.size() && list[at].b == b ? list[at].degree : 0;
    }

   private:
    Relation relation_;
    std::vector<std::size_t> next_;
  };
  /// A relation without facts is empty.
  [[nodiscard]] Relation relation(const std::string& name) const;

  /// What stands in the relation to plane `a`, by rising b. A relation without facts gives nothing.
  [[nodiscard]] const std::vector<Held>& held(const std::string& relation, int a) const;
  /// 0 where there is no fact.
  [[nodiscard]] double degree(const std::string& relation, int a, int b) const;
  /// The Lua constraint behind a row, nullptr for any other row. The facts must live as long as this.
  [[nodiscard]] const TupleConstraint* tuples(const kb::ClassConstraint& row) const;

 private:
  const Facts& facts_;
  std::size_t planes_;
  std::map<std::string, std::vector<std::vector<Held>>> by_relation_;
};

}  // namespace scenelore::rules
