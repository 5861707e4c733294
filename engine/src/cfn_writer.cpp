#include <algorithm>
#include <cmath>
#include <iomanip>
#include <map>
#include <ostream>
#include <set>
#include <sstream>

#include "scenelore/engine/cfn.hpp"
#include "scenelore/engine/error.hpp"

namespace scenelore::engine {
namespace {

class CfnWriter {
 public:
  CfnWriter(const Problem& problem, std::ostream& out) : problem_(problem), out_(out) {
    out_ << std::fixed << std::setprecision(6);
  }

  void write() {
    name_variables();
    top_ = std::ceil(worst_total() + 1);
    std::ostringstream functions;
    functions << std::fixed << std::setprecision(6);
    body_ = &functions;
    for (std::size_t v = 0; v < problem_.variables().size(); ++v) unary(static_cast<int>(v));
    for (number_ = 0; number_ < static_cast<int>(problem_.constraints().size()); ++number_) {
      const ConstraintView constraint = problem_.constraints()[static_cast<std::size_t>(number_)];
      weight_ = constraint.weight;
      constraint.visit([this](const auto& body) { function(body); });
    }
    out_ << "{\"problem\":{\"name\":\"scenelore\",\"mustbe\":\"<" << top_ << "\"},\n\"variables\":{\n";
    for (std::size_t i = 0; i < declarations_.size(); ++i)
      out_ << declarations_[i] << (i + 1 < declarations_.size() ? ",\n" : "\n");
    out_ << "},\n\"functions\":{\n" << functions.str() << "\n}}\n";
  }

 private:
  static std::string quoted(const std::string& text) { return '"' + text + '"'; }

  /// toulbar2 ends a name at a space, so that only plain characters are written; unnamed or equally named variables are
  /// called x0, x1, …; the same for labels, with l.
  static std::vector<std::string> distinct(std::vector<std::string> names, char letter) {
    for (std::string& name : names)
      for (char& c : name) {
        const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' || c == '-';
        if (!plain) c = '_';
      }
    if (std::set<std::string>(names.begin(), names.end()).size() == names.size() &&
        std::none_of(names.begin(), names.end(), [](const std::string& n) { return n.empty() || n[0] == '-'; }))
      return names;
    for (std::size_t i = 0; i < names.size(); ++i) names[i] = letter + std::to_string(i);
    return names;
  }

  void name_variables() {
    std::vector<std::string> names;
    for (const Variable& variable : problem_.variables()) names.push_back(variable.name);
    names = distinct(names, 'x');
    for (std::size_t v = 0; v < names.size(); ++v) declare(names[v], distinct(problem_.variables()[v].labels, 'l'));
  }

  int declare(const std::string& name, const std::vector<std::string>& labels) {
    std::string text = quoted(name) + ":[";
    for (std::size_t l = 0; l < labels.size(); ++l) text += (l > 0 ? "," : "") + quoted(labels[l]);
    declarations_.push_back(text + "]");
    names_.push_back(quoted(name));
    sizes_.push_back(static_cast<int>(labels.size()));
    return static_cast<int>(names_.size()) - 1;
  }

  double worst_total() const {
    double sum = 0;
    const auto add_largest = [&sum](const std::vector<double>& costs, double factor) {
      double largest = 0;
      for (const double cost : costs)
        if (std::isfinite(cost)) largest = std::max(largest, cost);
      sum += factor * largest;
    };
    for (const Variable& variable : problem_.variables()) add_largest(variable.costs, 1);
    for (const ConstraintView constraint : problem_.constraints()) {
      const double weight = std::isfinite(constraint.weight) ? constraint.weight : 0;
      if (const auto* pair = constraint.as<PairTable>()) {
        add_largest(problem_.table(pair->table), weight);
      } else if (const auto* cardinality = constraint.as<Cardinality>()) {
        sum += weight * std::max<double>(static_cast<double>(cardinality->literals.size()), cardinality->low);
      } else {
        sum += weight;
        if (const auto* requirement = constraint.as<Requirement>())
          for (const Support& support : requirement->supports)
            if (std::isfinite(support.cost)) sum += support.cost;
      }
    }
    return sum;
  }

  double clipped(double cost) const { return std::isfinite(cost) ? cost : top_; }

  void open(const std::vector<int>& scope) {
    if (functions_++ > 0) *body_ << ",\n";
    *body_ << "\"f" << functions_ << "\":{\"scope\":[";
    for (std::size_t i = 0; i < scope.size(); ++i)
      *body_ << (i > 0 ? "," : "") << names_[static_cast<std::size_t>(scope[i])];
    *body_ << "],";
  }

  /// A function that lists all its costs, the last variable running fastest.
  void full(const std::vector<int>& scope, const std::vector<double>& costs) {
    open(scope);
    *body_ << "\"costs\":[";
    for (std::size_t i = 0; i < costs.size(); ++i) *body_ << (i > 0 ? "," : "") << clipped(costs[i]);
    *body_ << "]}";
  }

  /// A function that lists tuples of labels, each followed by its cost.
  void sparse(const std::vector<int>& scope, double other, const std::map<std::vector<int>, double>& costs) {
    open(scope);
    *body_ << "\"defaultcost\":" << clipped(other) << ",\"costs\":[";
    bool first = true;
    for (const auto& [tuple, cost] : costs) {
      for (const int label : tuple) {
        *body_ << (first ? "" : ",") << label;
        first = false;
      }
      *body_ << ',' << clipped(cost);
    }
    *body_ << "]}";
  }

  void unary(int v) { full({v}, problem_.variables()[static_cast<std::size_t>(v)].costs); }

  void function(const Conflict& conflict) {
    if (conflict.a.variable != conflict.b.variable)
      sparse({conflict.a.variable, conflict.b.variable}, 0, {{{conflict.a.label, conflict.b.label}, weight_}});
    else if (conflict.a == conflict.b)
      sparse({conflict.a.variable}, 0, {{{conflict.a.label}, weight_}});
  }

  void function(const PairTable& pair) {
    std::vector<double> costs = problem_.table(pair.table);
    for (double& cost : costs)
      if (cost > 0) cost = cost * weight_;
    full({pair.a, pair.b}, costs);
  }

  void function(const Requirement& requirement) {
    const Literal& owner = requirement.literal;
    double weight = weight_;
    std::map<Literal, double> supports;
    for (const Support& support : requirement.supports) {
      if (support.literal == owner) weight = std::min(weight, support.cost);
      if (support.literal.variable == owner.variable) continue;
      const auto entry = supports.try_emplace(support.literal, support.cost).first;
      entry->second = std::min(entry->second, support.cost);
    }
    std::vector<std::string> labels{"none"};
    for (const auto& [literal, cost] : supports)
      labels.push_back("s" + std::to_string(literal.variable) + "_" + std::to_string(literal.label));
    const int supporter = declare("supporter" + std::to_string(number_), labels);
    std::map<std::vector<int>, double> costs;
    for (int l = 0; l < sizes_[static_cast<std::size_t>(owner.variable)]; ++l) {
      int s = 0;
      costs[{l, s}] = l == owner.label ? weight : 0;
      for (const auto& [literal, cost] : supports) costs[{l, ++s}] = l == owner.label ? cost : kHard;
    }
    sparse({owner.variable, supporter}, 0, costs);
    int s = 0;
    for (const auto& [literal, cost] : supports) {
      std::map<std::vector<int>, double> absent;
      ++s;
      for (int l = 0; l < sizes_[static_cast<std::size_t>(literal.variable)]; ++l)
        if (l != literal.label) absent[{s, l}] = kHard;
      sparse({supporter, literal.variable}, 0, absent);
    }
  }

  /// With the decimals of the file, so that twice the weight is twice what the file says.
  static double rounded(double weight) { return std::isfinite(weight) ? std::round(weight * 1e6) / 1e6 : weight; }

  /// A chain of counters: count_i = count_{i−1} + whether variable i has one of the literals.
  void function(const Cardinality& cardinality) {
    std::map<int, std::set<int>> members;
    for (const Literal& literal : cardinality.literals) members[literal.variable].insert(literal.label);
    const int count = static_cast<int>(members.size());
    int before = -1, reached = 0, i = 0;
    for (const auto& [variable, counted] : members) {
      std::vector<std::string> labels;
      ++reached;
      for (int n = 0; n <= reached; ++n) labels.push_back("n" + std::to_string(n));
      const int counter = declare("count" + std::to_string(number_) + "_" + std::to_string(i++), labels);
      std::map<std::vector<int>, double> steps;
      for (int l = 0; l < sizes_[static_cast<std::size_t>(variable)]; ++l) {
        const int one = counted.contains(l) ? 1 : 0;
        for (int n = 0; n < reached; ++n) {
          if (before < 0)
            steps[{l, one}] = 0;
          else
            steps[{n, l, n + one}] = 0;
        }
      }
      if (before < 0)
        sparse({variable, counter}, kHard, steps);
      else
        sparse({before, variable, counter}, kHard, steps);
      before = counter;
    }
    price(cardinality, before, count);
  }

  void price(const Cardinality& cardinality, int counter, int count) {
    std::map<std::vector<int>, double> costs;
    for (int n = 0; n <= count; ++n) {
      const double off =
          std::max({0.0, static_cast<double>(cardinality.low) - n, n - static_cast<double>(cardinality.high)});
      const double cost = off > 0 ? rounded(weight_) * off : 0;
      std::vector<int> tuple;
      if (cardinality.condition) tuple.push_back(cardinality.condition->label);
      if (counter >= 0) tuple.push_back(n);
      if (cost > 0) costs[tuple] = cost;
    }
    std::vector<int> scope;
    if (cardinality.condition) scope.push_back(cardinality.condition->variable);
    if (counter >= 0) scope.push_back(counter);
    if (!scope.empty()) return sparse(scope, 0, costs);
    const double cost = costs.empty() ? 0 : costs.begin()->second;
    if (cost > 0) sparse({declare("constant" + std::to_string(number_), {"only"})}, 0, {{{0}, cost}});
  }

  const Problem& problem_;
  std::ostream& out_;
  std::ostream* body_ = nullptr;
  std::vector<std::string> declarations_, names_;
  std::vector<int> sizes_;
  int number_ = 0, functions_ = 0;
  double weight_ = 0, top_ = 0;
};

}  // namespace

void write_cfn(const Problem& problem, std::ostream& out) { CfnWriter(problem, out).write(); }

}  // namespace scenelore::engine
