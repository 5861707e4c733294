#include <algorithm>

#include "network.hpp"

namespace scenelore::engine {
namespace {

/// Fills a table by asking for the cost of each tuple.
bool write_out(const Network& network, Table& table, std::size_t most, const auto& cost_of) {
  std::size_t size = 1;
  for (const int v : table.scope) {
    size *= static_cast<std::size_t>(network.labels(v));
    if (size > most) return false;
  }
  std::vector<int> tuple(table.scope.size(), 0);
  table.costs.reserve(size);
  for (std::size_t i = 0; i < size; ++i) {
    table.costs.push_back(cost_of(tuple));
    for (std::size_t j = tuple.size(); j-- > 0;) {
      if (++tuple[j] < network.labels(table.scope[j])) break;
      tuple[j] = 0;
    }
  }
  return true;
}

}  // namespace

std::optional<std::vector<Table>> Network::written_out(std::size_t most) const {
  std::vector<Table> tables;
  const auto place = [](const std::vector<int>& scope, int v) {
    return static_cast<std::size_t>(std::lower_bound(scope.begin(), scope.end(), v) - scope.begin());
  };
  for (const BinaryFunction& f : binary_) tables.push_back({{f.x, f.y}, tables_[static_cast<std::size_t>(f.table)]});
  for (const RequirementFunction& f : requirements_) {
    Table table{{f.x}, {}};
    for (const auto& member : f.members) table.scope.push_back(member.variable);
    std::sort(table.scope.begin(), table.scope.end());
    const bool fits = write_out(*this, table, most, [&](const std::vector<int>& tuple) {
      if (tuple[place(table.scope, f.x)] != f.label) return Cost{0};
      Cost least = f.weight;
      for (const auto& member : f.members)
        for (const auto& [label, cost] : member.supports)
          if (tuple[place(table.scope, member.variable)] == label) least = std::min(least, cost);
      return least;
    });
    if (!fits) return std::nullopt;
    tables.push_back(std::move(table));
  }
  for (const CardinalityFunction& f : cardinalities_) {
    Table table;
    if (f.x >= 0) table.scope.push_back(f.x);
    for (const auto& member : f.members) table.scope.push_back(member.variable);
    std::sort(table.scope.begin(), table.scope.end());
    const bool fits = write_out(*this, table, most, [&](const std::vector<int>& tuple) {
      if (f.x >= 0 && tuple[place(table.scope, f.x)] != f.label) return Cost{0};
      int count = 0;
      for (const auto& member : f.members)
        count += member.counts[static_cast<std::size_t>(tuple[place(table.scope, member.variable)])];
      return f.violation(count);
    });
    if (!fits) return std::nullopt;
    tables.push_back(std::move(table));
  }
  return tables;
}

}  // namespace scenelore::engine
