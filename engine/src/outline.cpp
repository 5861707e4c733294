#include "outline.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace scenelore::engine {

Outline::Outline(const Problem& problem, const Scale& scale, std::span<const char> used) : problem_(&problem), scale_(&scale) {
  first_label.push_back(0);
  for (const Variable& variable : problem.variables()) {
    for (const double cost : variable.costs) {
      own.push_back(scale.whole(cost));
      variable_of.push_back(variables());
    }
    first_label.push_back(static_cast<int>(own.size()));
  }
  first_clash.assign(own.size() + 1, 0);
  const std::size_t constraints = problem.constraints().size();
  price.reserve(constraints);
  conflict.reserve(constraints);
  const auto counts_here = [&](std::size_t c) { return used.empty() || used[c] != 0; };
  const auto add_conflict = [&](std::size_t c, double weight, const Conflict& body) {
    if (counts_here(c)) add(body, scale.whole(weight), static_cast<int>(c));
  };
  problem.for_each_constraint(add_conflict, [&](std::size_t c, const ConstraintView& constraint) {
    if (!counts_here(c)) return;
    const int number = static_cast<int>(c);
    if (const auto* requirement = constraint.as<Requirement>())
      add(*requirement, scale.whole(constraint.weight), number, scale);
    else if (const auto* cardinality = constraint.as<Cardinality>())
      add(*cardinality, scale.whole(constraint.weight), number);
    else if (const auto* pair = constraint.as<PairTable>())
      pairs.push_back({pair->a, pair->b, pair->table, constraint.weight, number});
  });
  sort();
  place_clashes();
}

void Outline::add(const Conflict& body, Cost weight, int constraint) {
  if (weight == 0) return tiny_.push_back(constraint);
  if (body.a == body.b) {
    Cost& cost = own[at(literal(body.a))];
    cost = std::min(cost + weight, kTop);
    by_itself_.emplace_back(literal(body.a), constraint);
  }
  if (body.a.variable == body.b.variable) return;
  ++first_clash[at(literal(body.a)) + 1];
  ++first_clash[at(literal(body.b)) + 1];
  price.push_back(weight);
  conflict.push_back(constraint);
}

/// The literals' clashes have been counted. Asking the problem again takes less than keeping what it said.
void Outline::place_clashes() {
  for (std::size_t i = 1; i < first_clash.size(); ++i) first_clash[i] += first_clash[i - 1];
  clashes.resize(first_clash.back());
  std::vector<std::size_t> next(first_clash.begin(), first_clash.end() - 1);
  for (std::size_t k = 0; k < conflict.size(); ++k) {
    const Conflict& body = problem_->conflict(at(conflict[k]));
    const int a = literal(body.a), b = literal(body.b);
    clashes[next[at(a)]++] = {b, static_cast<int>(k)};
    clashes[next[at(b)]++] = {a, static_cast<int>(k)};
  }
}

void Outline::add(const Requirement& body, Cost weight, int constraint, const Scale& scale) {
  Need need{literal(body.literal), weight, constraint, props.size(), 0};
  for (const Support& support : body.supports) {
    const Cost cost = scale.whole(support.cost);
    if (support.literal == body.literal) need.weight = std::min(need.weight, cost);  // supports itself
    if (support.literal.variable != body.literal.variable) props.push_back({literal(support.literal), cost});
  }
  if (need.weight == 0) props.resize(need.first);
  const auto first = props.begin() + static_cast<std::ptrdiff_t>(need.first);
  if (!std::is_sorted(first, props.end())) std::sort(first, props.end());
  const auto same = [](const Prop& a, const Prop& b) { return a.literal == b.literal; };  // the cheapest of them comes first
  props.erase(std::unique(first, props.end(), same), props.end());
  need.last = props.size();
  if (need.weight > 0)
    needs.push_back(need);
  else
    tiny_.push_back(constraint);
}

void Outline::add(const Cardinality& body, Cost weight, int constraint) {
  Count count{body.condition ? literal(*body.condition) : -1, body.low, body.high, weight, constraint, {}};
  for (const Literal& member : body.literals) count.literals.push_back(literal(member));
  std::sort(count.literals.begin(), count.literals.end());
  count.literals.erase(std::unique(count.literals.begin(), count.literals.end()), count.literals.end());
  if (body.condition) {
    std::erase_if(count.literals, [&](int member) {
      if (variable(member) != body.condition->variable) return false;
      if (member == count.condition) --count.low, --count.high;  // holds whenever it matters; other labels never do
      return true;
    });
  }
  counts.push_back(std::move(count));
}

std::vector<int> Outline::relevant(std::span<const int> assignment) const {
  std::vector<int> all = tiny_;
  const auto holds = [&](int literal) { return assignment[at(variable(literal))] == label(literal); };
  for (int v = 0; v < variables(); ++v) {
    const int held = first_label[at(v)] + assignment[at(v)];
    for (const Clash& clash : clashes_of(held))
      if (clash.other > held && holds(clash.other)) all.push_back(conflict[at(clash.number)]);
    for (const Need& need : needs_of(held)) all.push_back(need.constraint);
  }
  for (const auto& [literal, constraint] : by_itself_)
    if (holds(literal)) all.push_back(constraint);
  for (const Count& count : counts) all.push_back(count.constraint);
  for (const Pair& pair : pairs) {
    const double entry = problem_->table(pair.table)[at(assignment[at(pair.a)] * problem_->table_size(pair.table).second + assignment[at(pair.b)])];
    if (entry > 0) all.push_back(pair.constraint);
  }
  std::sort(all.begin(), all.end());
  return all;
}

void Outline::sort() {
  std::sort(pairs.begin(), pairs.end());
  std::stable_sort(counts.begin(), counts.end(), [](const Count& a, const Count& b) {
    return std::tie(a.condition, a.low, a.high, a.weight, a.literals) < std::tie(b.condition, b.low, b.high, b.weight, b.literals);
  });
  std::stable_sort(needs.begin(), needs.end(), [&](const Need& a, const Need& b) {
    if (a.owner != b.owner || a.weight != b.weight) return std::tie(a.owner, a.weight) < std::tie(b.owner, b.weight);
    const auto of_a = props_of(a), of_b = props_of(b);
    return std::lexicographical_compare(of_a.begin(), of_a.end(), of_b.begin(), of_b.end());
  });
  first_need.assign(own.size() + 1, 0);
  for (const Need& need : needs) ++first_need[at(need.owner) + 1];
  for (std::size_t l = 1; l < first_need.size(); ++l) first_need[l] += first_need[l - 1];
}

}  // namespace scenelore::engine
