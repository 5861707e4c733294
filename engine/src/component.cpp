#include "component.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include "reduction.hpp"

namespace scenelore::engine {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

void for_each_variable(const Constraint& constraint, const auto& visit) {
  if (const auto* conflict = std::get_if<Conflict>(&constraint.body)) {
    visit(conflict->a.variable);
    visit(conflict->b.variable);
  } else if (const auto* requirement = std::get_if<Requirement>(&constraint.body)) {
    visit(requirement->literal.variable);
    for (const Support& support : requirement->supports) visit(support.literal.variable);
  } else if (const auto* cardinality = std::get_if<Cardinality>(&constraint.body)) {
    if (cardinality->condition) visit(cardinality->condition->variable);
    for (const Literal& literal : cardinality->literals) visit(literal.variable);
  } else if (const auto* pair = std::get_if<PairTable>(&constraint.body)) {
    visit(pair->a);
    visit(pair->b);
  }
}

/// Translates constraints into functions of the networks.
class Compiler {
 public:
  Compiler(const Problem& problem, const Scale& scale, Decomposition& parts)
      : problem_(problem), scale_(scale), parts_(parts) {}

  /// Costs that one variable alone decides, before its network has functions.
  void unary(std::vector<std::vector<Cost>>& costs, const Constraint& constraint) {
    const auto* conflict = std::get_if<Conflict>(&constraint.body);
    if (conflict == nullptr || conflict->a != conflict->b) return;
    Cost& cost = costs[index(conflict->a.variable)][index(conflict->a.label)];
    cost = std::min(cost + scale_.whole(constraint.weight), kTop);
  }

  void add(int number, const Constraint& constraint) {
    number_ = number;
    weight_ = scale_.whole(constraint.weight);
    real_weight_ = constraint.weight;
    std::visit([this](const auto& body) { translate(body); }, constraint.body);
  }

 private:
  Network& network(int v) { return parts_.components[index(parts_.component_of[index(v)])].network; }
  int local(int v) const { return parts_.index_in[index(v)]; }
  int labels(int v) const { return static_cast<int>(problem_.variables()[index(v)].labels.size()); }

  void translate(const Conflict& conflict) {
    Literal a = conflict.a, b = conflict.b;
    if (a.variable == b.variable) return;  // either never both, or a label cost: see unary()
    if (a.variable > b.variable) std::swap(a, b);
    network(a.variable).add_binary(local(a.variable), local(b.variable), a.label, b.label, weight_, number_);
  }

  void translate(const PairTable& pair) {
    const std::vector<double>& entries = problem_.table(pair.table);
    const bool hard = is_forbidden(weight_);
    const bool swapped = pair.a > pair.b;
    const int rows = labels(pair.a), columns = labels(pair.b);
    std::vector<Cost> table(entries.size());
    for (int i = 0; i < rows; ++i)
      for (int j = 0; j < columns; ++j) {
        const double entry = entries[index(i * columns + j)];
        const Cost cost = !(entry > 0) ? 0 : hard ? kTop : scale_.whole(entry * real_weight_);
        table[index(swapped ? j * rows + i : i * columns + j)] = cost;
      }
    network(pair.a).add_binary(local(std::min(pair.a, pair.b)), local(std::max(pair.a, pair.b)), table, number_);
  }

  void translate(const Requirement& requirement) {
    const int owner = requirement.literal.variable;
    RequirementFunction f{local(owner), requirement.literal.label, weight_, number_};
    std::map<int, std::map<int, Cost>> members;
    for (const Support& support : requirement.supports) {
      const Cost cost = scale_.whole(support.cost);
      if (support.literal == requirement.literal) f.weight = std::min(f.weight, cost);  // supports itself
      if (support.literal.variable == owner) continue;
      Cost& entry = members[local(support.literal.variable)].try_emplace(support.literal.label, kTop).first->second;
      entry = std::min(entry, cost);
    }
    if (f.weight == 0) return;
    for (const auto& [variable, costs] : members) {
      RequirementFunction::Member member{variable};
      for (const auto& [label, cost] : costs)
        if (cost < f.weight) member.supports.emplace_back(label, cost);
      if (!member.supports.empty()) f.members.push_back(std::move(member));
    }
    network(owner).add_requirement(std::move(f));
  }

  void translate(const Cardinality& cardinality) {
    CardinalityFunction f{-1, -1, -1, cardinality.low, cardinality.high, weight_, {}, number_};
    int anywhere = -1;
    if (cardinality.condition) {
      anywhere = cardinality.condition->variable;
      f.x = local(anywhere);
      f.label = cardinality.condition->label;
    }
    std::map<int, std::vector<char>> members;
    for (const Literal& literal : std::set(cardinality.literals.begin(), cardinality.literals.end())) {
      if (cardinality.condition && literal.variable == cardinality.condition->variable) {
        if (literal != *cardinality.condition) continue;  // does not hold when it matters
        f.low -= 1;                                       // holds whenever it matters
        f.high -= 1;
        continue;
      }
      anywhere = literal.variable;
      auto& counts =
          members.try_emplace(local(literal.variable), index(labels(literal.variable)), char{0}).first->second;
      counts[index(literal.label)] = 1;
    }
    if (anywhere < 0) return constant(f);
    for (auto& [variable, counts] : members) f.members.push_back({variable, -1, std::move(counts)});
    network(anywhere).add_cardinality(std::move(f));
  }

  void constant(const CardinalityFunction& f) {
    const Cost cost = f.violation(0);
    if (is_forbidden(cost) && parts_.broken < 0) parts_.broken = number_;
    parts_.constant = std::min(parts_.constant + cost, kTop);
  }

  const Problem& problem_;
  const Scale& scale_;
  Decomposition& parts_;
  int number_ = -1;
  Cost weight_ = 0;
  double real_weight_ = 0;
};

}  // namespace

Component::Component() = default;
Component::Component(Component&&) noexcept = default;
Component& Component::operator=(Component&&) noexcept = default;
Component::~Component() = default;

Parts::Parts(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }

int Parts::find(int v) {
  while (parent_[index(v)] != v) v = parent_[index(v)] = parent_[index(parent_[index(v)])];
  return v;
}

void Parts::join(int a, int b) {
  a = find(a);
  b = find(b);
  parent_[index(std::max(a, b))] = std::min(a, b);
}

Decomposition decompose(const Problem& problem, const Scale& scale, Bound bound, const std::vector<char>& use) {
  const std::size_t count = problem.variables().size();
  const auto& constraints = problem.constraints();
  const auto used = [&](std::size_t c) { return use.empty() || use[c] != 0; };
  Parts parts(count);
  for (std::size_t c = 0; c < constraints.size(); ++c) {
    if (!used(c)) continue;
    int first = -1;
    for_each_variable(constraints[c], [&](int v) {
      if (first < 0) first = v;
      parts.join(first, v);
    });
  }
  Decomposition result;
  result.component_of.assign(count, -1);
  result.index_in.assign(count, -1);
  Compiler compiler(problem, scale, result);
  std::vector<std::vector<Cost>> costs(count);
  for (std::size_t v = 0; v < count; ++v)
    for (const double cost : problem.variables()[v].costs) costs[v].push_back(scale.whole(cost));
  for (std::size_t c = 0; c < constraints.size(); ++c)
    if (used(c)) compiler.unary(costs, constraints[c]);
  for (std::size_t v = 0; v < count; ++v) {
    const auto root = index(parts.find(static_cast<int>(v)));
    if (root == v) {
      result.component_of[v] = static_cast<int>(result.components.size());
      result.components.emplace_back();
    }
    Component& component = result.components[index(result.component_of[root])];
    result.component_of[v] = result.component_of[root];
    result.index_in[v] = component.network.add_variable(costs[v]);
    component.variables.push_back(static_cast<int>(v));
  }
  for (std::size_t c = 0; c < constraints.size(); ++c)
    if (used(c)) compiler.add(static_cast<int>(c), constraints[c]);
  for (Component& component : result.components) {
    component.network.set_shifting(bound == Bound::soft_consistency);
    component.network.close();
    component.network.set_limit(kTop / 2);
    component.feasible = component.network.propagate();
  }
  return result;
}

}  // namespace scenelore::engine
