#include "component.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <tuple>

#include "reduction.hpp"

namespace scenelore::engine {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

bool is_in(const Decomposition& parts, const Literal& literal) {
  return parts.label_in[index(literal.variable)][index(literal.label)] >= 0;
}

/// The variables that a constraint makes depend on each other.
void for_each_variable(const Decomposition& parts, const Constraint& constraint, const auto& visit) {
  if (const auto* conflict = std::get_if<Conflict>(&constraint.body)) {
    if (!is_in(parts, conflict->a) || !is_in(parts, conflict->b)) return;
    visit(conflict->a.variable);
    visit(conflict->b.variable);
  } else if (const auto* requirement = std::get_if<Requirement>(&constraint.body)) {
    if (!is_in(parts, requirement->literal)) return;
    visit(requirement->literal.variable);
    for (const Support& support : requirement->supports)
      if (is_in(parts, support.literal)) visit(support.literal.variable);
  } else if (const auto* cardinality = std::get_if<Cardinality>(&constraint.body)) {
    if (cardinality->condition) {
      if (!is_in(parts, *cardinality->condition)) return;
      visit(cardinality->condition->variable);
    }
    for (const Literal& literal : cardinality->literals)
      if (is_in(parts, literal)) visit(literal.variable);
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
  void unary(std::vector<std::vector<Cost>>& costs, const Constraint& constraint) const {
    const auto* conflict = std::get_if<Conflict>(&constraint.body);
    if (conflict == nullptr || conflict->a != conflict->b || !is_in(parts_, conflict->a)) return;
    Cost& cost = costs[index(conflict->a.variable)][index(number(conflict->a))];
    cost = std::min(cost + scale_.whole(constraint.weight), kTop);
  }

  void add(int constraint_number, const Constraint& constraint) {
    number_ = constraint_number;
    weight_ = scale_.whole(constraint.weight);
    real_weight_ = constraint.weight;
    std::visit([this](const auto& body) { translate(body); }, constraint.body);
  }

  /// Hands the functions of many variables to their networks, in an order that depends on nothing but themselves.
  void finish() {
    std::stable_sort(requirements_.begin(), requirements_.end(), [](const auto& a, const auto& b) {
      return std::tie(a.second.x, a.second.label, a.second.weight, a.second.members) <
             std::tie(b.second.x, b.second.label, b.second.weight, b.second.members);
    });
    std::stable_sort(cardinalities_.begin(), cardinalities_.end(), [](const auto& a, const auto& b) {
      return std::tie(a.second.x, a.second.label, a.second.low, a.second.high, a.second.weight, a.second.members) <
             std::tie(b.second.x, b.second.label, b.second.low, b.second.high, b.second.weight, b.second.members);
    });
    for (auto& [variable, function] : requirements_) network(variable).add_requirement(std::move(function));
    for (auto& [variable, function] : cardinalities_) network(variable).add_cardinality(std::move(function));
  }

 private:
  Network& network(int v) { return parts_.components[index(parts_.component_of[index(v)])].network; }
  int local(int v) const { return parts_.index_in[index(v)]; }
  const std::vector<int>& labels(int v) const {
    return parts_.components[index(parts_.component_of[index(v)])].labels[index(local(v))];
  }
  /// The label's number in its component, −1 = it takes no part.
  int number(const Literal& literal) const { return parts_.label_in[index(literal.variable)][index(literal.label)]; }

  void translate(const Conflict& conflict) {
    Literal a = conflict.a, b = conflict.b;
    if (a.variable == b.variable) return;  // either never both, or a label cost: see unary()
    if (a.variable > b.variable) std::swap(a, b);
    const int label_a = number(a), label_b = number(b);
    if (label_a < 0 || label_b < 0) return;
    network(a.variable).add_binary(local(a.variable), local(b.variable), label_a, label_b, weight_, number_);
  }

  void translate(const PairTable& pair) {
    const bool swapped = pair.a > pair.b;
    const int x = swapped ? pair.b : pair.a, y = swapped ? pair.a : pair.b;
    const std::vector<double>& entries = problem_.table(pair.table);
    const int columns = problem_.table_size(pair.table).second;
    const auto fill = [&] {
      table_.clear();
      for (const int i : labels(x))
        for (const int j : labels(y)) {
          const double entry = entries[index(swapped ? j * columns + i : i * columns + j)];
          table_.push_back(!(entry > 0) ? 0 : is_forbidden(weight_) ? kTop : scale_.whole(entry * real_weight_));
        }
      return network(x).add_table(table_);
    };
    const auto is_whole = [&](int v) { return labels(v).size() == problem_.variables()[index(v)].labels.size(); };
    int table = -1;
    if (is_whole(x) && is_whole(y)) {
      const auto key = std::tuple(parts_.component_of[index(x)], pair.table, swapped, real_weight_);
      const auto [known, fresh] = whole_tables_.try_emplace(key, -1);
      if (fresh) known->second = fill();
      table = known->second;
    } else {
      table = fill();
    }
    network(x).add_binary(local(x), local(y), table, number_);
  }

  void translate(const Requirement& requirement) {
    const int owner = requirement.literal.variable;
    RequirementFunction f{local(owner), number(requirement.literal), weight_, number_};
    if (f.label < 0) return;
    std::vector<std::tuple<int, int, Cost>> supports;
    for (const Support& support : requirement.supports) {
      const Cost cost = scale_.whole(support.cost);
      if (support.literal == requirement.literal) f.weight = std::min(f.weight, cost);  // supports itself
      if (support.literal.variable == owner || number(support.literal) < 0) continue;
      supports.emplace_back(local(support.literal.variable), number(support.literal), cost);
    }
    if (f.weight == 0) return;
    std::sort(supports.begin(), supports.end());
    std::pair last{-1, -1};
    for (const auto& [variable, label, cost] : supports) {
      if (cost >= f.weight || last == std::pair{variable, label}) continue;  // the cheapest of equal ones came first
      last = {variable, label};
      if (f.members.empty() || f.members.back().variable != variable) f.members.push_back({variable});
      f.members.back().supports.emplace_back(label, cost);
    }
    requirements_.emplace_back(owner, std::move(f));
  }

  void translate(const Cardinality& cardinality) {
    CardinalityFunction f{-1, -1, -1, cardinality.low, cardinality.high, weight_, {}, number_};
    int anywhere = -1;
    if (cardinality.condition) {
      anywhere = cardinality.condition->variable;
      f.x = local(anywhere);
      f.label = number(*cardinality.condition);
      if (f.label < 0) return;
    }
    std::map<int, std::vector<char>> members;
    for (const Literal& literal : std::set(cardinality.literals.begin(), cardinality.literals.end())) {
      if (cardinality.condition && literal.variable == cardinality.condition->variable) {
        if (literal != *cardinality.condition) continue;  // does not hold when it matters
        f.low -= 1;                                       // holds whenever it matters
        f.high -= 1;
        continue;
      }
      if (number(literal) < 0) continue;
      anywhere = literal.variable;
      auto& counts =
          members.try_emplace(local(literal.variable), labels(literal.variable).size(), char{0}).first->second;
      counts[index(number(literal))] = 1;
    }
    if (anywhere < 0) return constant(f);
    for (auto& [variable, counts] : members) f.members.push_back({variable, -1, std::move(counts)});
    cardinalities_.emplace_back(anywhere, std::move(f));
  }

  void constant(const CardinalityFunction& f) {
    const Cost cost = f.violation(0);
    if (is_forbidden(cost) && parts_.broken < 0) parts_.broken = number_;
    parts_.constant = std::min(parts_.constant + cost, kTop);
  }

  const Problem& problem_;
  const Scale& scale_;
  Decomposition& parts_;
  std::vector<std::pair<int, RequirementFunction>> requirements_;  ///< with a variable of their network
  std::vector<std::pair<int, CardinalityFunction>> cardinalities_;
  std::map<std::tuple<int, int, bool, double>, int> whole_tables_;  ///< by component, table, direction, weight
  std::vector<Cost> table_;
  int number_ = -1;
  Cost weight_ = 0;
  double real_weight_ = 0;
};

/// Which labels take part, and which variables hang together.
void select_labels(const Problem& problem, const Selection& selection, Decomposition& result) {
  for (std::size_t v = 0; v < problem.variables().size(); ++v) {
    std::vector<int>& numbers = result.label_in.emplace_back(problem.variables()[v].labels.size(), -1);
    int next = 0;
    for (std::size_t l = 0; l < numbers.size(); ++l)
      if (selection.labels.empty() || selection.labels[v][l] != 0) numbers[l] = next++;
  }
}

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

namespace {

/// The cheapest labels, whatever the constraints say.
Cost least_sum(const Component& component) {
  Cost sum = 0;
  for (int v = 0; v < component.network.variables(); ++v) {
    Cost least = kTop;
    for (int label = 0; label < component.network.labels(v); ++label)
      least = std::min(least, component.network.original(v, label));
    sum = std::min(sum + least, kTop);
  }
  return sum;
}

void propagate_roots(Decomposition& parts, Bound bound, Cost cutoff, Budget* budget, std::span<const int> world) {
  Cost sum = parts.constant;
  for (const Component& component : parts.components) sum = std::min(sum + least_sum(component), kTop);
  for (Component& component : parts.components) {
    const Cost others = sum - least_sum(component);
    component.network.set_shifting(bound == Bound::soft_consistency);
    component.network.close();
    if (!world.empty()) component.network.set_met(component.network.evaluate(part_of(parts, component, world)));
    component.network.set_limit(is_forbidden(cutoff) ? kTop / 2 : std::max<Cost>(0, cutoff - others));
    component.network.set_budget(budget);
    component.feasible = component.network.strengthen();
    component.network.set_budget(nullptr);
  }
}

}  // namespace

std::vector<int> part_of(const Decomposition& parts, const Component& component, std::span<const int> assignment) {
  std::vector<int> labels;
  for (const int v : component.variables) labels.push_back(parts.label_in[index(v)][index(assignment[index(v)])]);
  return labels;
}

Decomposition build_parts(const Problem& problem, const Scale& scale, const Selection& selection, Budget* budget) {
  const std::size_t count = problem.variables().size();
  const auto& constraints = problem.constraints();
  constexpr std::size_t kConstraintsBetweenLooks = 1024;
  const auto cut = [&](std::size_t c) {
    return budget != nullptr && c % kConstraintsBetweenLooks == 0 && budget->out_of_time();
  };
  const auto used = [&](std::size_t c) { return selection.constraints.empty() || selection.constraints[c] != 0; };
  Decomposition result;
  select_labels(problem, selection, result);
  result.component_of.assign(count, -1);
  result.index_in.assign(count, -1);
  Compiler compiler(problem, scale, result);
  std::vector<std::vector<Cost>> costs(count);
  for (std::size_t v = 0; v < count; ++v)
    for (std::size_t l = 0; l < result.label_in[v].size(); ++l)
      if (result.label_in[v][l] >= 0) costs[v].push_back(scale.whole(problem.variables()[v].costs[l]));
  Parts parts(count);
  for (std::size_t c = 0; c < constraints.size(); ++c) {
    if (cut(c)) return {.cut = true};
    if (!used(c)) continue;
    compiler.unary(costs, constraints[c]);
    int first = -1;
    for_each_variable(result, constraints[c], [&](int v) {
      if (first < 0)
        first = v;
      else
        parts.join(first, v);
    });
  }
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
    std::vector<int>& labels = component.labels.emplace_back();
    for (std::size_t l = 0; l < result.label_in[v].size(); ++l)
      if (result.label_in[v][l] >= 0) labels.push_back(static_cast<int>(l));
  }
  for (std::size_t c = 0; c < constraints.size(); ++c) {
    if (cut(c)) return {.cut = true};
    if (used(c)) compiler.add(static_cast<int>(c), constraints[c]);
  }
  compiler.finish();
  result.built = true;
  return result;
}

Decomposition decompose(const Problem& problem, const Scale& scale, Bound bound, const Selection& selection,
                        Cost cutoff, Budget* budget, std::span<const int> world) {
  Decomposition result = build_parts(problem, scale, selection, budget);
  if (!result.built) return result;
  propagate_roots(result, bound, cutoff, budget, world);
  result.cut = budget != nullptr && budget->out_of_time();
  return result;
}

}  // namespace scenelore::engine
