// Variables are summed out one after the other, the one that needs the smallest table first. The marginals are the
// derivatives of the logarithm of the total with respect to the label weights (Darwiche, "A differential approach to
// inference in Bayesian networks", JACM 2003), found by going back over the same tables. Each table is used exactly
// once, so each may be rescaled freely; the marginals of a variable are normalised at the end.
#include "elimination.hpp"

#include <algorithm>
#include <cmath>

namespace scenelore::engine {
namespace {

struct Weights {
  std::vector<int> scope;  ///< ascending
  std::vector<double> value, slope;
};

struct Step {
  int variable = -1;
  std::vector<int> scope;           ///< of the product, ascending
  std::vector<std::size_t> inputs;  ///< tables that are multiplied
  std::size_t output = 0;           ///< the table that results
};

void rescale(std::vector<double>& values) {
  const double most = *std::max_element(values.begin(), values.end());
  if (most > 0)
    for (double& value : values) value /= most;
}

class Elimination {
 public:
  Elimination(const Network& network, const Scale& scale, std::size_t most) : network_(network), most_(most) {
    for (int v = 0; v < network.variables(); ++v) {
      Weights& weights = tables_.emplace_back();
      weights.scope = {v};
      for (int label = 0; label < network.labels(v); ++label)
        weights.value.push_back(std::exp(-scale.real(network.original(v, label))));
      rescale(weights.value);
    }
  }

  bool add(const std::vector<Table>& functions, const Scale& scale) {
    for (const Table& function : functions) {
      if (function.costs.size() > most_) return false;
      Weights& weights = tables_.emplace_back();
      weights.scope = function.scope;
      for (const Cost cost : function.costs) weights.value.push_back(std::exp(-scale.real(cost)));
    }
    for (std::size_t t = 0; t < tables_.size(); ++t) open_.push_back(t);
    return true;
  }

  bool forward() {
    std::vector<int> left;
    for (int v = 0; v < network_.variables(); ++v) left.push_back(v);
    while (!left.empty()) {
      Step best;
      double best_size = 0;
      for (const int v : left) {
        Step step = plan(v);
        const double size = size_of(step.scope);
        if (best.variable < 0 || size < best_size) best = std::move(step), best_size = size;
      }
      if (best_size > static_cast<double>(most_)) return false;
      sum_out(best);
      left.erase(std::find(left.begin(), left.end(), best.variable));
    }
    return true;
  }

  std::optional<std::vector<std::vector<double>>> marginals() {
    for (Weights& table : tables_) table.slope.assign(table.value.size(), 0.0);
    for (const std::size_t t : open_) {
      if (!(tables_[t].value[0] > 0)) return std::nullopt;
      tables_[t].slope[0] = 1;
    }
    for (auto step = steps_.rbegin(); step != steps_.rend(); ++step) go_back(*step);
    std::vector<std::vector<double>> result;
    for (int v = 0; v < network_.variables(); ++v) {
      const Weights& own = tables_[static_cast<std::size_t>(v)];
      double sum = 0;
      auto& row = result.emplace_back();
      for (std::size_t l = 0; l < own.value.size(); ++l) sum += row.emplace_back(own.value[l] * own.slope[l]);
      if (!(sum > 0)) return std::nullopt;
      for (double& p : row) p /= sum;
    }
    return result;
  }

 private:
  Step plan(int v) const {
    Step step;
    step.variable = v;
    for (const std::size_t t : open_) {
      const auto& scope = tables_[t].scope;
      if (!std::binary_search(scope.begin(), scope.end(), v)) continue;
      step.inputs.push_back(t);
      std::vector<int> both;
      std::set_union(scope.begin(), scope.end(), step.scope.begin(), step.scope.end(), std::back_inserter(both));
      step.scope = std::move(both);
    }
    return step;
  }

  double size_of(const std::vector<int>& scope) const {
    double size = 1;
    for (const int v : scope) size *= network_.labels(v);
    return size;
  }

  /// Visits all tuples of `scope` with the place of each tuple in each of `tables`.
  void for_each(const std::vector<int>& scope, const std::vector<std::size_t>& tables, const auto& visit) const {
    std::vector<std::vector<std::size_t>> strides(tables.size(), std::vector<std::size_t>(scope.size(), 0));
    for (std::size_t t = 0; t < tables.size(); ++t) {
      std::size_t stride = 1;
      const auto& own = tables_[tables[t]].scope;
      for (std::size_t i = own.size(); i-- > 0;) {
        strides[t][static_cast<std::size_t>(std::lower_bound(scope.begin(), scope.end(), own[i]) - scope.begin())] =
            stride;
        stride *= static_cast<std::size_t>(network_.labels(own[i]));
      }
    }
    std::vector<int> tuple(scope.size(), 0);
    std::vector<std::size_t> places(tables.size(), 0);
    for (;;) {
      visit(places);
      std::size_t j = scope.size();
      while (j-- > 0) {
        if (++tuple[j] < network_.labels(scope[j])) {
          for (std::size_t t = 0; t < tables.size(); ++t) places[t] += strides[t][j];
          break;
        }
        for (std::size_t t = 0; t < tables.size(); ++t)
          places[t] -= strides[t][j] * static_cast<std::size_t>(tuple[j] - 1);
        tuple[j] = 0;
      }
      if (j == static_cast<std::size_t>(-1)) return;
    }
  }

  void sum_out(Step step) {
    Weights result;
    for (const int v : step.scope)
      if (v != step.variable) result.scope.push_back(v);
    result.value.assign(static_cast<std::size_t>(size_of(result.scope)), 0.0);
    step.output = tables_.size();
    tables_.push_back(std::move(result));
    auto visited = step.inputs;
    visited.push_back(step.output);
    for_each(step.scope, visited, [&](const std::vector<std::size_t>& places) {
      double product = 1;
      for (std::size_t i = 0; i < step.inputs.size(); ++i) product *= tables_[step.inputs[i]].value[places[i]];
      tables_[step.output].value[places.back()] += product;
    });
    rescale(tables_[step.output].value);
    std::erase_if(open_, [&](std::size_t t) {
      return std::find(step.inputs.begin(), step.inputs.end(), t) != step.inputs.end();
    });
    open_.push_back(step.output);
    steps_.push_back(std::move(step));
  }

  /// slope of an input = sum of (slope of the output · product of the other inputs).
  void go_back(const Step& step) {
    auto visited = step.inputs;
    visited.push_back(step.output);
    rescale(tables_[step.output].slope);
    std::vector<double> before(step.inputs.size());
    for_each(step.scope, visited, [&](const std::vector<std::size_t>& places) {
      double product = tables_[step.output].slope[places.back()];
      if (!(product > 0)) return;
      for (std::size_t i = 0; i < step.inputs.size(); ++i) {
        before[i] = product;
        product *= tables_[step.inputs[i]].value[places[i]];
      }
      double after = 1;
      for (std::size_t i = step.inputs.size(); i-- > 0;) {
        tables_[step.inputs[i]].slope[places[i]] += before[i] * after;
        after *= tables_[step.inputs[i]].value[places[i]];
      }
    });
  }

  const Network& network_;
  std::size_t most_;
  std::vector<Weights> tables_;  ///< table v < variables() holds the label weights of v
  std::vector<std::size_t> open_;
  std::vector<Step> steps_;
};

}  // namespace

std::optional<std::vector<std::vector<double>>> eliminate(const Network& network, const Scale& scale,
                                                          std::size_t most) {
  const auto functions = network.written_out(most);
  if (!functions) return std::nullopt;
  Elimination elimination(network, scale, most);
  if (!elimination.add(*functions, scale) || !elimination.forward()) return std::nullopt;
  return elimination.marginals();
}

}  // namespace scenelore::engine
