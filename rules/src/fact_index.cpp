#include "fact_index.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <unordered_map>

#include "scenelore/rules/error.hpp"

namespace scenelore::rules {

FactIndex::FactIndex(const Scene& scene, const Facts& facts) : facts_(facts), planes_(scene.planes.size()) {
  std::unordered_map<kb::PlaneId, int> index;
  index.reserve(scene.ids.size());
  for (std::size_t i = 0; i < scene.ids.size(); ++i) index[scene.ids[i]] = static_cast<int>(i);
  const auto plane = [&](kb::PlaneId id, const std::string& relation) {
    const auto found = index.find(id);
    if (found != index.end()) return found->second;
    throw Error("a fact of relation '" + relation + "' speaks of plane " + std::to_string(id) +
                ", which is not in this scan");
  };
  struct Entry {
    int a;
    Held held;
  };
  std::map<std::string, std::vector<Entry>> lists;
  std::vector<Entry>* list = nullptr;
  const std::string* relation = nullptr;
  std::optional<kb::PlaneId> id;  // of the fact before: they come by relation and a
  int index_of_a = -1;
  for (const kb::RelationFact& fact : facts.facts) {
    if (relation == nullptr || *relation != fact.relation) {
      list = &lists[fact.relation];
      relation = &fact.relation;
    }
    if (!(fact.degree > 0 && fact.degree <= 1)) {
      throw Error("a fact of relation '" + fact.relation + "' has degree " + std::to_string(fact.degree) +
                  "; degrees lie above 0 and up to 1");
    }
    if (fact.a != id) {
      index_of_a = plane(fact.a, fact.relation);
      id = fact.a;
    }
    const int a = index_of_a, b = plane(fact.b, fact.relation);
    if (a != b) list->push_back({a, {b, fact.degree}});
  }
  for (auto& [name, entries] : lists) {
    const auto before = [](const Entry& e, const Entry& f) { return std::pair(e.a, e.held.b) < std::pair(f.a, f.held.b); };
    if (!std::is_sorted(entries.begin(), entries.end(), before)) std::stable_sort(entries.begin(), entries.end(), before);
    ByPlane& by_plane = by_relation_[name];
    by_plane.first.assign(planes_ + 1, 0);
    by_plane.held.reserve(entries.size());
    for (const Entry& entry : entries) {
      ++by_plane.first[static_cast<std::size_t>(entry.a) + 1];
      by_plane.held.push_back(entry.held);
    }
    std::partial_sum(by_plane.first.begin(), by_plane.first.end(), by_plane.first.begin());
  }
}

FactIndex::Relation FactIndex::relation(const std::string& name) const {
  Relation out;
  const auto found = by_relation_.find(name);
  if (found != by_relation_.end()) out.by_plane_ = &found->second;
  return out;
}

double FactIndex::Relation::degree(int a, int b) const {
  const std::span<const Held> list = held(a);
  const auto found = std::lower_bound(list.begin(), list.end(), b, [](const Held& h, int plane) { return h.b < plane; });
  return found != list.end() && found->b == b ? found->degree : 0;
}

std::span<const FactIndex::Held> FactIndex::held(const std::string& name, int a) const { return relation(name).held(a); }
double FactIndex::degree(const std::string& name, int a, int b) const { return relation(name).degree(a, b); }

const TupleConstraint* FactIndex::tuples(const kb::ClassConstraint& row) const {
  for (const TupleConstraint& c : facts_.constraints) {
    if (c.name == row.name) return &c;
  }
  return nullptr;
}

}  // namespace scenelore::rules
