#include "scenelore/engine/problem.hpp"

#include <utility>

#include "scenelore/engine/error.hpp"

namespace scenelore::engine {
namespace {

/// Checks the parts of one constraint and names it when one of them makes no sense.
class Inspector {
 public:
  Inspector(const Problem& problem, const std::string& name) : problem_(problem), name_(name) {}

  [[noreturn]] void fail(const std::string& what) const { throw Error("constraint '" + name_ + "': " + what); }

  void variable(int index) const {
    const auto count = static_cast<int>(problem_.variables().size());
    if (index < 0 || index >= count)
      fail("there is no variable " + std::to_string(index) + ", the problem has " + std::to_string(count));
  }

  void literal(const Literal& literal) const {
    variable(literal.variable);
    const Variable& owner = problem_.variables()[static_cast<std::size_t>(literal.variable)];
    if (literal.label < 0 || literal.label >= static_cast<int>(owner.labels.size()))
      fail("variable '" + owner.name + "' has no label " + std::to_string(literal.label) + ", it has " +
           std::to_string(owner.labels.size()));
  }

  bool exists(const Literal& literal) const {
    const std::vector<Variable>& variables = problem_.variables();
    return static_cast<std::size_t>(literal.variable) < variables.size() &&
           static_cast<std::size_t>(literal.label) < variables[static_cast<std::size_t>(literal.variable)].costs.size();
  }

  void weight(double weight) const {
    if (!(weight > 0)) fail("its weight is " + std::to_string(weight) + "; a weight is > 0, or kHard");
  }

  void body(const Conflict& conflict, double) const {
    literal(conflict.a);
    literal(conflict.b);
  }

  void body(const Requirement& requirement, double weight) const {
    literal(requirement.literal);
    for (const Support& support : requirement.supports) {
      if (!exists(support.literal)) literal(support.literal);
      if (!(support.cost >= 0) || support.cost > weight)
        fail("a support costs " + std::to_string(support.cost) + "; that must lie between 0 and the weight");
    }
  }

  void body(const Cardinality& cardinality, double) const {
    if (cardinality.condition) literal(*cardinality.condition);
    for (const Literal& member : cardinality.literals) literal(member);
  }

  void body(const PairTable& pair, double) const {
    variable(pair.a);
    variable(pair.b);
    if (pair.a == pair.b) fail("a pair table needs two different variables");
    if (pair.table < 0 || pair.table >= problem_.tables()) fail("there is no table " + std::to_string(pair.table));
    const auto& variables = problem_.variables();
    const auto labels_a = static_cast<int>(variables[static_cast<std::size_t>(pair.a)].labels.size());
    const auto labels_b = static_cast<int>(variables[static_cast<std::size_t>(pair.b)].labels.size());
    if (problem_.table_size(pair.table) != std::pair{labels_a, labels_b})
      fail("table " + std::to_string(pair.table) + " does not fit the " + std::to_string(labels_a) + " x " +
           std::to_string(labels_b) + " labels of its variables");
  }

 private:
  const Problem& problem_;
  const std::string& name_;
};

constexpr std::uint32_t kMostBodies = (1U << 30) - 1;  // memory ends long before

/// Names are short, and there are tens of thousands to compare: without a call.
bool same_text(const std::string& a, const std::string& b) {
  if (a.size() != b.size()) return false;
  const char *const x = a.data(), *const y = b.data();
  for (std::size_t i = a.size(); i-- > 0;)  // from the end, where neighbours differ
    if (x[i] != y[i]) return false;
  return true;
}

void require_cost(double cost, const std::string& whose) {
  if (!(cost >= 0)) throw Error(whose + ": a cost is " + std::to_string(cost) + "; costs are >= 0, or infinite");
}

}  // namespace

int Problem::add_variable(std::string name, std::vector<std::string> labels, std::vector<double> costs) {
  const std::string whose = "variable '" + name + "'";
  if (labels.empty()) throw Error(whose + " has no labels");
  if (labels.size() != costs.size())
    throw Error(whose + " has " + std::to_string(labels.size()) + " labels, but " + std::to_string(costs.size()) +
                " costs");
  for (const double cost : costs) require_cost(cost, whose);
  ++revision_;
  variables_.push_back({std::move(name), std::move(labels), std::move(costs)});
  return static_cast<int>(variables_.size()) - 1;
}

void Problem::set_cost(Literal literal, double cost) {
  const std::string name = "set_cost";
  Inspector(*this, name).literal(literal);
  Variable& variable = variables_[static_cast<std::size_t>(literal.variable)];
  require_cost(cost, "variable '" + variable.name + "'");
  variable.costs[static_cast<std::size_t>(literal.label)] = cost;
  ++revision_;
}

void Problem::drop(int constraint) {
  if (constraint < 0 || constraint >= static_cast<int>(heads_.size()))
    throw Error("drop: there is no constraint " + std::to_string(constraint));
  Head& head = heads_[static_cast<std::size_t>(constraint)];
  head.body = static_cast<std::uint32_t>(cardinalities_.size()) & kMostBodies;
  head.kind = Kind::cardinality;
  cardinalities_.emplace_back();
  ++revision_;
}

void Problem::reserve(std::size_t constraints) {
  heads_.reserve(constraints);
  conflicts_.reserve(constraints);
}

std::uint32_t Problem::call_of_next(const std::string& name, std::int64_t reference) {
  const bool same = !calls_.empty() && calls_.back().reference == reference && same_text(calls_.back().name, name);
  if (!same) calls_.push_back({name, reference});
  return static_cast<std::uint32_t>(calls_.size() - 1);
}

int Problem::add_head(const std::string& name, double weight, std::int64_t reference, Kind kind, std::size_t body) {
  Head head{weight, call_of_next(name, reference)};
  head.body = static_cast<std::uint32_t>(body) & kMostBodies;
  head.kind = kind;
  heads_.push_back(head);
  ++revision_;
  return static_cast<int>(heads_.size()) - 1;
}

int Problem::add_table(int labels_a, int labels_b, std::vector<double> costs) {
  const std::string whose = "table " + std::to_string(tables_.size());
  if (labels_a < 1 || labels_b < 1 ||
      costs.size() != static_cast<std::size_t>(labels_a) * static_cast<std::size_t>(labels_b))
    throw Error(whose + ": " + std::to_string(costs.size()) + " costs for " + std::to_string(labels_a) + " x " +
                std::to_string(labels_b) + " labels");
  for (const double cost : costs) require_cost(cost, whose);
  tables_.push_back({labels_a, labels_b, std::move(costs)});
  return static_cast<int>(tables_.size()) - 1;
}

int Problem::add(std::string name, double weight, std::int64_t reference,
                 std::variant<Conflict, Requirement, Cardinality, PairTable> body) {
  const Inspector inspector(*this, name);
  inspector.weight(weight);
  std::visit([&](const auto& part) { inspector.body(part, weight); }, body);
  const auto keep = [&](auto& list, Kind kind, auto& part) {
    list.push_back(std::move(part));
    return add_head(name, weight, reference, kind, list.size() - 1);
  };
  if (auto* requirement = std::get_if<Requirement>(&body)) return keep(requirements_, Kind::requirement, *requirement);
  if (auto* cardinality = std::get_if<Cardinality>(&body)) return keep(cardinalities_, Kind::cardinality, *cardinality);
  if (auto* pair = std::get_if<PairTable>(&body)) return keep(pair_tables_, Kind::pair_table, *pair);
  return keep(conflicts_, Kind::conflict, std::get<Conflict>(body));
}

int Problem::add(const std::string& name, double weight, std::int64_t reference, const Conflict& conflict) {
  const WeightedConflict one{weight, conflict};
  add(name, reference, std::span(&one, 1));
  return static_cast<int>(heads_.size()) - 1;
}

void Problem::add(const std::string& name, std::int64_t reference, std::span<const WeightedConflict> conflicts) {
  if (conflicts.empty()) return;
  const Inspector inspector(*this, name);
  for (const auto& [weight, conflict] : conflicts) {
    if (weight > 0 && inspector.exists(conflict.a) && inspector.exists(conflict.b)) continue;
    inspector.weight(weight);
    inspector.body(conflict, weight);
  }
  Head head{0, call_of_next(name, reference)};
  head.kind = Kind::conflict;
  const std::size_t first_head = heads_.size(), first = conflicts_.size();
  heads_.resize(first_head + conflicts.size());
  conflicts_.resize(first + conflicts.size());
  for (std::size_t i = 0; i < conflicts.size(); ++i) {
    head.weight = conflicts[i].weight;
    head.body = static_cast<std::uint32_t>(first + i) & kMostBodies;
    heads_[first_head + i] = head;
    conflicts_[first + i] = conflicts[i].conflict;
  }
  revision_ += conflicts.size();
}

}  // namespace scenelore::engine
