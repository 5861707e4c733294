#include "network.hpp"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <utility>

#include "proof_log.hpp"

namespace scenelore::engine {

int Network::add_variable(const std::vector<Cost>& costs) {
  assert(binary_.empty() && requirements_.empty() && cardinalities_.empty());
  start_empty();
  const int first = static_cast<int>(cost_.size());
  const int size = static_cast<int>(costs.size());
  variable_.push_back({first, size, size});
  for (int label = 0; label < size; ++label) {
    order_.push_back(label);
    position_.push_back(label);
    owner_.push_back(variables() - 1);
  }
  cost_.insert(cost_.end(), costs.begin(), costs.end());
  original_.insert(original_.end(), costs.begin(), costs.end());
  return variables() - 1;
}

/// Cell 0 is the bound, so label cells begin at 1 in all arrays.
void Network::start_empty() {
  if (!cost_.empty()) return;
  cost_.push_back(0);
  original_.push_back(0);
  order_.push_back(0);
  position_.push_back(0);
  owner_.push_back(-1);
}

int Network::new_cells(int count) {
  const int first = static_cast<int>(cost_.size());
  cost_.resize(cost_.size() + static_cast<std::size_t>(count), 0);
  return first;
}

int Network::add_table(const std::vector<Cost>& table) {
  std::size_t hash = table.size();
  for (const Cost cost : table) hash = (hash ^ static_cast<std::size_t>(cost)) * 0x9E3779B97F4A7C15u + (hash >> 29);
  const auto [first, last] = table_index_.equal_range(hash);
  for (auto known = first; known != last; ++known)
    if (tables_[static_cast<std::size_t>(known->second)] == table) return known->second;
  tables_.push_back(table);
  table_index_.emplace(hash, static_cast<int>(tables_.size()) - 1);
  return static_cast<int>(tables_.size()) - 1;
}

void Network::add_binary(int x, int y, int table, int constraint) {
  assert(x < y);
  pending_.resize(variable_.size());
  pending_[static_cast<std::size_t>(x)].push_back({y, constraint, table, -1, 0});
}

void Network::add_binary(int x, int y, int label_x, int label_y, Cost cost, int constraint) {
  assert(x < y);
  pending_.resize(variable_.size());
  pending_[static_cast<std::size_t>(x)].push_back({y, constraint, -1, label_x * labels(y) + label_y, cost});
}

/// Adds up what is pending between x and each other variable, in ascending order of these. `function_with[y]` is −1 for
/// all y, before and after.
void Network::close_binary(int x, std::vector<int>& function_with) {
  struct Sum {
    int y, constraint, table;
    std::vector<Cost> costs;  ///< empty: the table alone
  };
  std::vector<Sum> sums;
  for (const Pending& part : pending_[static_cast<std::size_t>(x)]) {
    int& place = function_with[static_cast<std::size_t>(part.y)];
    if (place < 0) {
      place = static_cast<int>(sums.size());
      sums.push_back({part.y, part.constraint, part.table, {}});
      if (part.table >= 0) continue;
    }
    Sum& sum = sums[static_cast<std::size_t>(place)];
    sum.constraint = std::min(sum.constraint, part.constraint);
    if (sum.costs.empty() && sum.table >= 0) sum.costs = tables_[static_cast<std::size_t>(sum.table)];
    if (sum.costs.empty()) sum.costs.assign(static_cast<std::size_t>(labels(x) * labels(part.y)), 0);
    const auto add = [&](std::size_t i, Cost cost) { sum.costs[i] = std::min(sum.costs[i] + cost, kTop); };
    if (part.table < 0) {
      add(static_cast<std::size_t>(part.entry), part.cost);
      continue;
    }
    const std::vector<Cost>& table = tables_[static_cast<std::size_t>(part.table)];
    for (std::size_t i = 0; i < table.size(); ++i) add(i, table[i]);
  }
  std::sort(sums.begin(), sums.end(), [](const Sum& a, const Sum& b) { return a.y < b.y; });
  for (const Sum& sum : sums) {
    function_with[static_cast<std::size_t>(sum.y)] = -1;
    const int table = sum.costs.empty() ? sum.table : add_table(sum.costs);
    const std::vector<Cost>& costs = tables_[static_cast<std::size_t>(table)];
    if (std::all_of(costs.begin(), costs.end(), [](Cost cost) { return cost == 0; })) continue;
    const int index = static_cast<int>(binary_.size());
    const int x_cell = new_cells(labels(x));
    const int y_cell = new_cells(labels(sum.y));
    const int idle_cell = new_cells(1);
    binary_.push_back({x, sum.y, table, x_cell, y_cell, idle_cell, sum.constraint});
    links_[static_cast<std::size_t>(x)].push_back({index, sum.y});
    links_[static_cast<std::size_t>(sum.y)].push_back({index, x});
  }
}

void Network::add_requirement(RequirementFunction function) {
  function.x_cell = new_cells(labels(function.x));
  function.lifted_cell = new_cells(1);
  function.shifted_cell = new_cells(1);
  for (std::size_t j = 0; j < function.members.size(); ++j) {
    auto& member = function.members[j];
    member.cell = new_cells(labels(member.variable));
    for (const auto& [label, cost] : member.supports)
      function.supports.push_back({static_cast<int>(j), member.variable, static_cast<int>(cell(member.variable, label)),
                                   member.cell + label, cost});
  }
  requirements_.push_back(std::move(function));
}

void Network::add_cardinality(CardinalityFunction function) {
  function.x_cell = function.x < 0 ? -1 : new_cells(labels(function.x));
  for (auto& member : function.members) member.cell = new_cells(labels(member.variable));
  cardinalities_.push_back(std::move(function));
}

void Network::close() {
  start_empty();
  const auto count = static_cast<std::size_t>(variables());
  links_.resize(count);
  globals_.resize(count);
  pending_.resize(count);
  std::vector<int> function_with(count, -1);
  for (int x = 0; x < variables(); ++x) close_binary(x, function_with);
  pending_ = {};
  watchers_.resize(original_.size());
  const auto watch = [&](int v, int global) {
    globals_[static_cast<std::size_t>(v)].push_back(global);
    for (int label = 0; label < labels(v); ++label) watchers_[cell(v, label)].push_back(global);
  };
  for (std::size_t r = 0; r < requirements_.size(); ++r) {
    const RequirementFunction& function = requirements_[r];
    const int global = static_cast<int>(r);
    watch(function.x, global);
    for (const auto& member : function.members) {
      globals_[static_cast<std::size_t>(member.variable)].push_back(global);
      for (const auto& [label, cost] : member.supports) watchers_[cell(member.variable, label)].push_back(global);
    }
    dirty_requirements_.resize(static_cast<int>(requirements_.size()));
  }
  for (std::size_t c = 0; c < cardinalities_.size(); ++c) {
    const CardinalityFunction& function = cardinalities_[c];
    const int global = ~static_cast<int>(c);
    if (function.x >= 0) watch(function.x, global);
    for (const auto& member : function.members) watch(member.variable, global);
    dirty_cardinalities_.resize(static_cast<int>(cardinalities_.size()));
  }
  saved_at_.assign(cost_.size(), 0);
  spent_.assign(original_.size(), 0);
  support_.assign(count, 0);
  reduced_.resize(variables());
  raised_.resize(variables());
  checks_.resize(variables());
  std::size_t most = 0;
  for (const Domain& domain : variable_) most = std::max(most, static_cast<std::size_t>(domain.size));
  gain_.assign(most, 0);
  // Shifts of next to nothing are not worth their time: a 4096th of the mean label cost.
  Cost sum = 0, terms = 1;
  for (const Cost cost : original_)
    if (cost > 0 && !is_forbidden(cost)) sum += cost, ++terms;
  least_gain_ = std::max<Cost>(1, sum / terms / 4096);
  granularity_ = common_divisor();
  // Forbidden labels go, and all is to be looked at once.
  for (int v = 0; v < variables(); ++v) {
    rank_.push_back(v);
    by_rank_.push_back(v);
    reduced_.insert(v);
    raised_.insert(v);
    checks_.insert(v);
  }
  for (int r = 0; r < static_cast<int>(requirements_.size()); ++r) dirty_requirements_.insert(r);
  for (int c = 0; c < static_cast<int>(cardinalities_.size()); ++c) dirty_cardinalities_.insert(c);
}

/// Of all costs that an assignment can have; 1 as a rule, but problems of whole costs are easier for it.
Cost Network::common_divisor() const {
  Cost divisor = 0;
  const auto add = [&divisor](Cost cost) {
    if (divisor != 1 && !is_forbidden(cost)) divisor = std::gcd(divisor, cost);
  };
  for (const Cost cost : original_) add(cost);
  for (const BinaryFunction& f : binary_)
    for (const Cost cost : tables_[static_cast<std::size_t>(f.table)]) add(cost);
  for (const RequirementFunction& f : requirements_) {
    add(f.weight);
    for (const auto& support : f.supports) add(support.cost);
  }
  for (const CardinalityFunction& f : cardinalities_) add(f.weight);
  return std::max<Cost>(1, divisor);
}

Cost Network::evaluate(std::span<const int> assignment) const {
  const auto value_of = [&](int v) { return assignment[static_cast<std::size_t>(v)]; };
  Cost sum = 0;
  const auto add = [&sum](Cost cost) { sum = std::min(sum + cost, kTop); };
  for (int v = 0; v < variables(); ++v) add(original_[cell(v, value_of(v))]);
  for (const BinaryFunction& f : binary_)
    add(tables_[static_cast<std::size_t>(f.table)]
               [static_cast<std::size_t>(value_of(f.x) * labels(f.y) + value_of(f.y))]);
  for (const RequirementFunction& f : requirements_) {
    if (value_of(f.x) != f.label) continue;
    Cost least = f.weight;
    for (const auto& support : f.supports)
      if (static_cast<int>(cell(support.variable, value_of(support.variable))) == support.label_cell)
        least = std::min(least, support.cost);
    add(least);
  }
  for (const CardinalityFunction& f : cardinalities_) {
    if (f.x >= 0 && value_of(f.x) != f.label) continue;
    int count = 0;
    for (const auto& member : f.members) count += member.counts[static_cast<std::size_t>(value_of(member.variable))];
    add(f.violation(count));
  }
  return sum;
}

Cost Network::evaluate_shifted(std::span<const int> assignment) const {
  // The shifts cancel out in the sum, so that it suffices to add them to the original functions.
  Cost sum = evaluate(assignment);
  if (is_forbidden(sum)) return kTop;
  sum += bound();
  const auto value_of = [&](int v) { return assignment[static_cast<std::size_t>(v)]; };
  for (int v = 0; v < variables(); ++v) sum += unary(v, value_of(v)) - original(v, value_of(v));
  for (const BinaryFunction& f : binary_) sum -= cost_at(f.x_cell + value_of(f.x)) + cost_at(f.y_cell + value_of(f.y));
  for (const RequirementFunction& f : requirements_) {
    sum -= cost_at(f.x_cell + value_of(f.x));
    for (const auto& member : f.members) sum -= cost_at(member.cell + value_of(member.variable));
  }
  for (const CardinalityFunction& f : cardinalities_) {
    if (f.x >= 0) sum -= cost_at(f.x_cell + value_of(f.x));
    for (const auto& member : f.members) sum -= cost_at(member.cell + value_of(member.variable));
  }
  return sum;
}

void Network::round(std::vector<int>& assignment) const {
  assignment.resize(variable_.size());
  for (int v = 0; v < variables(); ++v) {
    int best = support_[static_cast<std::size_t>(v)];
    Cost least = is_live(v, best) ? unary(v, best) : kTop;
    for (const int label : live(v))
      if (unary(v, label) < least) best = label, least = unary(v, label);
    assignment[static_cast<std::size_t>(v)] = best;
  }
}

int Network::open_pairs() const {
  return static_cast<int>(std::count_if(binary_.begin(), binary_.end(), [&](const BinaryFunction& f) {
    return at(f.x).live > 1 && at(f.y).live > 1 && cost_at(f.idle_cell) == 0;
  }));
}

void Network::push() {
  marks_.push_back({saved_costs_.size(), saved_domains_.size()});
  stamps_.push_back(stamp_);
  stamp_ = ++next_stamp_;
}

void Network::pop() {
  const Mark mark = marks_.back();
  marks_.pop_back();
  for (; saved_costs_.size() > mark.costs; saved_costs_.pop_back())
    cost_[static_cast<std::size_t>(saved_costs_.back().cell)] = saved_costs_.back().cost;
  for (; saved_domains_.size() > mark.domains; saved_domains_.pop_back())
    variable_[static_cast<std::size_t>(saved_domains_.back().variable)].live = saved_domains_.back().live;
  stamp_ = stamps_.back();
  stamps_.pop_back();
  reduced_.clear();
  raised_.clear();
  checks_.clear();
  dirty_requirements_.clear();
  dirty_cardinalities_.clear();
}

void Network::save(int cell) {
  const auto i = static_cast<std::size_t>(cell);
  saved_at_[i] = stamp_;
  saved_costs_.push_back({cell, cost_[i]});
}

void Network::log(int cell) { log_->changed(cell); }

bool Network::strike(int v, int label) {
  if (log_ != nullptr && is_live(v, label)) log_->struck(v, label);
  return remove(v, label);
}

bool Network::fail(int v) {
  failed_variable_ = v;
  return false;
}

bool Network::assign(int v, int label) {
  for (int i = at(v).live - 1; i >= 0; --i) {
    const int other = order_[static_cast<std::size_t>(at(v).first + i)];
    if (other != label && !remove(v, other)) return false;
  }
  return at(v).live == 1 || fail(v);
}

bool Network::remove(int v, int label) {
  Domain& domain = variable_[static_cast<std::size_t>(v)];
  const std::size_t here = cell(v, label);
  if (position_[here] >= domain.live) return true;
  if (!marks_.empty()) saved_domains_.push_back({v, domain.live});
  const int last = --domain.live;
  const int moved = order_[static_cast<std::size_t>(domain.first + last)];
  std::swap(order_[static_cast<std::size_t>(domain.first + position_[here])],
            order_[static_cast<std::size_t>(domain.first + last)]);
  std::swap(position_[here], position_[cell(v, moved)]);
  reduced_.insert(v);
  for (const int global : watchers_[here]) {
    if (global >= 0)
      dirty_requirements_.insert(global);
    else
      dirty_cardinalities_.insert(~global);
  }
  return domain.live > 0 || fail(v);
}

}  // namespace scenelore::engine
