// Facts by relation and plane, with planes as indices of the scene.
#pragma once

#include <map>
#include <span>
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

 private:
  /// One relation's facts by a, then b: those of plane a from first[a] to before first[a + 1].
  struct ByPlane {
    std::vector<std::size_t> first;
    std::vector<Held> held;
  };

 public:
  /// All facts of one relation, for those who ask about many pairs.
  class Relation {
   public:
    /// What stands in the relation to plane `a`, by rising b.
    [[nodiscard]] std::span<const Held> held(int a) const {
      if (by_plane_ == nullptr) return {};
      const std::size_t first = by_plane_->first[static_cast<std::size_t>(a)];
      return std::span(by_plane_->held).subspan(first, by_plane_->first[static_cast<std::size_t>(a) + 1] - first);
    }
    /// 0 where there is no fact.
    [[nodiscard]] double degree(int a, int b) const;

   private:
    friend class FactIndex;
    const ByPlane* by_plane_ = nullptr;
  };

  /// Degrees for one who asks about each plane's partners in rising order, as a sorted list of pairs does: no search.
  class Rising {
   public:
    Rising(const Relation& relation, int planes) : relation_(relation), next_(static_cast<std::size_t>(planes)) {}
    /// As Relation::degree; for one `a`, b must not fall from call to call.
    [[nodiscard]] double degree(int a, int b) {
      const std::span<const Held> list = relation_.held(a);
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
  [[nodiscard]] std::span<const Held> held(const std::string& relation, int a) const;
  /// 0 where there is no fact.
  [[nodiscard]] double degree(const std::string& relation, int a, int b) const;
  /// The Lua constraint behind a row, nullptr for any other row. The facts must live as long as this.
  [[nodiscard]] const TupleConstraint* tuples(const kb::ClassConstraint& row) const;

 private:
  const Facts& facts_;
  std::size_t planes_;
  std::map<std::string, ByPlane> by_relation_;
};

}  // namespace scenelore::rules
